// SPDX-License-Identifier: MIT
#include "common/backend/method_choice.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>

#include "common/scene/counted.h"

namespace spherepair {
namespace {

// Returns the number of levels of hashed cells; 0 if cells are dense.
uint hashed_levels(const GridPlan& plan) { return plan.cells == Cells::hashed ? uint(std::popcount(plan.levels)) : 0; }

Method all_pairs(const BackendInfo& info, uint64_t n, const GridPlans& plans) {
  if (info.on_host) return Method::parallel;
  const bool square = info.software || most_pairs_near(n, plans.hashed_occupancy);
  return square ? Method::collide_square : Method::collide_triangle;
}

double grid_from(const BackendInfo& info, const GridPlans& plans, Cells wanted) {
  return grid_from(crossover_of(info), plans.occupancy(wanted), hashed_levels(plans.plan(wanted)));
}

std::string reason_of(const BackendInfo& info, uint64_t n, const GridPlans& plans, Cells wanted) {
  const uint levels = hashed_levels(plans.plan(wanted));
  std::string text =
      fmt::format("{}, each with {:.3g} more in its cell on average", counted(n, "sphere"), plans.occupancy(wanted));
  if (levels > 1) text += fmt::format(", {} levels of cells", levels);
  const double from = std::ceil(grid_from(info, plans, wanted));
  const char* where = levels ? "in hashed cells" : "at this density";
  return text +
         fmt::format("; {} the grid is faster {}from {:.0f} spheres on", where, double(n) >= from ? "" : "only ", from);
}

}  // namespace

const Crossover& crossover_of(const BackendInfo& info) {
  const bool many = info.on_host && std::stoi(info.details.at("threads")) > few_threads;
  const std::string api = info.name.starts_with("opengl") ? "opengl" : info.name;
  const std::string device = info.software ? api + " in software" : many ? "cpu of many threads" : api;
  for (const Crossover& row : crossovers)
    if (device == row.device) return row;
  throw BackendError(fmt::format("{}: no crossover of grid and all pairs is known; name a method", device));
}

void leave_all_undecided(SearchParams& params) {
  params.apart_above = params.filter_scale = std::numeric_limits<float>::infinity();
  params.collide_below = -1;
}

Method chosen_method(const BackendInfo& info, uint64_t n, const GridPlans& plans, const CollideOptions& options) {
  if (options.method != Method::automatic) return options.method;
  if (double(n) >= grid_from(info, plans, options.grid.cells)) return Method::collide_grid;
  return all_pairs(info, n, plans);
}

uint chosen_block(const BackendInfo& info, uint64_t n, Method chosen, const CollideOptions& options) {
  if (options.method != Method::automatic || options.block != CollideOptions{}.block) return options.block;
  const Crossover& row = crossover_of(info);
  if (chosen == Method::collide_square) return n <= row.narrow_to ? narrow_block : square_block;
  return chosen == Method::collide_grid && n >= row.wide_from ? wide_block : options.block;
}

MethodChoice explain_choice(const BackendInfo& info, uint64_t n, const GridPlans& plans,
                            const CollideOptions& options) {
  const Cells wanted = options.grid.cells;
  const Method method = chosen_method(info, n, plans, options);
  const uint block = info.on_host ? 0 : chosen_block(info, n, method, options);
  MethodChoice choice{method, block, plans.plan(wanted).cells, plans.occupancy(wanted), "asked for"};
  if (options.method != Method::automatic) return choice;
  choice.reason = reason_of(info, n, plans, wanted);
  if (block) choice.reason += fmt::format("; groups of {}", block);
  return choice;
}

std::string describe(const MethodChoice& choice) {
  const bool grid = choice.method == Method::collide_grid;
  const char* cells = choice.cells == Cells::dense ? ", dense cells" : ", hashed cells";
  return fmt::format("{}{} ({})", method_name(choice.method), grid ? cells : "", choice.reason);
}

}  // namespace spherepair
