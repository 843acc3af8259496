// SPDX-License-Identifier: MIT
#include "bench/gpu/launch_paths.h"

namespace spherepair {
namespace {

bool waits_for_each(const WorkCounts& made) { return made.waits == made.launches && made.launches > 0; }
bool waits_for_none(const WorkCounts& made) {
  return made.launches > 0 && made.waits + made.graphs_replayed + made.overlapped + made.early == 0;
}
bool overlaps(const WorkCounts& made) { return made.overlapped > 0 && made.graphs_replayed == 0; }
bool is_programmatic(const WorkCounts& made) { return made.overlapped + made.early > 0 && made.graphs_replayed == 0; }
bool is_graph(const WorkCounts& made) { return made.graphs_replayed == made.steps && made.early == 0; }
bool is_early_graph(const WorkCounts& made) { return made.graphs_replayed == made.steps && made.early > 0; }
bool are_steps(const WorkCounts& made) { return made.graphs_replayed > 0 && 2 * made.graphs_replayed < made.steps; }
bool are_graphs_of_steps(const WorkCounts& made) { return are_steps(made) && made.early + made.overlapped == 0; }
bool are_overlapping_steps(const WorkCounts& made) { return are_steps(made) && made.overlapped > 0; }
bool are_early_graphs_of_steps(const WorkCounts& made) { return are_steps(made) && made.early > 0; }
bool is_one_launch(const WorkCounts& made) { return made.launches == 1 && made.steps > 1; }

// Only the grid has a launch that can overlap the previous step, so only the grid is timed on paths that overlap.
constexpr LaunchPath paths[] = {
    {.name = "waited",
     .summary = "each dispatch behind all barriers, and the host waits for it",
     .backend = "opengl",
     .api = {.batch = false},
     .shown = waits_for_each},
    {.name = "batched",
     .summary = "a barrier before each dispatch, one wait a sample",
     .backend = "opengl",
     .api = {.overlap = false},
     .shown = waits_for_none},
    {.name = "overlapping",
     .summary = "the same, but no barrier before what needs nothing of the last step",
     .backend = "opengl",
     .of_all_pairs = false,
     .shown = overlaps},
    {.name = "waited",
     .summary = "the host waits for each kernel",
     .backend = "cuda",
     .api = {.graph = false, .batch = false, .overlap = false},
     .shown = waits_for_each},
    {.name = "stream",
     .summary = "kernel by kernel on a stream, one wait a sample",
     .backend = "cuda",
     .api = {.graph = false, .overlap = false},
     .shown = waits_for_none},
    {.name = "stream_programmatic",
     .summary = "the same by programmatic dependent launch; the grid overlaps the step before",
     .backend = "cuda",
     .api = {.graph = false, .overlap = true},
     .shown = is_programmatic},
    {.name = "graph",
     .summary = "a graph a step, captured once",
     .backend = "cuda",
     .api = {.graph = true, .graph_steps = 1, .overlap = false},
     .shown = is_graph},
    {.name = "graph_programmatic",
     .summary = "a graph whose kernels get ready while the one before runs",
     .backend = "cuda",
     .api = {.graph = true, .graph_steps = 1},
     .shown = is_early_graph},
    {.name = "graph_steps",
     .summary = "graphs of up to 64 steps",
     .backend = "cuda",
     .api = {.graph = true, .graph_steps = 64, .overlap = false},
     .shown = are_graphs_of_steps},
    {.name = "graph_steps_programmatic",
     .summary = "graphs of up to 64 steps whose kernels get ready while the one before runs",
     .backend = "cuda",
     .api = {.graph = true, .graph_steps = 64},
     .shown = are_early_graphs_of_steps},
    {.name = "waited",
     .summary = "a submission a dispatch, and the host waits for it",
     .backend = "vulkan",
     .api = {.graph = false, .batch = false},
     .shown = waits_for_each},
    {.name = "batched",
     .summary = "a barrier before each dispatch, one wait a sample",
     .backend = "vulkan",
     .api = {.graph = false, .overlap = false},
     .shown = waits_for_none},
    {.name = "overlapping",
     .summary = "the same, but no barrier before what needs nothing of the last step",
     .backend = "vulkan",
     .api = {.graph = false},
     .of_all_pairs = false,
     .shown = overlaps},
    {.name = "recorded",
     .summary = "a command buffer a step, recorded once",
     .backend = "vulkan",
     .api = {.graph = true, .graph_steps = 1, .overlap = false},
     .shown = is_graph},
    {.name = "recorded_steps",
     .summary = "command buffers of up to 64 steps, recorded once",
     .backend = "vulkan",
     .api = {.graph = true, .graph_steps = 64, .overlap = false},
     .shown = are_graphs_of_steps},
    {.name = "recorded_steps_overlapping",
     .summary = "the same, but no barrier before what needs nothing of the last step",
     .backend = "vulkan",
     .api = {.graph = true, .graph_steps = 64},
     .of_all_pairs = false,
     .shown = are_overlapping_steps},
    {.name = "persistent",
     .summary = "one cooperative kernel for all steps of a sample",
     .backend = "cuda",
     .of_grid = false,
     .persistent = true,
     .shown = is_one_launch}};

}  // namespace

std::span<const LaunchPath> launch_paths() { return paths; }

const char* launch_work_name(LaunchWork work) {
  constexpr const char* names[] = {"empty", "all_pairs", "grid"};
  return names[size_t(work)];
}

SceneOptions launch_scene(LaunchWork work, uint64_t n) {
  SceneOptions scene;
  scene.name = work == LaunchWork::grid ? "uniform" : "random";
  scene.n = n;
  return scene;
}

CollideOptions launch_options(const LaunchPath& path, LaunchWork work) {
  if (work == LaunchWork::grid)
    return {.method = Method::collide_grid,
            .grid = {.keep_order = false, .keep_cells = false},  // in software few spheres would be sorted by counting
            .api = path.api};
  return {.method = Method::collide_triangle, .api = path.api};
}

void enqueue_steps(const LaunchPath& path, LaunchWork work, Backend& backend, uint64_t steps) {
  if (path.persistent) return backend.persistent_steps()->enqueue_steps(uint(steps));
  const CollideOptions options = launch_options(path, work);
  for (uint64_t k = 0; k < steps; ++k) switch (work) {
      case LaunchWork::empty:
        backend.enqueue_empty_step(empty_launches, options.api);
        break;
      case LaunchWork::all_pairs:
        backend.enqueue_step(options);
        break;
      case LaunchWork::grid:
        backend.enqueue_collide(options);
    }
}

void run_steps(const LaunchPath& path, LaunchWork work, Backend& backend, uint64_t steps) {
  if (path.persistent) return backend.persistent_steps()->run_steps(uint(steps));
  if (work == LaunchWork::empty) return enqueue_steps(path, work, backend, steps), backend.finish();
  const CollideOptions options = launch_options(path, work);
  enqueue_steps(path, work, backend, steps - 1);
  work == LaunchWork::grid ? backend.collide(options) : backend.step(options);
}

}  // namespace spherepair
