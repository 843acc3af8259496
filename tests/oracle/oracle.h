// SPDX-License-Identifier: MIT
// Computes the exact answer independently of the program: it splits floats into their bits and compares GMP integers.
// Nothing here shares code with exact.h.
#pragma once

#include <span>
#include <vector>

#include "common/scene/pair_set.h"

namespace spherepair {

enum class Relation { nonfinite, apart, tangent, overlapping };

Relation relation(const vec4& a, const vec4& b);

// Relates spheres[2k] to spheres[2k + 1] for every k, on all cores.
std::vector<Relation> relations(std::span<const vec4> spheres);

// The colliding pairs in canonical order: every pair decided by relation().
std::vector<Pair> brute_force_pairs(std::span<const vec4> spheres);

// The same set for large scenes: only pairs whose bounding boxes, a little enlarged, intersect go to relation().
std::vector<Pair> swept_pairs(std::span<const vec4> spheres);

// The pairs whose spheres share a group of `block` consecutive indices.
std::vector<Pair> within_groups(std::span<const Pair> pairs, uint block);

}  // namespace spherepair
