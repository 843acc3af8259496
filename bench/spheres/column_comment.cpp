// SPDX-License-Identifier: MIT
#include "bench/spheres/column_comment.h"

#include <algorithm>
#include <array>
#include <span>

#include "bench/spheres/columns.h"
#include "bench/text/fields.h"

namespace spherepair {
namespace {

// Words of prose: a comment with one of these lists no names.
constexpr std::array<std::string_view, 19> prose = {
    "and",    "of",      "each",   "the",     "is",          "are",        "with",    "from",   "for",   "all",
    "centre", "centres", "center", "centers", "coordinates", "coordinate", "columns", "column", "fields"};
// Columns that are not quantities, but whose place among x, y and z counts.
constexpr std::array<std::string_view, 14> table_words = {"id",      "ids",     "index",    "nr",       "type",
                                                          "types",   "species", "element",  "elements", "mass",
                                                          "density", "charge",  "diameter", "diameters"};

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Removes the numbers of `1:id 2:x`, `1=id` or `1: id`.
std::string without_numbers(std::string_view text) {
  std::string left;
  for (size_t k = 0; k < text.size(); ++k) {
    const bool starts = k == 0 || is_blank(text[k - 1]) || std::string_view(",;[(").find(text[k - 1]) != text.npos;
    size_t end = k;
    while (starts && end < text.size() && is_digit(text[end])) ++end;
    const bool number = end > k && end < text.size() && (text[end] == ':' || text[end] == '=');
    if (number)
      for (k = end; k + 1 < text.size() && is_blank(text[k + 1]);) ++k;
    else
      left += text[k];
  }
  return left;
}

// Calls work with the index of each character outside brackets and double quotes.
template <typename Work>
void for_outside(std::string_view text, Work work) {
  size_t depth = 0;
  bool quoted = false;
  for (size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '"') quoted = !quoted;
    const bool close = !quoted && (c == ']' || c == ')') && depth > 0;
    if (!quoted && (c == '[' || c == '(')) ++depth;
    if (depth == 0 && !quoted) work(k);
    depth -= close;
  }
}

// Removes `columns:` or `columns =` before the text, and brackets around all of it.
std::string_view without_label(std::string_view text) {
  size_t label = text.npos;
  for_outside(text, [&](size_t k) {
    if ((text[k] == ':' || text[k] == '=') &&
        (k + 1 == text.size() || is_blank(text[k + 1]) || text[k + 1] == '[' || text[k + 1] == '('))
      label = k;
  });
  if (label != text.npos) text = trimmed(text.substr(label + 1));
  bool outside = false;
  for_outside(text, [&](size_t) { outside = true; });
  if (!outside && text.size() > 1 && (text.ends_with(']') || text.ends_with(')')))
    text = trimmed(text.substr(1, text.size() - 2));
  return text;
}

// Splits a list of names. Separators in brackets do not count: `x [mm] y [mm]` has two names.
std::vector<std::string> split_names(std::string_view text, char separator) {
  std::vector<size_t> cuts;
  for_outside(text, [&](size_t k) {
    if (text[k] == separator || (separator == ' ' && is_blank(text[k]))) cuts.push_back(k);
  });
  cuts.push_back(text.size());
  std::vector<std::string> names;
  size_t start = 0;
  for (const size_t cut : cuts) {
    std::string_view name = trimmed(text.substr(start, cut - start));
    if (name.size() > 1 && name.starts_with('"') && name.ends_with('"')) name = name.substr(1, name.size() - 2);
    start = cut + 1;
    if (separator == ' ' && name.empty()) continue;
    if (separator == ' ' && !names.empty() && (name[0] == '[' || name[0] == '('))
      names.back().append(" ").append(name);
    else
      names.emplace_back(name);
  }
  return names;
}

// The name without a unit in brackets.
std::string base_of(std::string_view name) { return lower_case(trimmed(name.substr(0, name.find_first_of("[(")))); }

bool holds_xyz(std::span<const std::string> words) {
  return std::ranges::all_of(std::span(quantity_names).first(3), [&](std::string_view axis) {
    return std::ranges::any_of(words, [&](const std::string& word) { return base_of(word) == axis; });
  });
}

bool is_plain(const std::string& name, char separator) {
  const std::string base = base_of(name);
  const KnownName* known = known_name(base);
  const bool one_word = separator != ' ' || (!base.empty() && base.find_first_of(",;=\"") == base.npos);
  return one_word && !std::ranges::count(prose, base) && !parse_decimal(base) && (!known || known->count == 1);
}

// Whether three names after another one differ in one character: px py pz, Points:0 ...
bool has_other_axes(std::span<const std::string> names) {
  for (size_t k = 1; k + 2 < names.size(); ++k) {
    const std::string a = base_of(names[k]), b = base_of(names[k + 1]), c = base_of(names[k + 2]);
    if (known_name(a) || a.size() != b.size() || a.size() != c.size()) continue;
    for (const std::string_view axes : {"xyz", "012", "123"})
      for (size_t at = 0; at < a.size(); ++at) {
        std::string second = a, third = a;
        second[at] = axes[1], third[at] = axes[2];
        if (a[at] == axes[0] && b == second && c == third) return true;
      }
  }
  return false;
}

// Names of quantities and other words of tables, in the order of their first occurrence.
std::vector<std::string> order_of(std::string_view text, std::span<const std::string> names, char separator) {
  std::string spaced = lower_case(text);
  std::ranges::replace_if(
      spaced, [](char c) { return std::string_view("\t,;[](){}\"'").find(c) != std::string_view::npos; }, ' ');
  std::vector<std::string> words = split_names(spaced, ' '), order;
  for (std::string& word : words) word = word.substr(0, word.find_last_not_of(".:=") + 1);
  const auto beside = [&](const char* word) { return std::ranges::count(words, word) > 0; };
  if (!beside("x") || !beside("y") || !beside("z")) return {};
  const bool colours = beside("g") && beside("b");
  if (separator != ' ' && holds_xyz(names) && names.front().find_first_of(" \t") == std::string::npos &&
      !known_name(names.front()) && !std::ranges::count(prose, base_of(names.front())))
    order.push_back(names.front());
  for (const std::string& word : words) {
    const KnownName* known = known_name(word);
    const bool other = std::ranges::count(table_words, word) > 0 || (known && word == "r" && colours);
    if (!other && (!known || known->count > 1)) continue;
    const std::string quantity = other ? word : quantity_names[known->first];
    if (!std::ranges::count(order, quantity)) order.push_back(quantity);
  }
  return order;
}

}  // namespace

