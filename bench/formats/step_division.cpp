// SPDX-License-Identifier: MIT
#include "bench/formats/step_division.h"

#include <fmt/format.h>

#include <cstdio>

namespace spherepair {
namespace {

void halve_steps(Start& start) {
  Scene& scene = start.scene;
  start.parts *= 2;
  const ContactOptions& now = scene.contact;
  choose_contacts(
      scene,
      {.law = now.law, .stiffness = now.stiffness, .dt = scene.dt / 2, .drag = now.drag, .sleeping = now.sleeping});
}

// The first step's contacts are those of the start: no smaller step mends one that is too deep.
void require_no_deep_start(const Start& start, Backend& backend) {
  upload_start(start, backend);
  backend.move();
  try {
    backend.evaluate_state();
  } catch (const StepTooLong& fault) {
    if (fault.deep) throw std::invalid_argument(fault.what());
  }
}

}  // namespace

void divide_start(Start& start) {
  Start divided = start;
  while (divided.parts < most_parts && !why_no_contacts(divided.scene).empty()) halve_steps(divided);
  if (divided.parts == start.parts || !why_no_contacts(divided.scene).empty()) return;
  start = std::move(divided);
  fmt::print(stderr, "* the start needs smaller steps: each is divided into {} of {:.4g} s\n", start.parts,
             start.scene.dt);
}

void begin_again(Start& start, Backend& backend, const StepTooLong& fault) {
  backend.time_stages(false);
  require_no_deep_start(start, backend);
  if (start.parts == most_parts)
    throw std::invalid_argument(fmt::format("{}; each step is already divided into {}", fault.what(), start.parts));
  halve_steps(start);
  fmt::print(stderr, "* sphere {} is too {}: from the start again, with each step divided into {} of {:.4g} s\n",
             fault.sphere, fault.fast ? "fast" : "deep in another or a wall", start.parts, start.scene.dt);
}

std::string division_text(const Start& start) {
  return start.parts > 1 ? fmt::format("each step is divided into {}\n", start.parts) : "";
}

}  // namespace spherepair
