// SPDX-License-Identifier: MIT
// A list's problem as one search for colliding spheres: all systems beside each other, with the images of points that
// the reach of others comes to. Each sphere is larger than its share of the reach by all that is rounded on the way, so
// that every pair of the list collides here; displacement.h tells them from the few others.
#pragma once

#include "common/lists/list_plan.h"
#include "common/shared/layout.h"

namespace spherepair {

// First the spheres that look for pairs, then those of images.
std::vector<vec4> list_spheres(const ListProblem& problem, const ListPlan& plan);

}  // namespace spherepair
