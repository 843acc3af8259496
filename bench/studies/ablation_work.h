// SPDX-License-Identifier: MIT
// What a step of spherepair skips does, and what of its work can be counted.
#pragma once

#include "bench/io/report.h"
#include "bench/studies/ablation_list.h"

namespace spherepair {

std::function<void(Backend&)> step_of(const Ablation& ablation, bool on);

// The spheres that a skip is timed with, made from n spheres in random order.
SceneOptions options_of(Spheres kind, const SceneOptions& uniform);
Scene scene_of(Spheres kind, const SceneOptions& uniform);

// Moves after which the times of a step no longer change: of windy spheres those until all have left their cells.
uint64_t moves_ahead(Spheres kind, const Scene& scene);

// Means over a few more steps, which are taken: launches, sorts, ... and, by the kind of work, the pairs left to the
// exact stages, the cells in a sphere's reach, the spheres that were tested against the plane and those that bounced.
json work_a_step(const Ablation& ablation, bool on, Backend& backend, const Scene& scene);

}  // namespace spherepair
