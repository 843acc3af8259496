// SPDX-License-Identifier: MIT
// Which numbers a scene may hold: any finite ones while it is at rest, bounded ones if it moves, since motion
// multiplies them. Within the bounds every motion method stays finite for 2^40 steps.
#pragma once

#include "common/scene/scene.h"

namespace spherepair {

constexpr float shortest_step = 0x1p-60f, longest_step = 0x1p20f;  // seconds: of dt
constexpr float largest_number = 0x1p60f;  // of coordinates, radii, speeds, gravity and the height of the plane

// Says how many spheres have a NaN, an infinity or a negative radius, and which is the first; empty if none has.
std::string unsound_spheres(const std::vector<vec4>& positions, const std::vector<vec4>& velocities);

// Says why a scene that check_scene accepts cannot be moved; empty if it can. A resumed run may be faster, farther out
// and larger than a scene may start: it is refused in the step that cannot be made.
enum class Origin { start, resumed };
std::string why_unmovable(const Scene& scene, Origin origin = Origin::start);

}  // namespace spherepair
