// SPDX-License-Identifier: MIT
// How spheres move, as the command line says it.
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "scene.h"

namespace spherepair {

struct RunOptions;

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

// --motion, --precision, --dt and --restitution.
void add_motion_options(CLI::App& command, MotionChoice& motion);

void add_save_options(CLI::App& command, RunOptions& options);  // --save and --save-every

// --resume, which takes the place of every option of the scene and its motion; the command has these already.
void add_resume_option(CLI::App& command, std::string& file);

}  // namespace spherepair
