// SPDX-License-Identifier: MIT
#include "bench/spheres/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "bench/spheres/sphere_file.h"
#include "bench/spheres/sphere_rows.h"

namespace spherepair {
namespace {

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

std::optional<Decimal> parse_decimal(std::string_view text, bool decimal_comma) {
  std::string plain;  // with a decimal point and the exponent's letter e
  if (text.find_first_of(decimal_comma ? "dD,." : "dD") != text.npos) {
    if (decimal_comma && text.find('.') != text.npos) return std::nullopt;
    plain = text;
    if (decimal_comma) std::ranges::replace(plain, ',', '.');
    const size_t mark = plain.find_first_of("dD");
    if (mark != plain.npos && mark > 0 &&
        (plain[mark - 1] == '.' || (plain[mark - 1] >= '0' && plain[mark - 1] <= '9')))
      plain[mark] = 'e';
    text = plain;
  }
  if (text.starts_with('+') && text.size() > 1 && text[1] != '-') text.remove_prefix(1);
  Decimal decimal{0, 0, false};
  if (!parse_real(text, decimal.value) || !parse_real(text, decimal.rounded)) return std::nullopt;
  const double off = std::abs(double(decimal.rounded) - decimal.value);
  const bool vanished =
      decimal.value == 0 && text.substr(0, text.find_first_of("eE")).find_first_of("123456789") != text.npos;
  decimal.changed = vanished || (off > 0 && off > 1.00001 * half_unit(text));  // float64 may round a tie just above it
  return decimal;
}

Decimal halved(const Decimal& diameter) {
  const float half = diameter.rounded / 2;  // exact but for denormals
  return {diameter.value / 2, half, diameter.changed || 2 * half != diameter.rounded};
}

void RowReader::read(uint64_t line, std::string_view text, std::span<const std::string_view> fields, uint64_t sphere,
                     SphereRows& rows) {
  const size_t count = columns_.count;
  if (fields.size() != count)
    file_.fail_at_line(line, fmt::format("{} columns ({}), {}", count, columns_.text, columns_.by),
                       fmt::format("{}{}: {}", fields.size() > count ? "more than " : "",
                                   std::min(fields.size(), count), in_quotes(text)));
  for (size_t quantity = 0; quantity < quantity_names.size(); ++quantity) {
    if (!columns_.has(Quantity(quantity))) continue;
    Decimal decimal = number(line, fields[*columns_.columns[quantity]], Quantity(quantity));
    if (quantity == QUANTITY_RADIUS && columns_.diameters) decimal = halved(decimal);
    changed_ += decimal.changed;
    rows.set(sphere, Quantity(quantity), decimal);
  }
  if (!rows.species.empty() && columns_.species) rows.species[sphere] = fields[*columns_.species];
}

Decimal RowReader::number(uint64_t line, std::string_view field, Quantity quantity) const {
  const bool diameter = quantity == QUANTITY_RADIUS && columns_.diameters;
  const char* name = diameter ? "diameter" : quantity_names[quantity];
  const auto decimal = parse_decimal(field, decimal_comma_);
  if (!decimal) {
    const char* mark = decimal_comma_                  ? ", with a decimal comma and no point"
                       : field.find(',') == field.npos ? ""
                                                       : ", with a decimal point (or give --decimal-comma)";
    file_.fail_at_line(line, fmt::format("a number for {} in column {}{}", name, *columns_.columns[quantity] + 1, mark),
                       in_quotes(field));
  }
  const char* expected = why_invalid(decimal->value, quantity == QUANTITY_RADIUS);
  if (expected) file_.fail_at_line(line, fmt::format("{} for {}", expected, name), in_quotes(field));
  return *decimal;
}

}  // namespace spherepair
