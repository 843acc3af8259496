// SPDX-License-Identifier: MIT
// Checks and fills the columns of a list in the caller's memory.
#pragma once

#include <string>

#include "common/lists/pair_rows.h"
#include "include/spherepair/spherepair.h"

namespace spherepair {

// Throws ListError for a column of another shape or type, or in other memory than the host's unless `on_device`.
void check_columns(const sp_pairs& pairs, bool on_device);

// If a column is too short for pairs.count rows, the message names it; else the message stays as it is.
void check_room(const sp_pairs& pairs, int64_t firsts, std::string& message);

// Writes the list into the columns that have data. Vectors and distances use the same displacements.
void write_list(const ListProblem& problem, const PairRows& list, const sp_pairs& to);

}  // namespace spherepair
