// SPDX-License-Identifier: MIT
// Numbers as text, wherever they stand: options, names of scenes, files. One that is not within its range is refused;
// none wraps.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

namespace spherepair {

constexpr uint64_t kMostSpheres = std::numeric_limits<int32_t>::max();

// Nothing unless the text is a number and nothing else, and within the range.
std::optional<uint64_t> whole_number_of(std::string_view text, uint64_t low, uint64_t high);
std::optional<double> real_number_of(std::string_view text, double low, double high);

// Two whole numbers with a mark between them: 1280x720, 2/4.
using TwoNumbers = std::array<uint64_t, 2>;
std::optional<TwoNumbers> two_numbers_of(std::string_view text, char mark, uint64_t high);  // each from 1 on

}  // namespace spherepair
