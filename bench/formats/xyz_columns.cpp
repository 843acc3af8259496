// SPDX-License-Identifier: MIT
#include "bench/formats/xyz_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "bench/formats/sphere_file.h"
#include "bench/io/numbers.h"

namespace spherepair {
namespace {

constexpr std::string_view blanks = " \t";

// Reads up to `stop` or a blank; quotes and brackets around a value may hold both.
std::string_view take_word(std::string_view& text, std::string_view stop) {
  const std::string_view open = "\"'{[", close = "\"'}]";
  const size_t kind = text.empty() ? open.npos : open.find(text.front());
  const size_t end = kind == open.npos ? open.npos : text.find(close[kind], 1);
  const bool enclosed = end != text.npos;
  const size_t size = enclosed ? end + 1 : std::min(text.find_first_of(stop), text.size());
  const std::string_view word = enclosed ? text.substr(1, size - 2) : text.substr(0, size);
  text.remove_prefix(size);
  return word;
}

std::optional<std::string_view> value_of_key(std::string_view comment, std::string_view wanted) {
  while (true) {
    comment.remove_prefix(std::min(comment.find_first_not_of(blanks), comment.size()));
    if (comment.empty()) return std::nullopt;
    const std::string_view key = take_word(comment, "= \t");
    if (!comment.starts_with('=')) continue;
    comment.remove_prefix(1);
    const std::string_view value = take_word(comment, blanks);
    if (key == wanted) return value;
  }
}

std::vector<std::string> split_at_colons(std::string_view text) {
  std::vector<std::string> parts;
  std::istringstream stream{std::string(text)};
  for (std::string part; std::getline(stream, part, ':');) parts.push_back(part);
  return parts;
}

struct Property {
  std::string name, type;
  size_t columns = 0;
};

std::optional<Property> property_of(const std::string& name, const std::string& type, const std::string& columns) {
  const auto count = whole_number_of(columns, 1, 1000);
  if (name.empty() || !count || (type != "S" && type != "R" && type != "I" && type != "L")) return std::nullopt;
  return Property{name, type, *count};
}

// Half a unit of the last given digit: 0.005 for 1.25, 50 for 12e2.
double half_unit(std::string_view text) {
  const size_t mark = std::min(text.find_first_of("eE"), text.size()), point = text.substr(0, mark).find('.');
  double exponent = point == text.npos ? 0 : -double(mark - point - 1);
  if (mark < text.size()) exponent += double(std::atol(std::string(text.substr(mark + 1)).c_str()));
  return 0.5 * std::pow(10.0, exponent);
}

template <typename Real>
bool parse_real(std::string_view text, Real& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || end != text.data() + text.size()) return false;
  if (error == std::errc::result_out_of_range)  // from_chars leaves the value unchanged
    value = Real(std::is_same_v<Real, float> ? std::strtof(std::string(text).c_str(), nullptr)
                                             : std::strtod(std::string(text).c_str(), nullptr));
  return true;
}

}  // namespace

std::optional<XyzColumns> named_columns(const FileBytes& file, uint64_t line, std::string_view comment) {
  const auto value = value_of_key(comment, "Properties");
  if (!value) return std::nullopt;
  const std::vector<std::string> parts = split_at_colons(*value);
  const auto fail = [&](std::string_view expected) { file.fail_at_line(line, expected, in_quotes(*value)); };
  if (parts.empty() || parts.size() % 3) fail("Properties=name:type:columns, repeated, such as species:S:1:pos:R:3");
  XyzColumns columns{.named = true, .text = in_quotes(*value)};
  std::optional<size_t> position;
  for (size_t k = 0; k < parts.size(); k += 3) {
    const auto property = property_of(parts[k], parts[k + 1], parts[k + 2]);
    if (!property) fail("Properties with a name, a type S, R, I or L and a number of columns each");
    const bool number = property->type == "R" || property->type == "I";
    auto* found = property->name == "pos" ? &position : property->name == "radius" ? &columns.radius : nullptr;
    if (found && (*found || !number || property->columns != (found == &position ? 3 : 1)))
      fail("Properties with pos:R:3 once and radius:R:1 once at most");
    if (found) *found = columns.count;
    if (property->name == "species" && property->columns == 1 && !columns.species) columns.species = columns.count;
    columns.count += property->columns;
  }
  if (!position) fail("Properties with pos:R:3");
  columns.position = *position;
  return columns;
}

XyzColumns classic_columns(const FileBytes& file, uint64_t line, std::string_view text) {
  std::vector<std::string_view> fields;
  split_fields(text, 100, fields);
  const size_t species = fields.empty() || parse_decimal(fields[0]) ? 0 : 1;
  if (fields.size() < species + 3 || fields.size() > species + 4)
    file.fail_at_line(line,
                      species ? "4 columns, species x y z, or 5 with a radius; others need Properties= in line 2"
                              : "3 columns, x y z, or 4 with a radius; others need Properties= in line 2",
                      fmt::format("{}: {}", fields.size(), in_quotes(text)));
  XyzColumns columns{.count = fields.size(), .position = species, .text = species ? "species x y z" : "x y z"};
  if (species) columns.species = 0;
  if (fields.size() == species + 4) {
    columns.radius = species + 3;
    columns.text += " radius";
  }
  return columns;
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

std::optional<Decimal> parse_decimal(std::string_view text) {
  if (text.starts_with('+') && text.size() > 1 && text[1] != '-') text.remove_prefix(1);
  Decimal decimal{0, 0, false};
  if (!parse_real(text, decimal.value) || !parse_real(text, decimal.rounded)) return std::nullopt;
  const double off = std::abs(double(decimal.rounded) - decimal.value);
  const bool vanished =
      decimal.value == 0 && text.substr(0, text.find_first_of("eE")).find_first_of("123456789") != text.npos;
  decimal.changed = vanished || (off > 0 && off > 1.00001 * half_unit(text));  // float64 may round a tie just above it
  return decimal;
}

Decimal read_number(const FileBytes& file, uint64_t line, std::span<const std::string_view> fields, size_t column,
                    const char* name, bool is_radius) {
  const std::string_view text = fields[column];
  const auto decimal = parse_decimal(text);
  if (!decimal) file.fail_at_line(line, fmt::format("a number for {} in column {}", name, column + 1), in_quotes(text));
  const char* expected = why_invalid(decimal->value, is_radius);
  if (expected) file.fail_at_line(line, fmt::format("{} for {}", expected, name), in_quotes(text));
  return *decimal;
}

}  // namespace spherepair
