// SPDX-License-Identifier: MIT
// One configuration of the sweep: a number of spheres at a packing fraction, in random or in cell order, and
// all_configurations who finds its pairs in affordable time, checked and then timed against each other.
#pragma once

#include "bench/check/step_result.h"
#include "bench/measure/floors.h"

namespace spherepair {

struct SweepPoint {
  uint64_t n = 16384;
  double packing_fraction = 0.3;
  bool in_cell_order = false;  // "warm"; else "cold": random order, so that each step sorts
  uint64_t seed = SceneOptions{}.seed;
  std::vector<Method> methods;
  uint block = 0;  // 0: as Method::automatic has it
};
SceneOptions scene_of(const SweepPoint& point);
std::string label(const SweepPoint& point);  // packing fraction 0.3, n = 1000, cold

// The most spheres that this backend is timed with by this method: a step then takes at most about a quarter of a
// second on a GPU and on many cores.
uint64_t most_spheres(const Backend& backend, Method method);

struct PointTimes {
  json measurements =
      json::array();              // table "grid"; work, n, scene, order, method, block, pairs, floor_ms, samples ...
  json left_out = json::array();  // backend, method, reason
};

// Throws DifferenceFound rather than time a wrong answer. A backend that cannot hold the scene is left out.
PointTimes time_point(Session& session, const SweepPoint& point, const PeakRates& peak_rates, const Sampling& sampling,
                      Progress& progress);

}  // namespace spherepair
