// SPDX-License-Identifier: MIT
// The motion options of the command line.
#pragma once

#include <optional>
#include <string>

#include "common/scene/contact_scene.h"

namespace spherepair {

// Options that are not given keep the value of the scene, the file or the checkpoint.
struct MotionChoice {
  std::string method = motion_name(MotionOptions{}.method), precision = precision_name(MotionOptions{}.precision);
  std::optional<float> dt = {}, restitution = {};
  std::optional<float> gravity = {};  // downwards
  std::optional<float> plane = {};    // below the spheres of a file
  std::optional<float> drag = {};     // of contacts
  ContactChoice contact = {};         // without its dt and drag, see contact_choice
};

// All throw std::invalid_argument with the value and its valid range.
void choose_motion(SceneOptions& scene, const MotionChoice& choice);
void choose_motion(Scene& scene, const MotionChoice& choice);
void choose_time(Scene& scene, const MotionChoice& choice);  // only time step, restitution and gravity

ContactChoice contact_choice(const MotionChoice& choice);

// The scene's contacts with the given options changed.
ContactChoice changed_contacts(const Scene& scene, const MotionChoice& choice);

// Every motion of these methods and precisions; an empty list: all.
std::vector<MotionOptions> chosen_motions(const std::vector<std::string>& methods,
                                          const std::vector<std::string>& precisions);

}  // namespace spherepair
