// SPDX-License-Identifier: MIT
// Of a swept search (swept.h): what the host tells it of the paths within the next step, and spheres that hold them.
#pragma once

#include <functional>
#include <span>

#include "common/backend/backend.h"
#include "common/scene/motion_state.h"

namespace spherepair {

// The colliding pairs of these spheres, in any order.
using PairLister = std::function<std::vector<Pair>(const Scene&)>;

// The velocity with which each sphere's path begins, and in w how it goes on (PATH_*), decided by the method's own
// arithmetic from the whole state; `saved` is only needed of anchored. Of leapfrog it is that of the next step: `list`
// finds the spheres in contact, whose impulses are added up in integers; params.contact is the scene's.
std::vector<vec4> path_velocities(const Backend::State& state, const MotionState& saved, MotionOptions motion,
                                  const Params& params, const PairLister& list);

// Two spheres can only touch within the next step, on the paths that begin with these velocities, if those around their
// paths collide. Throws std::invalid_argument naming the sphere whose path leaves the range of float32.
Scene spheres_around_paths(std::span<const vec4> positions, std::span<const vec4> velocities, const MotionParams& m);

// How pairs of both are searched.
CollideOptions near_options(const CollideOptions& swept);

}  // namespace spherepair
