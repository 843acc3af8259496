// SPDX-License-Identifier: MIT
// The ways in which the launches of a step reach a GPU, and the steps that they are timed with.
#pragma once

#include <span>

#include "common/backend/backend.h"

namespace spherepair {

// empty: a chain of empty kernels of one group that wait for each other: the floor of a path. all_pairs: a move, which
// clears the results, and collide_triangle, with the scene `random`. grid: a search in random order with the scene
// `uniform`, which sorts first, in three launches on a GPU.
enum class LaunchWork { empty, all_pairs, grid };
constexpr uint empty_launches = 8;  // of a step
const char* launch_work_name(LaunchWork work);
SceneOptions launch_scene(LaunchWork work, uint64_t n);

struct LaunchPath {
  const char *name, *summary, *backend;
  ApiOptions api = {};
  bool of_grid = true, of_all_pairs = true;
  bool persistent = false;
  bool (*shown)(const WorkCounts&);  // whether the counts of equal steps, after some others, show this path
  bool has(LaunchWork work) const {
    if (work == LaunchWork::empty) return of_all_pairs && !persistent;  // empty kernels overlap nothing
    return work == LaunchWork::grid ? of_grid : of_all_pairs;
  }
};
std::span<const LaunchPath> launch_paths();

CollideOptions launch_options(const LaunchPath& path, LaunchWork work);

// Enqueues `steps` steps. The persistent path needs a backend with persistent_steps().
void enqueue_steps(const LaunchPath& path, LaunchWork work, Backend& backend, uint64_t steps);

// Runs `steps` steps, the last one as a complete search with results.
void run_steps(const LaunchPath& path, LaunchWork work, Backend& backend, uint64_t steps);

}  // namespace spherepair
