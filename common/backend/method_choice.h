// SPDX-License-Identifier: MIT
// What Method::automatic stands for.
#pragma once

#include "common/backend/backend.h"
#include "common/backend/crossover.h"

namespace spherepair {

const Crossover& crossover_of(const BackendInfo& info);

// Parameters with which the filter decides no pair.
void leave_all_undecided(SearchParams& params);

// The method itself where one is requested; else all pairs or the grid, by the rule of crossover.h for n spheres.
Method chosen_method(const BackendInfo& info, uint64_t n, const GridPlans& plans, const CollideOptions& options);

// The group size for it: the one asked for; where all is left to Method::automatic, the fastest one measured.
uint chosen_block(const BackendInfo& info, uint64_t n, Method chosen, const CollideOptions& options);

// The same, the cells of the grid, and the reason in words.
MethodChoice explain_choice(const BackendInfo& info, uint64_t n, const GridPlans& plans, const CollideOptions& options);

}  // namespace spherepair
