// SPDX-License-Identifier: MIT
#include "tests/support/grid_results.h"

#include <fmt/format.h>

#include <numeric>

#include "common/scene/scene_params.h"

namespace spherepair {
namespace {

constexpr uint64_t longest_list = 300'000;  // beyond, fingerprint and counts have to do
}  // namespace

SearchInput search_of(const Scene& scene, bool want_pairs, int threads) {
  Params params{};
  params.search = search_params(scene, true);
  params.radius = common_radius(scene);
  return {
      scene.positions, params, scene.equal_radii, {.method = Method::collide_grid, .want_pairs = want_pairs}, threads};
}

StepResult result_of(CpuGrid& grid, const Scene& scene, Cells cells, bool want_pairs, int threads) {
  PairsFound found = grid.search(search_of(scene, want_pairs, threads), plan_grid(scene, cells), false);
  StepResult answer{found.totals, grid.counts(threads), std::nullopt};
  if (want_pairs) answer.pairs = std::move(found.list);
  return answer;
}

std::string difference(const StepResult& given, const PairsFound& wanted) {
  if (given.totals.pairs != wanted.totals.pairs)
    return fmt::format("{} pairs, not {}", given.totals.pairs, wanted.totals.pairs);
  if (given.totals.fingerprint != wanted.totals.fingerprint) return "the fingerprint is that of another set";
  if (given.totals.colliding_spheres != wanted.totals.colliding_spheres) return "other colliding spheres";
  if (given.counts != wanted.counts) return "other counts";
  const uint64_t settled = std::accumulate(given.totals.decided_by.begin(), given.totals.decided_by.end(), uint64_t(0));
  if (settled != given.totals.deferred) return "not every deferred pair was settled";
  return given.pairs && *given.pairs != wanted.list ? "another list" : "";
}

std::string first_grid_mismatch(const Scene& scene) {
  PairsFound wanted = search_parallel(search_of(scene, false, 2));
  const bool listed = wanted.totals.pairs <= longest_list;
  if (listed) wanted = search_parallel(search_of(scene, true, 2));
  for (const GridSimd& simd : scene.size() <= 1000 ? grid_simds() : grid_simds().first(1)) {
    CpuGrid grid(simd);
    for (Cells cells : both_cells) {
      const std::string why = difference(result_of(grid, scene, cells, listed), wanted);
      if (!why.empty()) return fmt::format("{} cells, {}: {}", name_of(cells), simd.name, why);
    }
  }
  return {};
}

}  // namespace spherepair
