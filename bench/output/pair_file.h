// SPDX-License-Identifier: MIT
// Writes colliding pairs and contact numbers, by the file's extension as NPY (C order), CSV with a line of names, or
// text with the names in a comment. Replaces each file atomically.
#pragma once

#include <span>
#include <string>

#include "bench/io/output_files.h"
#include "common/lists/displacement.h"
#include "common/scene/pair_set.h"

namespace spherepair {

// Throws std::invalid_argument for an unknown extension of `option`'s file. Pipes and devices take text.
void check_pair_file(const std::string& option, const std::string& file);

// The separator of columns in a text file, and its line of column names: `i,j` in CSV, `# i j` in other files. Standard
// output has no such line, since programs read it.
char separator_of_rows(const std::string& file);
std::string names_line(const std::string& file, const std::vector<std::string>& names);

// NPY: m x 2, uint32; text: lines `i j`.
void write_pairs(const std::string& file, std::span<const Pair> pairs);

// What a row has beside i, j and, in a periodic box, the shift.
struct PairColumns {
  bool distances = false, geometry = false;
};
// Writes the list of one system; without other columns as write_pairs does. NPY: a structured array of i, j (uint32),
// shift (3, int32), distance, overlap, normal (3), point (3) (float64), as far as wanted; text: lines of the same
// columns.
void write_listed(const std::string& file, const ListProblem& problem, std::span<const ListedPair> list,
                  const PairColumns& columns);

// The number of contacts of each sphere. NPY: n, uint32; text: a line each.
void write_contact_numbers(const std::string& file, std::span<const uint> counts);

// The files of a full neighbour list in CSR. For list.npy they are list.offsets.npy (n + 1, uint64),
// list.neighbours.npy (2 m, uint32) and, if asked for, list.distances.npy (2 m, float64). The neighbours of sphere i,
// ascending, are neighbours[offsets[i]] to neighbours[offsets[i + 1] - 1].
struct NeighbourFiles {
  std::string offsets, neighbours, distances;
  std::string shifts;  // list.shifts.npy (2 m x 3, int32), only for periodic boxes
};
NeighbourFiles neighbour_files(const std::string& file, bool distances);
// Writes a full list of one system.
void write_neighbours(const NeighbourFiles& files, const ListProblem& problem, const std::vector<ListedPair>& list);

}  // namespace spherepair
