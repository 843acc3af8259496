// SPDX-License-Identifier: MIT
// Runs whose spheres are too fast for the time step, or too deep after it: from the start again, with each step divided
// into smaller ones.
#pragma once

#include "bench/formats/start.h"
#include "bench/io/replaced_file.h"
#include "common/scene/contact/contact_faults.h"

namespace spherepair {

constexpr uint most_parts = 64;  // of a step

// Divides each step where the start is refused, and one of that many parts is not; says so on standard error.
void divide_start(Start& start);

// Divides each step of the start into twice as many and says so on standard error; the units of momenta follow. Throws
// std::invalid_argument beyond most_parts, and where the start overlaps too much.
void begin_again(Start& start, Backend& backend, const StepTooLong& fault);

// A line that says into how many each step is divided; empty where it is not.
std::string division_text(const Start& start);

// The result of `work`, which is done anew where a step is too long, from what begin_again makes of the start. It
// writes the same files each time; where no division helps, what they were before is put back. earlier: empty where
// nothing is divided.
template <typename Work>
auto with_divided_steps(bool divides, Start& start, Backend& backend, Work work) {
  if (!divides) return work(static_cast<EarlierFiles*>(nullptr));
  EarlierFiles earlier;
  divide_start(start);
  while (true) {
    try {
      return work(&earlier);
    } catch (const StepTooLong& fault) {
      try {
        begin_again(start, backend, fault);
      } catch (...) {
        earlier.take_back();
        throw;
      }
    }
  }
}

}  // namespace spherepair
