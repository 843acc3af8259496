// SPDX-License-Identifier: MIT
#include "bench/check/exact_sets.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "api/open.h"
#include "bench/check/closed_form.h"
#include "bench/check/quad.h"

namespace spherepair {
namespace {

// Candidate pairs: the colliding pairs of positions rounded to float32, with radii enlarged by a bound of the rounding
// error. Half an ulp along three axes for both spheres is less than 4 * 2^-24 of the largest coordinate. Positions are
// relative to the first sphere, so that a scene far from the origin does not make every pair a candidate.
std::vector<Pair> candidates(const Scene& scene, const std::vector<QuadPoint>& positions) {
  Scene rounded = scene;
  float largest = 1;
  for (size_t i = 0; i < positions.size(); ++i) {
    vec4& at = rounded.positions[i];
    const auto along = [&](size_t axis) { return float(Quad(positions[i][axis] - positions[0][axis])); };
    at = {along(0), along(1), along(2), at.w};
    largest = std::max({largest, std::abs(at.x), std::abs(at.y), std::abs(at.z), at.w});
  }
  for (vec4& at : rounded.positions) at.w += 4 * 0x1p-24f * largest;
  const auto cpu = open_backend("cpu");
  cpu->upload(rounded);
  cpu->collide({.method = Method::collide_grid, .want_pairs = true});
  return cpu->pairs();
}

bool collide(const QuadPoint& a, const QuadPoint& b, const Quad& reach) {
  Quad square = 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    const Quad difference = a[axis] - b[axis];
    square += difference * difference;
  }
  return square < reach * reach;
}

std::vector<Pair> pairs_at(const Scene& scene, const std::vector<QuadPoint>& positions) {
  std::vector<Pair> pairs = candidates(scene, positions);
  std::vector<char> colliding(pairs.size());
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < pairs.size(); ++k) {
    const auto [i, j] = pairs[k];
    colliding[k] = collide(positions[i], positions[j], Quad(scene.positions[i].w) + Quad(scene.positions[j].w));
  }
  size_t kept = 0;
  for (size_t k = 0; k < pairs.size(); ++k)
    if (colliding[k]) pairs[kept++] = pairs[k];
  pairs.resize(kept);
  return pairs;
}

template <typename PositionOf>
std::vector<Pair> pairs_of(const Scene& scene, PositionOf position_of) {
  std::vector<QuadPoint> positions(scene.size());
#pragma omp parallel for schedule(static)
  for (uint64_t i = 0; i < scene.size(); ++i) positions[i] = position_of(i);
  return pairs_at(scene, positions);
}

Quad stored(double value, double moved, Precision precision) {
  const Quad exact = Quad(value) + Quad(moved);
  if (precision == Precision::float64) return Quad(double(exact));
  const float high = float(exact);
  return precision == Precision::float32 ? Quad(high) : Quad(high) + Quad(float(exact - high));
}

}  // namespace

std::vector<Pair> closed_form_pairs(const Scene& scene, uint64_t steps) {
  return pairs_of(scene, [&](uint64_t i) { return closed_form_position(scene, i, steps); });
}

std::vector<Pair> state_pairs(const Scene& scene, const Motion::State& state) {
  return pairs_of(scene, [&](uint64_t i) {
    const ExactState at = exact_state(state, scene.motion, i);
    return QuadPoint{Quad(at[0]), Quad(at[1]), Quad(at[2])};
  });
}

std::vector<Pair> stored_pairs(const Scene& scene, double distance, Precision precision) {
  return pairs_of(scene, [&](uint64_t i) {
    const vec4& at = scene.positions[i];
    return QuadPoint{stored(at.x, distance, precision), stored(at.y, distance, precision),
                     stored(at.z, distance, precision)};
  });
}

SetError set_error(std::span<const Pair> found, std::span<const Pair> right) {
  std::vector<Pair> missed, extra;
  std::ranges::set_difference(right, found, std::back_inserter(missed));
  std::ranges::set_difference(found, right, std::back_inserter(extra));
  return {right.size(), missed.size(), extra.size()};
}

}  // namespace spherepair