bool ColumnComment::agrees_with_order(size_t count) const {
  const size_t compared = std::min({count, order.size(), quantity_names.size()});
  return std::ranges::equal(std::span(order).first(compared), std::span(quantity_names).first(compared));
}

ColumnComment column_comment(std::string_view text) {
  const std::string numberless = without_numbers(trimmed(text));
  const std::string_view list = without_label(numberless);
  char separator = ' ';
  for (const char each : {'\t', ',', ';'})
    for_outside(list, [&](size_t k) {
      if (list[k] == each) separator = each;
    });
  std::vector<std::string> names = split_names(list, separator);
  if (separator == '\t' && !holds_xyz(names)) names = split_names(list, separator = ' ');
  if (separator == ',' && !holds_xyz(names) && list.find(", ") == list.npos && holds_xyz(split_names(list, ' ')))
    names = split_names(list, separator = ' ');
  ColumnComment comment{.order = order_of(numberless, names, separator)};
  if (!std::ranges::all_of(names, [&](const std::string& name) { return is_plain(name, separator); })) return comment;
  comment.xyz = holds_xyz(names);
  comment.other_axes = !comment.xyz && has_other_axes(names);
  for (const std::string& name : names) comment.names.push_back({name});
  return comment;
}

}  // namespace spherepair
