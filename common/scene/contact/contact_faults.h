// SPDX-License-Identifier: MIT
// What a step with contacts could not do.
#pragma once

#include <string>
#include <vector>

#include "common/shared/contact/contact.h"

namespace spherepair {

// The step that some spheres could not take: these have its momenta and stay where they were; the others have moved.
// No step is taken after it.
struct FailedStep {
  std::vector<uint> faults;  // by FAULT_*, the first sphere of each, or ~0
  uint64_t number = 0;       // from 1, those before a resumed run included
  std::vector<Body> bodies;
};

// Of words of SLOT_FAULT.
bool has_faults(const std::vector<uint>& words);

// Throws std::invalid_argument with the step, the sphere, its depth, speed or position, and a remedy.
[[noreturn]] void throw_fault(const std::string& backend, const FailedStep& step, const ContactParams& params);

}  // namespace spherepair
