// SPDX-License-Identifier: MIT
// Counts how often a predicate is right: adversarial pairs go through it and through the oracle.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "common/shared/exact.h"
#include "tests/oracle/adversarial.h"

namespace spherepair {

// Decides spheres[2k] against spheres[2k + 1] for every k; returns verdict_code()s.
using Decider = std::function<std::vector<uint>(std::span<const vec4> spheres)>;

struct Tally {
  uint64_t pairs = 0, ties = 0, overlapping = 0, nonfinite = 0, wrong = 0;
  std::array<uint64_t, STAGES> by_stage{};
  std::string first_wrong;
};
Tally tally(Family family, uint64_t pairs, const Decider& decide);

// K = 1 + 24 * 2^-24 and T = 2^-100 of the filter, as numerics fixes them.
constexpr uint FILTER_SCALE_BITS = 0x3F80000Cu, FILTER_OFFSET_BITS = 0x0D800000u;
std::vector<uint> decide_directly(std::span<const vec4> spheres);  // decide_pair, on all cores
Decider decider_of(bool (*collide)(vec4 a, vec4 b));

// The number of pairs of each family that a backend decides: over 10^7 in all, at least a tenth of them exactly
// tangent.
struct FamilyPairs {
  Family family;
  uint64_t pairs;
};
constexpr std::array<FamilyPairs, 8> PLANS = {{{Family::random_bits, 10'000'000},
                                               {Family::near_tangent, 10'000'000},
                                               {Family::quadruple, 4'000'000},
                                               {Family::quadruple_off, 2'000'000},
                                               {Family::denormal, 1'000'000},
                                               {Family::extreme, 1'000'000},
                                               {Family::axis_offset, 1'000'000},
                                               {Family::nonfinite, NONFINITE_CASES}}};

// A pair with all its bits, for messages.
std::string show_pair(const vec4& a, const vec4& b);

}  // namespace spherepair
