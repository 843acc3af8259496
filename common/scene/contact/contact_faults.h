// SPDX-License-Identifier: MIT
// What a step with contacts could not do.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "common/shared/contact/contact.h"

namespace spherepair {

// A sphere would move by more than the smallest radius in a step, or is deeper in a contact than the smaller: a smaller
// time step may help.
class StepTooLong : public std::invalid_argument {
 public:
  StepTooLong(const std::string& what, uint64_t sphere, bool fast, bool deep)
      : std::invalid_argument(what), sphere(sphere), fast(fast), deep(deep) {}
  const uint64_t sphere;  // the first that is too fast, else that is too deep
  const bool fast, deep;
};

// The step that some spheres could not take: these have its momenta and stay where they were; the others have moved.
// No step is taken after it.
struct FailedStep {
  std::vector<uint> faults;  // by FAULT_*, the first sphere of each, or ~0
  uint64_t number = 0;       // since the upload, from 1
  std::vector<Body> bodies;
};

// Of words of SLOT_FAULT.
bool has_faults(const std::vector<uint>& words);

// Throws StepTooLong, or std::invalid_argument of a sphere out of range, that names the sphere and by how much.
[[noreturn]] void throw_fault(const std::string& backend, const FailedStep& step, const ContactParams& params);

}  // namespace spherepair
