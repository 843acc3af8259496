// SPDX-License-Identifier: MIT
// The uniform grid and all pairs: a short form of the sweep.
#include <fmt/format.h>

#include <algorithm>

#include "bench/studies/sweep_point.h"
#include "bench/tables/study.h"

namespace spherepair {
namespace {

bool is_all_pairs(const std::string& method) { return method == "parallel" || method == "collide_triangle"; }

// The time of a backend's grid or all pairs; 0 if it was not timed.
double median_ms(const json& measurements, const std::string& backend, bool grid) {
  for (const json& row : measurements)
    if (row.at("backend") == backend && (grid ? row.at("method") == "collide_grid" : is_all_pairs(row.at("method"))))
      return row.at("median_ms");
  return 0;
}

std::string ms_or_dash(double milliseconds) { return milliseconds > 0 ? format_ms(milliseconds / 1e3) : "-"; }

std::vector<std::string> row_of(const Study& study, const SweepPoint& point, const json& measurements) {
  std::vector<std::string> row = {std::to_string(point.n), point.in_cell_order ? "warm" : "cold"};
  for (const auto& backend : study.session.backends()) {
    const double grid = median_ms(measurements, backend->info().name, true);
    const double pairs = median_ms(measurements, backend->info().name, false);
    row.push_back(ms_or_dash(grid));
    row.push_back(ms_or_dash(pairs));
    row.push_back(grid > 0 && pairs > 0 ? format_number(pairs / grid) : "-");
  }
  return row;
}

}  // namespace

std::vector<Table> make_grid(Study& study) {
  Table table{"The grid and all pairs: one collision step, packing fraction 0.3",
              {{"", "n", ""}, {"", "order", "", true}},
              {},
              {"cold: random order, so that each step sorts; warm: cell order. All pairs do not depend on the order. "
               "all/grid below 1: all pairs are faster. `spherepair sweep` goes up to 10^9 spheres."}};
  for (const auto& backend : study.session.backends()) {
    const BackendInfo& info = backend->info();
    const std::string group = info.name + (info.software ? " in SOFTWARE" : "");
    table.columns.push_back({group, "grid", "ms"});
    table.columns.push_back({group, "all pairs", "ms"});
    table.columns.push_back({group, "all/grid", "times"});
  }
  for (const uint64_t n : study.plan.grid_sizes)
    for (const bool in_cell_order : {false, true}) {
      const SweepPoint point{.n = n,
                             .in_cell_order = in_cell_order,
                             .seed = study.plan.seed,
                             .methods = {Method::parallel, Method::collide_triangle, Method::collide_grid}};
      const PointTimes times = time_point(study.session, point, {}, study.plan.sampling, study.progress);
      for (const json& row : times.measurements) study.measurements.push_back(row);
      table.rows.push_back(row_of(study, point, times.measurements));
    }
  return {table};
}

}  // namespace spherepair
