// SPDX-License-Identifier: MIT
// Parses numbers in options, scene names and files. Values out of range are refused; none wraps.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

namespace spherepair {

constexpr uint64_t kMostSpheres = std::numeric_limits<int32_t>::max();

// Nothing unless the whole text is a number within the range.
std::optional<uint64_t> whole_number_of(std::string_view text, uint64_t low, uint64_t high);
std::optional<double> real_number_of(std::string_view text, double low, double high);

// A whole number as a user writes one: 16384, 16k, 1.5M, 1e6; k, M and G are 10^3, 10^6 and 10^9. No leading zeros.
std::optional<uint64_t> count_of(std::string_view text, uint64_t low, uint64_t high);

// Two whole numbers separated by a mark: 1280x720.
using TwoNumbers = std::array<uint64_t, 2>;
std::optional<TwoNumbers> two_numbers_of(std::string_view text, char mark, uint64_t high);  // each at least 1

}  // namespace spherepair
