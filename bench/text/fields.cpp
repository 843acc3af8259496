// SPDX-License-Identifier: MIT
#include "bench/text/fields.h"

#include <algorithm>

namespace spherepair {
namespace {

constexpr std::string_view blanks = " \t";

// The end of a field from `start` on: at one of `separators` outside double quotes.
size_t end_of_field(std::string_view text, size_t start, std::string_view separators) {
  if (start < text.size() && text[start] == '"') start = std::min(text.find('"', start + 1), text.size());
  return std::min(text.find_first_of(separators, start), text.size());
}

std::string_view unquoted(std::string_view field) {
  const bool quoted = field.size() > 1 && field.starts_with('"') && field.ends_with('"');
  return quoted ? field.substr(1, field.size() - 2) : field;
}

size_t skipped_blanks(std::string_view text, size_t start, std::string_view skipped) {
  return std::min(text.find_first_not_of(skipped, start), text.size());
}

// The index of the first of these characters outside double quotes.
size_t find_unquoted(std::string_view text, std::string_view wanted) {
  bool quoted = false;
  for (size_t k = 0; k < text.size(); ++k) {
    quoted ^= text[k] == '"';
    if (!quoted && wanted.find(text[k]) != wanted.npos) return k;
  }
  return text.npos;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(skipped_blanks(text, 0, blanks));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return lower;
}

void split_fields(std::string_view text, size_t most, std::vector<std::string_view>& fields) {
  fields.clear();
  for (size_t start = 0; fields.size() < most;) {
    while (start < text.size() && (text[start] == ' ' || text[start] == '\t')) ++start;
    if (start == text.size()) return;
    size_t end = start + 1;
    while (end < text.size() && text[end] != ' ' && text[end] != '\t') ++end;
    fields.push_back(text.substr(start, end - start));
    start = end;
  }
}

std::vector<std::string> words_in(std::string_view text) {
  std::vector<std::string_view> fields;
  split_fields(text, text.npos, fields);
  return {fields.begin(), fields.end()};
}

char separator_of(std::string_view line, bool decimal_comma) {
  if (find_unquoted(line, ";") != line.npos) return ';';
  return !decimal_comma && find_unquoted(line, ",") != line.npos ? ',' : ' ';
}

void split_line(std::string_view text, char separator, std::vector<std::string_view>& fields) {
  if (separator == ' ' && text.find('"') == text.npos) return split_fields(text, text.npos, fields);
  fields.clear();
  const bool at_blanks = separator == ' ';
  const std::string_view separators = at_blanks ? blanks : std::string_view(&separator, 1);
  const std::string_view skipped = separator == '\t' ? blanks.substr(0, 1) : blanks;
  for (size_t start = skipped_blanks(text, 0, skipped); at_blanks ? start < text.size() : start <= text.size();) {
    const size_t end = end_of_field(text, start, separators);
    fields.push_back(unquoted(trimmed(text.substr(start, end - start))));
    if (end == text.size()) return;
    start = skipped_blanks(text, end + 1, skipped);
  }
}

std::string_view without_comment(std::string_view line) {
  const size_t mark = line.find('#');
  if (mark == line.npos || line.find('"') > mark) return line.substr(0, mark);
  return line.substr(0, find_unquoted(line, "#"));
}

std::vector<std::string> names_in(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  split_line(line, separator, fields);
  std::vector<std::string> names;
  for (const std::string_view field : fields) {
    const bool opened = !names.empty() && names.back().find_first_of("[(") != std::string::npos &&
                        names.back().find_first_of("])") == std::string::npos;
    const bool unit = !field.empty() && (field.front() == '[' || field.front() == '(');
    if (separator == ' ' && !names.empty() && (opened || unit))
      names.back().append(" ").append(field);
    else
      names.emplace_back(field);
  }
  return names;
}

}  // namespace spherepair
