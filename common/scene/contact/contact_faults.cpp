// SPDX-License-Identifier: MIT
#include "common/scene/contact/contact_faults.h"

#include <fmt/format.h>

namespace spherepair {

void require_no_faults(const std::string& backend, const std::vector<uint>& faults) {
  constexpr const char* texts[FAULTS] = {
      "is deeper in another sphere or a wall than the smaller radius: let no spheres overlap that much at the start, "
      "or give a larger --stiffness or a smaller --dt",
      "moves by more than the smallest radius in a step: give a smaller --dt",
      "has left the range of float32 centres and 64-bit positions: close the box with --walls, or take fewer steps"};
  for (uint kind = 0; kind < FAULTS; ++kind) {
    if (faults[kind] == ~0u) continue;
    const std::string what =
        fmt::format("{}: the contacts cannot go on: sphere {} {}", backend, faults[kind], texts[kind]);
    if (faults[FAULT_FAST] != ~0u) throw TooFast(what, faults[FAULT_FAST], faults[FAULT_DEEP] != ~0u);
    throw std::invalid_argument(what);
  }
}

}  // namespace spherepair
