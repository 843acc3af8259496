// SPDX-License-Identifier: MIT
// What a step with contacts could not do.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "common/shared/layout.h"

namespace spherepair {

// A sphere would move by more than the smallest radius in a step: a smaller time step may help.
class TooFast : public std::invalid_argument {
 public:
  TooFast(const std::string& what, uint64_t sphere, bool deep)
      : std::invalid_argument(what), sphere(sphere), deep(deep) {}
  const uint64_t sphere;  // the first
  const bool deep;        // so is a contact
};

// faults: by FAULT_*, the first sphere of each, or ~0. Throws std::invalid_argument that names one, of a sphere too
// fast among others TooFast: the others may have followed from it.
void require_no_faults(const std::string& backend, const std::vector<uint>& faults);

}  // namespace spherepair
