// SPDX-License-Identifier: MIT
// Makes the oracle's world with the spheres, law and walls of a scene, and moves it by the same time.
#pragma once

#include "common/scene/scene.h"
#include "tests/oracle/contact_world.h"

namespace spherepair {

OracleLaw oracle_law(ContactLaw law);

// The world with the scene's stiffness and the damper of its restitution.
OracleWorld world_of(const Scene& scene);

// The time of `steps` steps of a scene, and the longest step in which the oracle moves it.
inline Real seconds_of(const Scene& scene, uint64_t steps) { return static_cast<Real>(scene.dt) * Real(steps); }

}  // namespace spherepair
