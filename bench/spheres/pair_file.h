// SPDX-License-Identifier: MIT
// Writes colliding pairs and contact numbers, by the file's extension as NPY (C order) or text.
#pragma once

#include <array>
#include <span>
#include <string>

#include "bench/io/output_files.h"
#include "common/scene/pair_set.h"
#include "common/shared/layout.h"

namespace spherepair {

// Throws std::invalid_argument for an unknown extension of `option`'s file. Pipes and devices take text.
void check_pair_file(const std::string& option, const std::string& file);

// NPY: m x 2, uint32; text: lines `i j`. Replaces the file atomically.
void write_pairs(const std::string& file, std::span<const Pair> pairs);

// Of a pair: how far its spheres overlap, metres; the unit vector from the centre of `first` to that of `second` (zero
// if they coincide); and the point in the middle of the overlap, on the line of centres. In float64 from the float32
// spheres, whose centres are `shift` away from the points that are written. The overlap is positive for every pair that
// collides, with a relative error below 2^-50.
struct Contact {
  double overlap;
  std::array<double, 3> normal, point;
};
Contact contact_of(const Pair& pair, std::span<const vec4> spheres, const std::array<double, 3>& shift = {});

// NPY: a structured array of i, j (uint32), overlap, normal (3), point (3) (float64); text: lines of the same columns.
void write_contacts(const std::string& file, std::span<const Pair> pairs, std::span<const vec4> spheres,
                    const std::array<double, 3>& shift);

// The number of contacts of each sphere. NPY: n, uint32; text: a line each.
void write_contact_numbers(const std::string& file, std::span<const uint> counts);

}  // namespace spherepair
