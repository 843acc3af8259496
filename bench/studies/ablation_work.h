// SPDX-License-Identifier: MIT
// Does the timed steps of spherepair ablate, and counts their work.
#pragma once

#include "bench/io/report.h"
#include "bench/studies/ablation_list.h"

namespace spherepair {

std::function<void(Backend&)> step_of(const Ablation& ablation, bool on);

// The spheres of a timing, made from n spheres in random order.
SceneOptions options_of(Spheres kind, const SceneOptions& uniform);
Scene scene_of(Spheres kind, const SceneOptions& uniform);

bool moves(Spheres kind);  // whether they move in every timed step

// Uploads the scene and moves it to the start of the timing: drifting spheres until all have left their cells, falling
// ones for a second, so that some bounce in every step.
void start(Motion& motion, Spheres kind, const Scene& scene);

// Runs a few more steps and returns counts of their work. For collide: means per step of launches, sorts and the like,
// and the pairs left to the exact stages. For bounce: spheres tested against the plane, and spheres that bounced. For
// push: lists of near pairs. Empty for the others.
json work_per_step(const Ablation& ablation, bool on, Backend& backend, const Scene& scene);

}  // namespace spherepair
