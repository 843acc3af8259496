// SPDX-License-Identifier: MIT
#include "bench/io/motion_choice.h"

#include <algorithm>

namespace spherepair {

void choose_motion(SceneOptions& scene, const MotionChoice& choice) {
  scene.motion = {motion_from_name(choice.method), precision_from_name(choice.precision)};
  scene.dt = choice.dt.value_or(scene.dt);
  scene.restitution = choice.restitution.value_or(scene.restitution);
  check_options(scene);
}

void choose_motion(Scene& scene, const MotionChoice& choice) {
  scene.motion = {motion_from_name(choice.method), precision_from_name(choice.precision)};
  choose_time(scene, choice);
}

void choose_time(Scene& scene, const MotionChoice& choice) {
  SceneOptions chosen;
  chosen.dt = scene.dt, chosen.restitution = scene.restitution;
  choose_motion(chosen, choice);
  scene.dt = chosen.dt;
  scene.restitution = chosen.restitution;
  if (choice.gravity) scene.gravity = 0 - *choice.gravity;
}

ContactChoice contact_choice(const MotionChoice& choice) {
  ContactChoice contact = choice.contact;
  contact.dt = choice.dt;
  contact.drag = choice.drag.value_or(contact.drag);
  return contact;
}

ContactChoice changed_contacts(const Scene& scene, const MotionChoice& choice) {
  return {.law = scene.contact.law,
          .stiffness = choice.contact.stiffness.value_or(float(double(scene.contact.stiffness) * times_water(scene))),
          .dt = scene.dt,
          .density = scene.contact.density,
          .drag = choice.drag.value_or(scene.contact.drag)};
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
