// SPDX-License-Identifier: MIT
#include "bench/io/motion_choice.h"

#include <algorithm>

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

}  // namespace spherepair
