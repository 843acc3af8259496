// SPDX-License-Identifier: MIT
#include <algorithm>

#include "cell.h"
#include "device_backend.h"
#include "frames.h"

namespace spherepair {

Scene in_cell_order(const Scene& scene) {
  if (scene.size() == 0) return scene;
  Params p = scene_params(scene, true);
  set_grid(p, plan_grid(scene, Cells::automatic));
  std::vector<uint> begin(size_t(p.cell_slots) + 1), slot(scene.size());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < scene.size(); ++i) slot[i] = slot_of(scene.positions[i], p);
  for (const uint s : slot) ++begin[s + 1];
  for (size_t s = 1; s < begin.size(); ++s) begin[s] += begin[s - 1];
  Scene sorted = scene;
  for (size_t i = 0; i < scene.size(); ++i) {
    const uint place = begin[slot[i]]++;
    sorted.positions[place] = scene.positions[i];
    sorted.velocities[place] = scene.velocities[i];
  }
  return sorted;
}

}  // namespace spherepair
