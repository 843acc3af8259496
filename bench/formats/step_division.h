// SPDX-License-Identifier: MIT
// Runs whose spheres are too fast for the time step: from the start again, with each step divided into smaller ones.
#pragma once

#include "bench/formats/start.h"
#include "common/scene/contact/contact_faults.h"

namespace spherepair {

constexpr uint most_parts = 64;  // of a step

// Divides each step of the start into twice as many, and says so on standard error; the units of momenta follow. Throws
// std::invalid_argument beyond most_parts.
void divide_steps(Start& start, const TooFast& fault);

// A line that says into how many each step is divided; empty where it is not.
std::string division_text(const Start& start);

// The result of `work`, which is done anew where a sphere is too fast, from what divide_steps makes of the start. (The
// start's velocities have a check of their own: contacts must be able to stop them.)
template <typename Work>
auto with_divided_steps(bool divides, Start& start, Work work) {
  while (divides) {
    try {
      return work();
    } catch (const TooFast& fault) {
      divide_steps(start, fault);
    }
  }
  return work();
}

}  // namespace spherepair
