// SPDX-License-Identifier: MIT
// How spheres move, as the command line says it.
#pragma once

#include <string>

#include "common/scene/scene.h"

namespace spherepair {

struct MotionChoice {
  std::string method = motion_name(MotionOptions{}.method), precision = precision_name(MotionOptions{}.precision);
  float dt = SceneOptions{}.dt, restitution = SceneOptions{}.restitution;
};

// Both throw std::invalid_argument that names the value and what it may be.
void choose_motion(SceneOptions& scene, const MotionChoice& choice);
void choose_motion(Scene& scene, const MotionChoice& choice);

// Every motion of these methods and precisions; all of what is empty.
std::vector<MotionOptions> chosen_motions(const std::vector<std::string>& methods,
                                          const std::vector<std::string>& precisions);

}  // namespace spherepair
