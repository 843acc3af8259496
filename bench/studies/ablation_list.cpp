// SPDX-License-Identifier: MIT
#include "bench/studies/ablation_list.h"

namespace spherepair {
namespace {

// A step of the grid that sorts anew, as after a move.
CollideOptions grid_step() {
  return {.method = Method::collide_grid, .grid = {.keep_order = false, .keep_cells = false, .sort = Sort::counting}};
}

template <typename Change>
CollideOptions changed(CollideOptions options, Change change) {
  change(options);
  return options;
}

template <typename Change>
CollideOptions but(Change change) {
  return changed(grid_step(), change);
}

std::vector<Ablation> ablations() {
  const CollideOptions step = grid_step(), pairs = {.method = Method::automatic};
  const auto keeping = [](bool order, bool cells) {
    return but([=](CollideOptions& o) { o.grid.keep_order = order, o.grid.keep_cells = cells; });
  };
  return {{"exact_stages", "exact arithmetic for pairs that the float32 filter decides", "", step,
           but([](CollideOptions& o) { o.filter = false; })},
          {"radius_load", "loading radii that are all equal", "", step,
           but([](CollideOptions& o) { o.load_radii = true; })},
          {"radius_load_all_pairs", "the same without a grid", "", pairs,
           changed(pairs, [](CollideOptions& o) { o.load_radii = true; })},
          {"order", "sorting spheres that stand in cell order", "", keeping(true, false), keeping(false, false),
           Spheres::in_cell_order},
          {"cells", "cells of spheres that have not moved", "", keeping(false, true), keeping(false, false)},
          {"pair_list", "a list of pairs that nobody asked for", "", step,
           but([](CollideOptions& o) { o.want_pairs = true; })},
          {"read_back", "totals that nobody asked for, counted and read after the step", "", step, step,
           Spheres::random, Reads::totals},
          {"counts_read", "counts that nobody asked for, put in the spheres' own order and read after the step", "",
           step, step, Spheres::random, Reads::counts},
          {"new_cells", "off: staying in cells that the spheres have left; steps that move", "",
           but([](CollideOptions& o) { o.grid.cells = Cells::dense; }),
           but([](CollideOptions& o) { o.grid.cells = Cells::dense, o.grid.replan = false; }), Spheres::windy},
          {.name = "plane_test",
           .summary = "testing spheres that cannot meet the plane in this step; moves of anchored",
           .backend = "",
           .spheres = Spheres::falling,
           .work = Work::bounce}};
}

std::vector<Ablation> api() {
  const CollideOptions step = grid_step(), buckets = but([](CollideOptions&o) { o.grid.sort = Sort::buckets; });
  const auto trick = [](std::optional<bool> ApiOptions::*which, bool on = true) {
    return but([=](CollideOptions& o) { o.api.*which = on; });
  };
  return {{"own_clear", "the table cleared by a kernel; off: by the API's own function", "glsl", step,
           trick(&ApiOptions::library_clear)},
          {"own_clear", "the table cleared by a kernel; off: by the API's own function", "cuda", step,
           trick(&ApiOptions::library_clear)},
          {"sparse_buffers", "buffers in sparse storage, of large pages", "glsl", step, step, Spheres::random,
           Reads::nothing, &OpenOptions::sparse_buffers},
          {"subgroups", "sums of a group through subgroups, not shared memory", "glsl", buckets, buckets,
           Spheres::random, Reads::nothing, &OpenOptions::subgroups},
          {"texture_table", "the table of cells read through a texture buffer", "glsl",
           trick(&ApiOptions::texture_table), trick(&ApiOptions::texture_table, false)},
          {"buckets", "the sort by buckets of cells; off: by counting", "", buckets, step},
          {"batch", "dispatches that go out together; off: each behind all barriers and waited for", "glsl", step,
           trick(&ApiOptions::batch, false)},
          {"overlap", "the sort begins while the search before is under way; off: when it is done", "glsl", buckets,
           changed(buckets, [](CollideOptions& o) { o.api.overlap = false; })},
          {"overlap", "the sort begins while the search before is under way; off: when it is done", "cuda",
           changed(buckets, [](CollideOptions& o) { o.api.graph = false; }),
           changed(buckets, [](CollideOptions& o) { o.api.graph = o.api.overlap = false; })},
          {.name = "vector_loads",
           .summary = "16 bytes loaded and stored at once; off: a word at a time",
           .backend = "glsl",
           .work = Work::copy},
          {.name = "vector_loads",
           .summary = "16 bytes loaded and stored at once; off: a word at a time",
           .backend = "cuda",
           .work = Work::copy},
          {"graph", "a step's launches replayed as a graph", "cuda", trick(&ApiOptions::graph),
           trick(&ApiOptions::graph, false)},
          {"graph_all_pairs",
           "the same without a grid",
           "cuda",
           {.method = Method::collide_triangle, .api = {.graph = true}},
           {.method = Method::collide_triangle, .api = {.graph = false}}},
          {"own_scan", "our scan; off: Thrust's", "cuda", step,
           but([](CollideOptions& o) { o.grid.scan = Scan::library; })},
          {"own_sort", "our sort by counting; off: Thrust's radix sort", "cuda", step,
           but([](CollideOptions& o) { o.grid.sort = Sort::radix; })},
          {"own_buckets", "our sort by buckets; off: Thrust's radix sort", "cuda", buckets,
           but([](CollideOptions& o) { o.grid.sort = Sort::radix; })}};
}

}  // namespace

const std::vector<Ablation>& ablation_list() {
  static const std::vector<Ablation> all = [] {
    std::vector<Ablation> list = ablations();
    for (const Ablation& trick : api()) list.push_back(trick);
    return list;
  }();
  return all;
}

}  // namespace spherepair
