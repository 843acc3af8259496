// SPDX-License-Identifier: MIT
// Writes lists of pairs in a periodic box, by the file's extension as NPY, CSV or text. Replaces each file atomically.
#pragma once

#include <span>
#include <string>

#include "bench/output/pair_file.h"
#include "common/lists/displacement.h"

namespace spherepair {

// NPY: a structured array of i, j (uint32), shift (3, int32) and, if asked for, distance (float64); text: lines of the
// same columns.
void write_listed(const std::string& file, const ListProblem& problem, std::span<const ListedPair> list,
                  bool distances);

// Writes a full list of one system in CSR, with its shifts.
void write_listed_neighbours(const NeighbourFiles& files, const ListProblem& problem, std::span<const ListedPair> list);

}  // namespace spherepair
