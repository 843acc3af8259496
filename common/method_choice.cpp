// SPDX-License-Identifier: MIT
#include "method_choice.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>

namespace spherepair {
namespace {

// 0: cells are dense.
uint hashed_levels(const GridPlan& plan) { return plan.cells == Cells::hashed ? uint(std::popcount(plan.levels)) : 0; }

Method all_pairs(const BackendInfo& info, uint64_t n, const GridPlans& plans, bool swept) {
  if (info.name == "cpu") return Method::parallel;
  if (swept) return Method::collide_tiled;
  return square_pays(crossover_of(info), n, plans.hashed_crowd) ? Method::collide_square : Method::collide_triangle;
}

bool takes_grid(const BackendInfo& info, uint64_t n, const GridPlans& plans, const CollideOptions& options) {
  const Cells wanted = options.grid.cells;
  return !options.swept && grid_pays(crossover_of(info), n, plans.crowd(wanted), hashed_levels(plans.plan(wanted)));
}

std::string reason_of(const Crossover& row, uint64_t n, double crowd, uint levels, bool grid) {
  std::string text = fmt::format("{} spheres, {:.3g} others in a sphere's cell", n, crowd);
  if (levels > 1) text += fmt::format(", {} levels of cells", levels);
  if (grid && crowd_pays(row, n, crowd, levels))
    return text + fmt::format("; the grid is ahead from {} others on", row.crowd_from);
  if (most_pairs_near(row, n, crowd)) return text + "; with so many of all in one cell the grid leaves out too little";
  if (!grid && n < crowd_least && levels == 0 && crowd >= row.crowd_from)
    return text + fmt::format("; in such a crowd the grid is ahead from {} on", crowd_least);
  const double from = std::ceil(grid_from(row, crowd, levels));
  const char* cells = levels ? "in hashed cells" : "with so many others";
  return text + fmt::format("; {} the grid is ahead {}from {:.0f} on", cells, grid ? "" : "only ", from);
}

}  // namespace

const Crossover& crossover_of(const BackendInfo& info) {
  const bool many = info.name == "cpu" && std::stoi(info.details.at("threads")) > few_threads;
  const std::string device = info.software ? info.name + " in software" : many ? "cpu of many threads" : info.name;
  for (const Crossover& row : crossovers)
    if (device == row.device) return row;
  throw BackendError(fmt::format("{}: no crossover of grid and all pairs is known; name a method", device));
}

void check_collide(const CollideOptions& options) {
  const bool grid = options.method == Method::collide_grid || options.method == Method::automatic;
  if (!options.filter && (!options.exact || options.method != Method::collide_grid))
    throw std::invalid_argument("without its filter only collide_grid runs, and only with the exact predicate");
  if (!grid && options.tricks != Tricks{.graph = options.tricks.graph, .batch = options.tricks.batch})
    throw std::invalid_argument("of the tricks, all but the graph and the batch are of the grid");
  const bool counts = options.grid.sort == Sort::automatic || options.grid.sort == Sort::counting;
  if (options.grid.scan == Scan::library && !counts)
    throw std::invalid_argument(
        "the scan of a library is of the counting sort; leave the sort open or ask for that one");
  if (options.tricks.graph.value_or(false) && options.tricks.overlap.value_or(false))
    throw std::invalid_argument(
        "a step is one graph, or its launches overlap with the step before: ask for one of both");
}

void refuse_missing(const std::string& backend, const CollideOptions& options, const Tricks& offered, bool thrust) {
  const auto need = [&](std::optional<bool> wanted, std::optional<bool> there, const char* what, const char* who) {
    if (wanted.value_or(false) && !there.value_or(false))
      throw std::invalid_argument(fmt::format("{}: {} is to be had with {} only", backend, what, who));
  };
  need(options.grid.sort == Sort::radix, thrust, "the radix sort of Thrust", "the backend cuda");
  need(options.grid.scan == Scan::library, thrust, "the scan of Thrust", "the backend cuda");
  need(options.tricks.graph, offered.graph, "a graph of launches", "the backend cuda");
  need(options.tricks.keep_in_l2, offered.keep_in_l2, "setting L2 aside", "the backend cuda, where the device has it,");
  need(options.tricks.texture_table, offered.texture_table, "a table in a texture buffer", "the backend glsl");
  need(options.tricks.texture_spheres, offered.texture_spheres, "spheres in a texture buffer", "the backend glsl");
  need(options.tricks.batch, offered.batch, "a batch of dispatches", "the backend glsl");
  need(options.tricks.overlap, offered.overlap, "a launch beside the search before",
       "the backend glsl and, compiled for compute capability 9.0 or later, cuda");
  need(options.tricks.library_clear, offered.library_clear, "a clear by the API", "the backends glsl and cuda");
}

void leave_all_undecided(Params& params) {
  params.apart_above = params.filter_scale = std::numeric_limits<float>::infinity();
  params.collide_below = -1;
}

Method chosen_method(const BackendInfo& info, uint64_t n, const GridPlans& plans, const CollideOptions& options) {
  if (options.method != Method::automatic) return options.method;
  if (takes_grid(info, n, plans, options)) return Method::collide_grid;
  return all_pairs(info, n, plans, options.swept);
}

uint chosen_block(const BackendInfo& info, uint64_t n, Method chosen, const CollideOptions& options) {
  if (options.method != Method::automatic || options.block != CollideOptions{}.block) return options.block;
  const Crossover& row = crossover_of(info);
  if (chosen == Method::collide_square)
    return n <= row.narrow_to ? narrow_block : n <= row.square_block_to ? square_block : options.block;
  return chosen == Method::collide_grid && n >= row.wide_from ? wide_block : options.block;
}

MethodChoice explain_choice(const BackendInfo& info, uint64_t n, const GridPlans& plans,
                            const CollideOptions& options) {
  const Cells wanted = options.grid.cells;
  const Method method = chosen_method(info, n, plans, options);
  const uint block = info.name == "cpu" ? 0 : chosen_block(info, n, method, options);
  MethodChoice choice{method, block, plans.plan(wanted).cells, plans.crowd(wanted), "asked for"};
  if (options.method != Method::automatic) return choice;
  choice.reason = options.swept ? "the method that finds pairs within the next step"
                                : reason_of(crossover_of(info), n, plans.crowd(wanted),
                                            hashed_levels(plans.plan(wanted)), choice.method == Method::collide_grid);
  if (block) choice.reason += fmt::format("; groups of {}", block);
  return choice;
}

std::string describe(const MethodChoice& choice) {
  const bool grid = choice.method == Method::collide_grid;
  const char* cells = choice.cells == Cells::dense ? ", dense cells" : ", hashed cells";
  return fmt::format("{}{} ({})", method_name(choice.method), grid ? cells : "", choice.reason);
}

}  // namespace spherepair
