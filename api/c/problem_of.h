// SPDX-License-Identifier: MIT
// From the C struct to a ListProblem.
#pragma once

#include "api/c/arrays.h"

namespace spherepair {

// Throws ListError for whatever the arrays' shapes, types and offsets make impossible; check_problem does the rest.
// Where the positions lie in a device's memory, points and radii are checked but not read, and `read` brings the other
// arrays to the host.
ListProblem problem_of(const sp_problem& given, const ReadDevice& read = {});

}  // namespace spherepair
