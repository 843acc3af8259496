// SPDX-License-Identifier: MIT
// The motion options of the command line.
#pragma once

#include <string>

#include "common/scene/contact_scene.h"

namespace spherepair {

struct MotionChoice {
  std::string method = motion_name(MotionOptions{}.method), precision = precision_name(MotionOptions{}.precision);
  float dt = SceneOptions{}.dt, restitution = SceneOptions{}.restitution;
  ContactChoice contact = {};  // its dt: --dt where that was given
};

// Both throw std::invalid_argument with the value and its valid range.
void choose_motion(SceneOptions& scene, const MotionChoice& choice);
void choose_motion(Scene& scene, const MotionChoice& choice);

// Every motion of these methods and precisions; an empty list: all.
std::vector<MotionOptions> chosen_motions(const std::vector<std::string>& methods,
                                          const std::vector<std::string>& precisions);

}  // namespace spherepair
