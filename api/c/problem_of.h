// SPDX-License-Identifier: MIT
// Makes a ListProblem from the C struct.
#pragma once

#include "api/c/arrays.h"

namespace spherepair {

// Throws ListError for arrays of wrong shapes, types or offsets; check_problem checks the rest. With `read` the
// positions lie in a device's memory: points and radii are then checked but not read, and `read` copies the other
// arrays to the host. Points are in the memory of those in `last`.
ListProblem problem_of(const sp_problem& given, const ReadDevice& read = {}, ListProblem last = {});

}  // namespace spherepair
