// SPDX-License-Identifier: MIT
#include "bench/spheres/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "bench/spheres/sphere_file.h"

namespace spherepair {
namespace {

constexpr std::string_view blanks = " \t";

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

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

}  // namespace

size_t Columns::quantities() const {
  return size_t(std::ranges::count_if(columns, [](const auto& column) { return column.has_value(); }));
}

Columns columns_of_names(const std::string& where, std::span<const std::string> names) {
  const auto fail = [&](const std::string& why) { throw std::invalid_argument(where + ": " + why); };
  Columns columns{.count = names.size(), .text = fmt::format("{}", fmt::join(names, " "))};
  for (size_t k = 0; k < names.size(); ++k) {
    const auto name = std::ranges::find(quantity_names, names[k]);
    if (name == quantity_names.end()) continue;
    auto& column = columns.columns[size_t(name - quantity_names.begin())];
    if (column) fail(fmt::format("the column {} stands twice", names[k]));
    column = k;
  }
  if (!columns.has(QUANTITY_X) || !columns.has(QUANTITY_Y) || !columns.has(QUANTITY_Z))
    fail(fmt::format("the columns x, y and z must be among '{}'", columns.text));
  if (columns.has(QUANTITY_VX) != columns.has(QUANTITY_VY) || columns.has(QUANTITY_VX) != columns.has(QUANTITY_VZ))
    fail(fmt::format("of the columns vx, vy and vz only some are among '{}'", columns.text));
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

void split_separated_fields(std::string_view text, size_t most, std::vector<std::string_view>& fields) {
  const size_t semicolon = text.find(';'), first = semicolon == text.npos ? text.find(',') : semicolon;
  if (first == text.npos) return split_fields(text, most, fields);
  fields.clear();
  const char separator = text[first];
  for (bool more = true; more && fields.size() < most;) {
    const size_t end = text.find(separator);
    fields.push_back(trimmed(text.substr(0, end)));
    more = end != text.npos;
    if (more) text.remove_prefix(end + 1);
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

Decimal read_number(const FileBytes& file, uint64_t line, std::span<const std::string_view> fields,
                    const Columns& columns, Quantity quantity) {
  const size_t column = *columns.columns[quantity];
  const char* name = quantity_names[quantity];
  const std::string_view text = fields[column];
  const auto decimal = parse_decimal(text);
  const char* point = text.find(',') == text.npos ? "" : ", with a decimal point";
  if (!decimal)
    file.fail_at_line(line, fmt::format("a number for {} in column {}{}", name, column + 1, point), in_quotes(text));
  const char* expected = why_invalid(decimal->value, quantity == QUANTITY_RADIUS);
  if (expected) file.fail_at_line(line, fmt::format("{} for {}", expected, name), in_quotes(text));
  return *decimal;
}

}  // namespace spherepair
