// SPDX-License-Identifier: MIT
// The totals of a search, which kernels spread over the rows of SLOT_SUMMARY.
#pragma once

#include <vector>

#include "common/backend/backend.h"

namespace spherepair {

// deferred_word: SUM_* in which the pairs are counted that the filter left undecided.
Collisions sum_of(const std::vector<uint>& summary, uint deferred_word);

}  // namespace spherepair
