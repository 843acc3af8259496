// SPDX-License-Identifier: MIT
// Rows 12 to 14, 31 and 32 of the stress catalogue: scenes that a grid could get wrong, through every kind of cells.
#include <cmath>

#include "tests/oracle/oracle.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

// The grid with dense and with hashed cells, sorting anew or not, in either way.
std::vector<CollideOptions> every_grid() {
  std::vector<CollideOptions> all;
  for (Cells cells : {Cells::automatic, Cells::dense, Cells::hashed}) {
    all.push_back({.method = Method::collide_grid, .grid = {.cells = cells}});
    for (Sort sort : {Sort::counting, Sort::buckets})
      all.push_back({.method = Method::collide_grid,
                     .grid = {.cells = cells, .keep_order = false, .keep_cells = false, .sort = sort}});
  }
  return all;
}

std::vector<vec4> uniform_spheres(uint64_t n, float radius_ratio = 1, float radius = 0.5f) {
  return make_scene({.name = "uniform", .n = n, .radius = radius, .radius_ratio = radius_ratio}).positions;
}

void expect_right(Backend& backend, const std::vector<vec4>& spheres) {
  expect_pairs(backend, scene_of(spheres), swept_pairs(spheres), every_grid());
}

TEST_P(StressCatalogue, Row12_AllInOneCell) {
  expect_right(backend(), make_scene({.name = "one_cell", .n = is_gpu(backend()) ? 4096u : 700u}).positions);
}

TEST_P(StressCatalogue, Row13_OneSpherePerCellNoneTouching) {
  const int m = is_gpu(backend()) || full_stress() ? 100 : 24;
  std::vector<vec4> spheres;
  for (int i = 0; i < m * m * m; ++i)
    spheres.push_back({float(i % m) * 1.0625f, float(i / m % m) * 1.0625f, float(i / (m * m)) * 1.0625f, 0.5f});
  expect_pairs(backend(), scene_of(spheres), {}, every_grid());
}

TEST_P(StressCatalogue, Row14_RadiiAcrossFiveDecades) {
  expect_right(backend(), uniform_spheres(by_form(backend(), 2000, 900), 1e5f, 1e-3f));
  std::vector<vec4> mixed = uniform_spheres(by_form(backend(), 3000, 1200), 1, 1e-3f);
  mixed.push_back({0.01f, 0.01f, 0.01f, 100.0f});
  mixed.push_back({150.0f, 0.0f, 0.0f, 50.0f});
  expect_right(backend(), mixed);
}

TEST_P(StressCatalogue, Row31_OneSphereFarAway) {
  for (const vec4& far : {vec4{1e9f, 0, 0, 0.5f}, vec4{-1e9f, 1e9f, -1e9f, 0.5f}, vec4{0, 3e38f, 0, 0.5f}}) {
    std::vector<vec4> spheres = uniform_spheres(by_form(backend(), 3000, 1200));
    spheres.insert(spheres.begin() + 1000, far);
    spheres.push_back(far);
    expect_right(backend(), spheres);
  }
}

TEST_P(StressCatalogue, Row32_CentresOnCellBorders) {
  std::vector<vec4> spheres;
  for (int i = 0; i < 2000; ++i) {
    const auto coordinate = [&](int k) { return float(int(unsigned(i) * 2654435761u >> (3 * k)) % 13 - 6); };
    spheres.push_back({coordinate(1), coordinate(2) * 0.5f, coordinate(3), 0.5f});
    spheres.push_back({-0.0f, std::nextafter(coordinate(4), 100.0f), coordinate(5) * 0.25f, 0.5f});
  }
  expect_right(backend(), spheres);
}

}  // namespace
}  // namespace spherepair
