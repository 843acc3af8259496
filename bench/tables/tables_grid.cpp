// SPDX-License-Identifier: MIT
// The uniform grid and all pairs: a short form of the sweep.
#include <fmt/format.h>

#include <algorithm>

#include "bench/studies/sweep_point.h"
#include "bench/tables/study.h"

namespace spherepair {
namespace {

bool is_grid(const json& entry) { return entry.at("method") == "collide_grid"; }

// The entry of a backend's grid or all pairs; nullptr if it was not timed.
const json* entry_of(const json& measurements, const std::string& backend, bool grid) {
  for (const json& row : measurements)
    if (row.at("backend") == backend && is_grid(row) == grid) return &row;
  return nullptr;
}

// The times of the grid or of all pairs; for all pairs also the ratio to the grid's.
std::vector<std::string> row_of(const Study& study, const SweepPoint& point, const json& measurements, bool grid) {
  std::vector<std::string> row = {std::to_string(point.n), point.in_cell_order ? "warm" : "cold",
                                  grid ? "grid" : "all pairs"};
  for (const auto& backend : study.session.backends()) {
    const json* timed = entry_of(measurements, backend->info().name, grid);
    row.push_back(timed ? time_cell(*timed) : "-");
  }
  for (const auto& backend : study.session.backends()) {
    const json *timed = entry_of(measurements, backend->info().name, grid),
               *of_grid = entry_of(measurements, backend->info().name, true);
    const bool both = !grid && timed && of_grid;
    row.push_back(both ? format_number(timed->at("median_ms").get<double>() / of_grid->at("median_ms").get<double>())
                       : "-");
  }
  return row;
}

}  // namespace

std::vector<Table> make_grid(Study& study) {
  Table table{"The grid and all pairs: one collision step, packing fraction 0.3",
              {{"", "n", ""}, {"", "order", "", true}, {"", "search", "", true}},
              {},
              {"cold: random order, so that each step sorts; warm: cell order. All pairs do not depend on the order. "
               "over the grid, below 1: all pairs are faster. `spherepair sweep` goes up to 10^9 spheres."}};
  for (const auto& backend : study.session.backends()) {
    const BackendInfo& info = backend->info();
    table.columns.push_back({"median", info.name + (info.software ? " in SOFTWARE" : ""), "ms"});
  }
  for (const auto& backend : study.session.backends())
    table.columns.push_back({"over the grid", backend->info().name, "times"});
  for (const uint64_t n : study.plan.grid_sizes)
    for (const bool in_cell_order : {false, true}) {
      const SweepPoint point{.n = n,
                             .in_cell_order = in_cell_order,
                             .seed = study.plan.seed,
                             .methods = {Method::parallel, Method::collide_triangle, Method::collide_grid}};
      const PointTimes times = time_point(study.session, point, {}, study.plan.sampling, study.progress);
      for (const json& row : times.measurements) study.measurements.push_back(row);
      for (const bool grid : {true, false})
        if (std::ranges::any_of(times.measurements, [&](const json& row) { return is_grid(row) == grid; }))
          table.rows.push_back(row_of(study, point, times.measurements, grid));
    }
  return {table};
}

}  // namespace spherepair
