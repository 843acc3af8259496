// SPDX-License-Identifier: MIT
// What a device is told of a list's problem: everything but the points.
#pragma once

#include <vector>

#include "common/lists/list_problem.h"
#include "common/shared/list.h"

namespace spherepair {

constexpr uint list_columns = LIST_WANTS_FIRST | LIST_WANTS_SECOND | LIST_WANTS_SHIFTS;

struct DeviceProblem {
  ListState state = {};
  std::vector<ListSystem> systems;
  std::vector<uvec2> exclusions;

  bool equals(const DeviceProblem& other) const;  // in all but state.room, state.kept and LIST_WANTS_*
  bool is_small() const;                          // whether list_prepare takes every system
};

DeviceProblem device_problem(const ListProblem& problem);

}  // namespace spherepair
