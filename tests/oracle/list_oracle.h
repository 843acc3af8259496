// SPDX-License-Identifier: MIT
// Finds lists of pairs by brute force: it tries every two points and every image, in integers or rational numbers.
#pragma once

#include "common/lists/displacement.h"
#include "tests/oracle/adversarial.h"

namespace spherepair {

// The list of a problem whose numbers are all multiples of 1/8 below 2^20, by integers. Tries images from -range to
// range along each periodic row; throws std::logic_error if one at the end of the range is a pair.
std::vector<ListedPair> list_by_integers(const ListProblem& problem, int range);

// The list of any problem, by rational numbers; slow.
std::vector<ListedPair> list_by_rationals(const ListProblem& problem, int range);

// Decides one pair in rational arithmetic.
bool is_pair_by_rationals(const ListProblem& problem, const ListBox& box, const ListedPair& pair);

// A random problem of multiples of 1/8: points, radii or a cutoff, boxes of every kind, one system or several, queries,
// exclusions, many ties.
ListProblem random_problem(Random& random);

}  // namespace spherepair
