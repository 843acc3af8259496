// SPDX-License-Identifier: MIT
// Lists of pairs, as include/spherepair/spherepair.h defines them, through a search.
#pragma once

#include "common/backend/search.h"
#include "common/lists/pair_rows.h"

namespace spherepair {

// The whole list, in the order that the header defines. With the automatic method a device makes it on a GPU's API, and
// the host's threads with the CPU backend; else `options` choose the search, which uploads the list's points: the
// scene that it holds is lost. Throws ListError, BackendError.
std::vector<ListedPair> list_pairs(Search& search, const ListProblem& problem,
                                   CollideOptions options = {.method = Method::automatic});

// The same of a checked problem, always through a search.
PairRows list_by_search(Search& search, const ListProblem& problem,
                        CollideOptions options = {.method = Method::automatic});

// How many of the host's threads make lists for this backend: 0 unless it is the CPU backend.
int list_threads(const Search& search);

// firsts + 1 offsets: the pairs of point i begin at list[offsets[i]] and end before list[offsets[i + 1]].
std::vector<int64_t> offsets_of(const std::vector<ListedPair>& list, uint64_t firsts);

}  // namespace spherepair
