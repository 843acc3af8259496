// SPDX-License-Identifier: MIT
// Of a swept search (swept.h): spheres that hold the paths of the scene's within the next step.
#pragma once

#include <span>

#include "common/backend/collide_options.h"
#include "common/scene/scene.h"

namespace spherepair {

// Two spheres can only touch within the next dt seconds of free flight if those around their paths collide. Throws
// std::invalid_argument naming the sphere whose path leaves the range of float32.
Scene spheres_around_paths(std::span<const vec4> positions, std::span<const vec4> velocities, float dt);

// How their colliding pairs are searched.
CollideOptions near_options(const CollideOptions& swept);

}  // namespace spherepair
