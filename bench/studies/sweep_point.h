// SPDX-License-Identifier: MIT
// One point of the sweep: a number of spheres at a packing fraction, in random or in cell order. Every method that is
// fast enough finds its pairs; all are checked, then timed in interleaved rounds.
#pragma once

#include "bench/check/step_result.h"
#include "bench/measure/floors.h"

namespace spherepair {

struct SweepPoint {
  uint64_t n = 16384;
  double packing_fraction = 0.3;
  bool in_cell_order = false;  // "warm"; otherwise "cold": random order, so that each step sorts
  uint64_t seed = SceneOptions{}.seed;
  std::vector<Method> methods;
  uint block = 0;  // 0: the choice of Method::automatic
};
SceneOptions scene_of(const SweepPoint& point);
std::string label(const SweepPoint& point);  // packing fraction 0.3, n = 1000, cold

// The most spheres with which this backend and method are timed: a step takes at most about 0.25 s on a GPU and on many
// cores.
uint64_t most_spheres(const Backend& backend, Method method);

struct PointTimes {
  json measurements =
      json::array();              // table "grid"; work, n, scene, order, method, block, pairs, floor_ms, samples ...
  json left_out = json::array();  // backend, method, reason
};

// Checks all results before timing; throws DifferenceFound. A backend that cannot hold the scene is left out.
PointTimes time_point(Session& session, const SweepPoint& point, const PeakRates& peak_rates, const Sampling& sampling,
                      Progress& progress);

}  // namespace spherepair
