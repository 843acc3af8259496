// SPDX-License-Identifier: MIT
// Chooses the method for Method::automatic.
#pragma once

#include "common/backend/crossover.h"
#include "common/backend/search.h"

namespace spherepair {

const Crossover& crossover_of(const BackendInfo& info);

// Sets parameters with which the filter decides no pair.
void leave_all_undecided(SearchParams& params);

// Returns the requested method; for `automatic` the grid or all pairs, by the rule of crossover.h for n spheres.
Method chosen_method(const BackendInfo& info, uint64_t n, const GridPlans& plans, const CollideOptions& options);

// Returns the requested group size, or the fastest one measured if method and size are left open.
uint chosen_block(const BackendInfo& info, uint64_t n, Method chosen, const CollideOptions& options);

// Returns the method, the group size, the cells of the grid, and the reason in words.
MethodChoice explain_choice(const BackendInfo& info, uint64_t n, const GridPlans& plans, const CollideOptions& options);

}  // namespace spherepair
