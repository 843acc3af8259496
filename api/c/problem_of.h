// SPDX-License-Identifier: MIT
// From the C struct to a ListProblem.
#pragma once

#include "common/lists/list_problem.h"
#include "include/spherepair/spherepair.h"

namespace spherepair {

// Throws ListError for whatever the arrays' shapes, types and offsets make impossible; check_problem does the rest.
ListProblem problem_of(const sp_problem& given);

}  // namespace spherepair
