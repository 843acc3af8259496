// SPDX-License-Identifier: MIT
#include <algorithm>

#include "cell.h"
#include "device_backend.h"
#include "frames.h"

namespace spherepair {
namespace {

constexpr uint places_on_way = 64;

}  // namespace

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

std::vector<View> way(const Bounds& bounds, const std::string& place, uint width, uint height, uint lighting) {
  Look look = contact_look();
  look.lighting = lighting;
  std::vector<View> views;
  for (uint k = 0; k < places_on_way; ++k) {
    const double turn = 0.05 * std::min(k, places_on_way - k);  // degrees, there and back
    Camera camera = frame(bounds, 30 + turn, 20, 40, double(width) / height);
    if (place == "inside") {
      for (int a = 0; a < 3; ++a) camera.eye[a] = camera.target[a] + 0.1 * (camera.eye[a] - camera.target[a]);
      camera.near = 1e-3 * (bounds.high[0] - bounds.low[0]);
    }
    views.push_back(make_view(camera, look, width, height));
  }
  return views;
}

}  // namespace spherepair
