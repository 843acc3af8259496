// SPDX-License-Identifier: MIT
// The host's part of a swept search (swept.h): how paths within the next step begin, and spheres that enclose them.
#pragma once

#include <functional>
#include <span>

#include "common/backend/collide_options.h"
#include "common/backend/motion.h"

namespace spherepair {

// Returns the colliding pairs of a scene's spheres, in any order.
using PairLister = std::function<std::vector<Pair>(const Scene&)>;

// Returns each path's initial velocity, and in w how the path continues (PATH_*), by the motion method's own arithmetic
// on the whole state. Only `anchored` reads `saved`. For leapfrog the velocity is the next step's: `list` finds the
// spheres in contact, whose impulses are summed in integers; params.contact is the scene's.
std::vector<vec4> path_velocities(const Motion::State& state, const MotionState& saved, MotionOptions motion,
                                  const Params& params, const PairLister& list);

// Returns a sphere around each path. Two spheres can only touch within the next step if the spheres around their paths
// collide. Throws std::invalid_argument, naming the sphere, if a path leaves the range of float32.
Scene spheres_around_paths(std::span<const vec4> positions, std::span<const vec4> velocities, const MotionParams& m);

// Returns the swept search's options without `swept`, for the searches that list near pairs.
CollideOptions near_options(const CollideOptions& swept);

}  // namespace spherepair
