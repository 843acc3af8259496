// SPDX-License-Identifier: MIT
#include "bench/io/numbers.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace spherepair {
namespace {

template <typename Number>
std::optional<Number> parse_number(std::string_view text, Number low, Number high) {
  Number value = 0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc() || end != last || !(value >= low && value <= high)) return std::nullopt;
  return value;
}

}  // namespace

std::optional<uint64_t> whole_number_of(std::string_view text, uint64_t low, uint64_t high) {
  return parse_number(text, low, high);
}

std::optional<double> real_number_of(std::string_view text, double low, double high) {
  return parse_number(text, low, high);
}

std::optional<uint64_t> count_of(std::string_view text, uint64_t low, uint64_t high) {
  const size_t mark = text.find_first_of("eEkKMG");
  std::string digits(text.substr(0, mark));
  uint64_t zeros = 0;
  if (mark != text.npos) {
    const size_t power = std::string_view("kMG").find(text[mark] == 'K' ? 'k' : text[mark]);
    const std::string_view rest = text.substr(mark + 1);
    const auto exponent = power == text.npos ? whole_number_of(rest, 0, 18) : std::optional(3 * (power + 1));
    if (!exponent || (power != text.npos && !rest.empty())) return std::nullopt;
    zeros = *exponent;
  }
  const size_t point = digits.find('.');
  if (digits.size() > 1 && digits.front() == '0' && point != 1) return std::nullopt;
  if (point != digits.npos) {
    const size_t decimals = digits.size() - point - 1;
    if (point == 0 || decimals == 0 || decimals > zeros) return std::nullopt;
    digits.erase(point, 1);
    zeros -= decimals;
  }
  return digits.empty() ? std::nullopt : whole_number_of(digits.append(zeros, '0'), low, high);
}

std::optional<TwoNumbers> two_numbers_of(std::string_view text, char mark, uint64_t high) {
  const size_t at = text.find(mark);
  if (at == text.npos) return std::nullopt;
  const auto first = whole_number_of(text.substr(0, at), 1, high),
             second = whole_number_of(text.substr(at + 1), 1, high);
  if (!first || !second) return std::nullopt;
  return TwoNumbers{*first, *second};
}

}  // namespace spherepair
