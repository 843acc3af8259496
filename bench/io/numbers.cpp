// SPDX-License-Identifier: MIT
#include "bench/io/numbers.h"

#include <algorithm>
#include <charconv>

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

std::optional<TwoNumbers> two_numbers_of(std::string_view text, char mark, uint64_t high) {
  const size_t at = text.find(mark);
  if (at == text.npos) return std::nullopt;
  const auto first = whole_number_of(text.substr(0, at), 1, high),
             second = whole_number_of(text.substr(at + 1), 1, high);
  if (!first || !second) return std::nullopt;
  return TwoNumbers{*first, *second};
}

}  // namespace spherepair
