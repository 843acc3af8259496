// SPDX-License-Identifier: MIT
#include "motion_choice.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "options.h"

namespace spherepair {

void choose_motion(SceneOptions& scene, const MotionChoice& choice) {
  scene.motion = {motion_from_name(choice.method), precision_from_name(choice.precision)};
  scene.dt = choice.dt;
  scene.restitution = choice.restitution;
  check_options(scene);
}

void choose_motion(Scene& scene, const MotionChoice& choice) {
  SceneOptions chosen;
  choose_motion(chosen, choice);
  scene.motion = chosen.motion;
  scene.dt = chosen.dt;
  scene.restitution = chosen.restitution;
}

std::vector<MotionOptions> chosen_motions(const std::vector<std::string>& methods,
                                          const std::vector<std::string>& precisions) {
  for (const std::string& name : methods) motion_from_name(name);
  for (const std::string& name : precisions) precision_from_name(name);
  const auto wanted = [](const std::vector<std::string>& names, const char* name) {
    return names.empty() || std::ranges::find(names, name) != names.end();
  };
  std::vector<MotionOptions> motions = all_motions();
  std::erase_if(motions, [&](MotionOptions motion) {
    return !wanted(methods, motion_name(motion.method)) || !wanted(precisions, precision_name(motion.precision));
  });
  return motions;
}

void add_motion_options(CLI::App& command, MotionChoice& motion) {
  command
      .add_option("--motion", motion.method,
                  "euler, symplectic, paper, paper-clamp, impact-linear, impact or anchored: see README")
      ->capture_default_str();
  command.add_option("--precision", motion.precision, "Of the motion's state: float32, compensated or float64")
      ->capture_default_str();
  command.add_option("--dt", motion.dt, "Seconds of a step, from 2^-60 to 2^20")->capture_default_str();
  command.add_option("--restitution", motion.restitution, "Speed after a bounce over speed before, 0 to 1")
      ->capture_default_str();
}

void add_save_options(CLI::App& command, RunOptions& options) {
  command.add_option("--save", options.save_file, "Write a checkpoint to this file after the last step");
  command.add_option("--save-every", options.save_every, "Also after every so many steps")
      ->check(whole_number(1, kMostSteps));
}

void add_resume_option(CLI::App& command, std::string& file) {
  auto* resume = command.add_option("--resume", file,
                                    "Go on from this checkpoint, to the same bits as if the run had not stopped");
  for (const char* other :
       {"--input", "--frame", "--scene", "--n", "--seed", "--radius", "--radius-ratio", "--packing-fraction",
        "--groups", "--group-size", "--offset", "--motion", "--precision", "--dt", "--restitution"})
    resume->excludes(command.get_option(other));
}

}  // namespace spherepair
