// SPDX-License-Identifier: MIT
// The oracle's world of the same spheres, law and walls as a scene, and moved by both.
#pragma once

#include "common/scene/scene.h"
#include "tests/oracle/contact_world.h"

namespace spherepair {

OracleLaw oracle_law(ContactLaw law);

// Of the chosen stiffness, with the damper that the restitution asks for.
OracleWorld world_of(const Scene& scene);

// The time of steps of a scene's dt, and the longest step in which the oracle moves it.
inline Real seconds_of(const Scene& scene, uint64_t steps) { return static_cast<Real>(scene.dt) * Real(steps); }

}  // namespace spherepair
