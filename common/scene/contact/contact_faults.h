// SPDX-License-Identifier: MIT
// Reports steps with contacts that could not be made.
#pragma once

#include <string>
#include <vector>

#include "common/shared/contact/contact.h"

namespace spherepair {

// A step that some spheres could not make. They have its momenta, but their old positions; all others have moved. No
// step follows it.
struct FailedStep {
  std::vector<uint> faults;  // the first sphere with each FAULT_*, or ~0
  uint64_t number = 0;       // counted from 1, including steps before a resumed run
  std::vector<Body> bodies;
};

// Whether words of SLOT_FAULT name any sphere.
bool has_faults(const std::vector<uint>& words);

// Throws std::invalid_argument with the step, the sphere, its depth, speed or position, and a remedy.
[[noreturn]] void throw_fault(const std::string& backend, const FailedStep& step, const ContactParams& params);

}  // namespace spherepair
