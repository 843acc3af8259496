// SPDX-License-Identifier: MIT
#pragma once

#include "bench/formats/checkpoint.h"

namespace spherepair {

// Whether what a checkpoint holds is what a run can have saved: its checksums say only that nobody damaged it. Throws
// std::invalid_argument that names the file, the part, the sphere, what was expected and what was found.
void check_contents(const Checkpoint& checkpoint, const std::string& file);

}  // namespace spherepair
