// SPDX-License-Identifier: MIT
#include "tests/oracle/world_of_scene.h"

namespace spherepair {

OracleLaw oracle_law(ContactLaw law) {
  if (law == ContactLaw::quartic) return OracleLaw::quartic;
  return law == ContactLaw::spring ? OracleLaw::spring : OracleLaw::hertz;
}

OracleWorld world_of(const Scene& scene) {
  OracleWorld world;
  world.law = oracle_law(scene.contact.law);
  world.stiffness = scene.contact.stiffness;
  world.damping = damper_for(scene.restitution).damping;
  world.gravity = scene.gravity, world.drag = scene.contact.drag, world.plane = scene.plane;
  for (size_t i = 0; i < scene.positions.size(); ++i) {
    const vec4 &at = scene.positions[i], &v = scene.velocities[i];
    world.spheres.push_back({{at.x, at.y, at.z}, {v.x, v.y, v.z}, at.w});
  }
  world.walls = {{1, scene.plane, true}};
  if (scene.contact.walls) {
    const vec4 &low = scene.contact.low, &high = scene.contact.high;
    for (const OracleWall& wall : {OracleWall{0, low.x, true}, OracleWall{2, low.z, true}, OracleWall{0, high.x, false},
                                   OracleWall{1, high.y, false}, OracleWall{2, high.z, false}})
      world.walls.push_back(wall);
  }
  return world;
}

}  // namespace spherepair
