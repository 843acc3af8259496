// SPDX-License-Identifier: MIT
#include "common/backend/checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "common/backend/scene_holder.h"
#include "common/scene/counted.h"
#include "common/shared/view.h"

namespace spherepair {

void check_collide(const CollideOptions& options) {
  const bool grid = options.method == Method::collide_grid || options.method == Method::automatic;
  if (!options.filter && (!options.exact || options.method != Method::collide_grid))
    throw std::invalid_argument("without its filter only collide_grid runs, and only with the exact predicate");
  if (options.swept && (!options.exact || options.method == Method::collide_group))
    throw std::invalid_argument(
        "pairs that touch within the next step are found of all spheres and with the exact test only: omit the naive "
        "test and the method collide_group");
  if (!grid && (options.api.texture_table || options.api.library_clear))
    throw std::invalid_argument("a table in a texture buffer and a clear by the API need collide_grid");
  if (options.api.graph.value_or(false) && !options.api.batch.value_or(true))
    throw std::invalid_argument("a step is one graph, or its launches are waited for one by one: ask for one of both");
  if (const auto& steps = options.api.graph_steps; steps && std::ranges::count(graph_sizes, *steps) == 0)
    throw std::invalid_argument(
        fmt::format("a graph holds {} steps at most, not {}", fmt::join(graph_sizes, ", "), *steps));
}

void check_images(const CollideOptions& options) {
  if (!options.exact || options.swept || options.method == Method::collide_group)
    throw std::invalid_argument(
        "a periodic box goes with neither --naive, --swept nor --method collide_group: omit them");
}

void refuse_missing(const std::string& backend, const CollideOptions& options, const ApiOptions& offered, bool thrust) {
  const auto need = [&](std::optional<bool> wanted, std::optional<bool> there, const char* what, const char* who) {
    if (wanted.value_or(false) && !there.value_or(false))
      throw std::invalid_argument(fmt::format("{}: {} is to be had with {} only", backend, what, who));
  };
  need(options.grid.sort == Sort::radix, thrust, "the radix sort of Thrust", "the backend cuda");
  need(options.api.graph, offered.graph, "a graph of launches", "the backends cuda and vulkan");
  need(options.api.graph_steps.has_value(), offered.graph, "a graph of several steps", "the backends cuda and vulkan");
  need(options.api.texture_table, offered.texture_table, "a table in a texture buffer",
       "the backends opengl and vulkan");
  need(options.api.batch, offered.batch, "a batch of launches", "the backends opengl, cuda and vulkan");
  need(options.api.overlap, offered.overlap, "a launch that overlaps the previous search",
       "the backends opengl, vulkan and, compiled for compute capability 9.0 or later, cuda");
  need(options.api.library_clear, offered.library_clear, "a clear by the API", "the backends opengl, cuda and vulkan");
}

void refuse_tensor(const std::string& backend, const CollideOptions& options, bool offered) {
  if (options.method == Method::collide_tensor && !offered)
    throw std::invalid_argument(
        fmt::format("{}: collide_tensor runs in CUDA on a GPU of compute capability 9.0 (H100, H200), and in Vulkan on "
                    "one with VK_NV_cooperative_matrix, only; choose another method, collide_triangle for the same "
                    "search without tensor cores",
                    backend));
}

void check_classes(const std::string& backend, std::span<const uint> classes, uint64_t n) {
  if (classes.size() != n)
    throw std::invalid_argument(
        fmt::format("{}: {} for {}", backend, counted(classes.size(), "class", "classes"), counted(n, "sphere")));
  const auto beyond = std::ranges::find_if(classes, [](uint each) { return each >= COLOURS; });
  if (beyond != classes.end())
    throw std::invalid_argument(fmt::format("{}: sphere {} has class {}, but the palette's last is {}", backend,
                                            beyond - classes.begin(), *beyond, COLOURS - 1));
}

void check_steps(const std::string& backend, uint steps) {
  if (steps >= ANCHOR_ON_PLANE - 1)
    throw BackendError(fmt::format("{}: anchored counts {} steps at most; go on from the state as a new scene", backend,
                                   ANCHOR_ON_PLANE - 1));
}

}  // namespace spherepair
