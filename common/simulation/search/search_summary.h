// SPDX-License-Identifier: MIT
// Adds up the totals of a search, which kernels spread over the rows of SLOT_SUMMARY.
#pragma once

#include <vector>

#include "common/backend/collide_options.h"

namespace spherepair {

// Returns the totals. deferred_word: the SUM_* that counts the pairs which the filter left undecided.
Collisions sum_of(const std::vector<uint>& summary, uint deferred_word);

}  // namespace spherepair
