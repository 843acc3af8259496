// SPDX-License-Identifier: MIT
#include "bench/studies/ablation_list.h"

namespace spherepair {
namespace {

// A grid step that sorts and builds its cells, as after a move, by the default sort.
CollideOptions grid_step() {
  return {.method = Method::collide_grid, .grid = {.keep_order = false, .keep_cells = false}};
}

template <typename Change>
CollideOptions changed(CollideOptions options, Change change) {
  change(options);
  return options;
}

template <typename Change>
CollideOptions grid_step_with(Change change) {
  return changed(grid_step(), change);
}

CollideOptions grid_step_by(Sort sort) {
  return grid_step_with([=](CollideOptions& o) { o.grid.sort = sort; });
}

CollideOptions with_api(const CollideOptions& step, std::optional<bool> ApiOptions::*option, bool on = true) {
  return changed(step, [=](CollideOptions& o) { o.api.*option = on; });
}

// Work that every backend skips if a scene does not need it; off: it is always done.
std::vector<Ablation> optimisations() {
  const CollideOptions step = grid_step(), all_pairs = {.method = Method::collide_triangle};
  const auto keeping = [](bool order, bool cells) {
    return grid_step_with([=](CollideOptions& o) { o.grid.keep_order = order, o.grid.keep_cells = cells; });
  };
  const auto dense = grid_step_with([](CollideOptions& o) { o.grid.cells = Cells::dense; });
  return {
      {"exact_stages", "a float32 filter decides most pairs; off: exact arithmetic for all", "", step,
       grid_step_with([](CollideOptions& o) { o.filter = false; })},
      {"radius_load", "equal radii are not loaded", "", step,
       grid_step_with([](CollideOptions& o) { o.load_radii = true; })},
      {"radius_load_all_pairs", "the same without a grid", "", all_pairs,
       changed(all_pairs, [](CollideOptions& o) { o.load_radii = true; })},
      {"order", "spheres already in cell order are not sorted", "", keeping(true, false), keeping(false, false),
       Spheres::in_cell_order},
      {"cells", "spheres that have not moved keep their cells", "", keeping(false, true), keeping(false, false)},
      {"pair_list", "no list of pairs unless it is requested", "", step,
       grid_step_with([](CollideOptions& o) { o.want_pairs = true; })},
      {"read_back", "totals are not read back; off: after every step", "", step, step, Spheres::random, Reads::totals},
      {"counts_read", "counts are not unsorted and read back; off: after every step", "", step, step, Spheres::random,
       Reads::counts},
      {"new_cells", "cells are planned again once spheres have left them; steps that move", "", dense,
       changed(dense, [](CollideOptions& o) { o.grid.replan = false; }), Spheres::drifting},
      {.name = "plane_test",
       .summary = "only spheres with an event in this step are tested against the plane; anchored motion",
       .backend = "",
       .spheres = Spheres::falling,
       .work = AblationWork::bounce},
      {.name = "near_pairs",
       .summary = "near pairs are listed once for many steps; off: in every step; contacts of a gas",
       .backend = "",
       .spheres = Spheres::pushing,
       .work = AblationWork::push},
      {.name = "walls",
       .summary = "only spheres near walls are tested against them; contacts of a gas in its box",
       .backend = "",
       .spheres = Spheres::pushing,
       .work = AblationWork::walls,
       .spheres_off = Spheres::at_all_walls}};
}

std::vector<Ablation> glsl_features() {
  const CollideOptions step = grid_step(), counting = grid_step_by(Sort::counting);
  return {{"own_clear", "a kernel clears the table of the counting sort; off: the API's function", "opengl", counting,
           with_api(counting, &ApiOptions::library_clear)},
          {"large_pages", "buffers in memory with large pages; off: plain storage", "opengl", step, step,
           Spheres::random, Reads::nothing, &OpenOptions::large_pages},
          {"subgroups", "reductions through subgroups; off: through shared memory", "opengl", step, step,
           Spheres::random, Reads::nothing, &OpenOptions::subgroups},
          {"texture_table", "the cell table is read through a texture buffer", "opengl",
           with_api(step, &ApiOptions::texture_table), with_api(step, &ApiOptions::texture_table, false)},
          {"batch", "dispatches are submitted together; off: all barriers and a host wait after each", "opengl", step,
           with_api(step, &ApiOptions::batch, false)},
          {"overlap", "the sort overlaps the previous search; off: it waits for it", "opengl", step,
           with_api(step, &ApiOptions::overlap, false)},
          {.name = "vector_loads",
           .summary = "16-byte loads and stores; off: 4-byte ones",
           .backend = "opengl",
           .work = AblationWork::copy}};
}

std::vector<Ablation> cuda_features() {
  const CollideOptions step = grid_step(), counting = grid_step_by(Sort::counting);
  const CollideOptions stream = with_api(step, &ApiOptions::graph, false);
  const CollideOptions all_pairs = {.method = Method::collide_triangle};
  return {{"own_clear", "a kernel clears the table of the counting sort; off: the API's function", "cuda", counting,
           with_api(counting, &ApiOptions::library_clear)},
          {"overlap", "the sort overlaps the previous search; off: it waits for it", "cuda", stream,
           with_api(stream, &ApiOptions::overlap, false)},
          {.name = "vector_loads",
           .summary = "16-byte loads and stores; off: 4-byte ones",
           .backend = "cuda",
           .work = AblationWork::copy},
          {"graph", "a step's launches are replayed as a graph", "cuda", with_api(step, &ApiOptions::graph),
           with_api(step, &ApiOptions::graph, false)},
          {"graph_all_pairs", "the same without a grid", "cuda", with_api(all_pairs, &ApiOptions::graph),
           with_api(all_pairs, &ApiOptions::graph, false)},
          {"own_buckets", "our bucket sort; off: Thrust's radix sort", "cuda", step, grid_step_by(Sort::radix)}};
}

std::vector<Ablation> vulkan_features() {
  const CollideOptions step = grid_step(), counting = grid_step_by(Sort::counting);
  const CollideOptions one_by_one = with_api(step, &ApiOptions::graph, false);
  return {{"own_clear", "a kernel clears the table of the counting sort; off: the API's function", "vulkan", counting,
           with_api(counting, &ApiOptions::library_clear)},
          {"subgroups", "reductions through subgroups; off: through shared memory", "vulkan", step, step,
           Spheres::random, Reads::nothing, &OpenOptions::subgroups},
          {"texture_table", "the cell table is read through a texel buffer", "vulkan",
           with_api(step, &ApiOptions::texture_table), with_api(step, &ApiOptions::texture_table, false)},
          {"batch", "dispatches are submitted together; off: a submission and a host wait for each", "vulkan",
           one_by_one, with_api(one_by_one, &ApiOptions::batch, false)},
          {"overlap", "the sort overlaps the previous search; off: it waits for it", "vulkan", one_by_one,
           with_api(one_by_one, &ApiOptions::overlap, false)},
          {"graph", "a step's command buffer is recorded once and submitted again", "vulkan",
           with_api(step, &ApiOptions::graph), one_by_one}};
}

}  // namespace

const std::vector<Ablation>& ablation_list() {
  static const std::vector<Ablation> all = [] {
    std::vector<Ablation> list = optimisations();
    list.push_back(
        {"buckets", "bucket sort; off: counting sort", "", grid_step_by(Sort::buckets), grid_step_by(Sort::counting)});
    for (const auto& features : {glsl_features(), cuda_features(), vulkan_features()})
      for (const Ablation& feature : features) list.push_back(feature);
    return list;
  }();
  return all;
}

}  // namespace spherepair
