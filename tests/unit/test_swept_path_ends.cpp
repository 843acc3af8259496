// SPDX-License-Identifier: MIT
#include <cmath>

#include "common/backend/swept_paths.h"
#include "common/scene/scene_params.h"
#include "common/shared/swept.h"
#include "tests/support/motion_runs.h"

namespace spherepair {
namespace {

// Of spheres of every size and speed, some of them below the plane at the start: paths end within their wander of where
// the step of the method leaves the sphere.
TEST(SweptPathEnds, AreThoseOfTheStep) {
  for (const MotionMethod method : {MotionMethod::impact_linear, MotionMethod::impact, MotionMethod::anchored})
    for (const auto& [dt, restitution] : {std::pair(0.01f, 0.9f), std::pair(0.7f, 1.0f), std::pair(10.0f, 0.5f)}) {
      const Scene scene =
          awkward_scene({.motion = {method, Precision::float64}, .dt = dt, .restitution = restitution, .n = 3000});
      const MotionParams m = motion_params(scene);
      const Motion::State from{scene.positions, scene.velocities, {}}, to = run_steps(cpu_backend(), scene, 1);
      Params params{};
      params.motion = m;
      const std::vector<vec4> velocities = path_velocities(from, initial_state(scene, m), scene.motion, params, {});
      uint64_t bounced = 0;
      for (uint64_t i = 0; i < scene.size(); ++i) {
        PathPart part = first_part(scene.positions[i], velocities[i], m);
        while (part.end < double(dt)) part = next_part(part, scene.positions[i], velocities[i], m);
        const double time = part.end - part.begin, fallen = gravity_of(m) * double(dt) * double(dt) / 2;
        const double end = part.y + (part.v + part.lift * time / 2) * time - fallen;
        EXPECT_NEAR(end, double(exact_state(to, scene.motion, i)[1]), part.wander * (1 + 0x1p-40) + part.rounding)
            << motion_label(scene.motion) << ", dt " << dt << ", sphere " << i;
        bounced += part.bounces > 0;
      }
      EXPECT_GT(bounced, 300u);
    }
}

}  // namespace
}  // namespace spherepair
