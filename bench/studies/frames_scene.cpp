// SPDX-License-Identifier: MIT
#include <omp.h>

#include <algorithm>
#include <span>

#include "bench/studies/frames.h"
#include "common/backend/method_choice.h"
#include "common/cpu/search/cpu_grid_sort.h"
#include "common/scene/scene_params.h"

namespace spherepair {
namespace {

constexpr uint cameras_on_path = 64;

std::vector<vec4> reordered(const std::vector<vec4>& values, std::span<const uint> order) {
  std::vector<vec4> sorted(values.size());
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < sorted.size(); ++k) sorted[k] = values[order[k]];
  return sorted;
}

}  // namespace

Scene in_cell_order(Scene scene) {
  if (scene.size() == 0) return scene;
  const GridParams grid = grid_params(plan_grid(scene, Cells::automatic));
  std::vector<uint> order;
  {
    CellSort cells(grid_simds().front());
    cells.sort(scene.positions, grid, false, omp_get_max_threads());
    order.assign(cells.order().id, cells.order().id + scene.size());
  }
  scene.positions = reordered(scene.positions, order);
  scene.velocities = reordered(scene.velocities, order);
  return scene;
}

std::vector<View> camera_path(const Bounds& bounds, const std::string& place, uint width, uint height,
                              const Look& look) {
  std::vector<View> views;
  for (uint k = 0; k < cameras_on_path; ++k) {
    const double turn = 0.05 * std::min(k, cameras_on_path - k);  // degrees, there and back
    Camera camera = frame(bounds, 30 + turn, 20, 40, double(width) / height);
    if (place == "inside") {
      for (int a = 0; a < 3; ++a) camera.eye[a] = camera.target[a] + 0.1 * (camera.eye[a] - camera.target[a]);
      camera.near = 1e-3 * (bounds.high[0] - bounds.low[0]);
    }
    views.push_back(make_view(camera, look, width, height));
  }
  return views;
}

CollideOptions in_dense_cells(const Backend& backend, uint64_t n) {
  CollideOptions options = {.method = Method::automatic, .grid = {.cells = Cells::dense}};
  options.block = chosen_block(backend.info(), n, Method::collide_grid, options);
  options.method = Method::collide_grid;
  return options;
}

}  // namespace spherepair
