// SPDX-License-Identifier: MIT
#include "bench/formats/step_division.h"

#include <fmt/format.h>

#include <cstdio>

namespace spherepair {

void divide_steps(Start& start, const TooFast& fault) {
  if (start.parts == most_parts)
    throw std::invalid_argument(fmt::format("{}; each step is already divided into {}", fault.what(), start.parts));
  Scene& scene = start.scene;
  start.parts *= 2;
  choose_contacts(scene, {.law = scene.contact.law, .stiffness = scene.contact.stiffness, .dt = scene.dt / 2});
  fmt::print(stderr, "* sphere {} is too fast: from the start again, with each step divided into {} of {:.4g} s\n",
             fault.sphere, start.parts, scene.dt);
}

std::string division_text(const Start& start) {
  return start.parts > 1 ? fmt::format("each step is divided into {}\n", start.parts) : "";
}

}  // namespace spherepair
