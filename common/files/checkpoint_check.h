// SPDX-License-Identifier: MIT
#pragma once

#include "common/files/checkpoint.h"

namespace spherepair {

// Checks that a run can have saved this checkpoint, since checksums detect only damage. Throws std::invalid_argument
// naming the file, the part, the sphere, the expected and the actual value.
void check_contents(const Checkpoint& checkpoint, const std::string& file);

}  // namespace spherepair
