// SPDX-License-Identifier: MIT
// Numbers of a listed pair, in float64 from the numbers as given.
#pragma once

#include "common/lists/displacement.h"

namespace spherepair {

// The contact of a pair: the overlap in the problem's unit of length; the unit vector from the centre of `first` to
// the centre of `second` (zero if they coincide); and the point in the middle of the overlap, on the line of centres.
// In a periodic box the point is beside `first` as given. The overlap is positive for every pair that overlaps, with a
// relative error below 2^-50.
struct Contact {
  double overlap;
  Point3 normal, point;
};
Contact contact_of(const ListProblem& problem, const ListedPair& pair);

// The distance of the centres, with a relative error below 2^-50.
double distance_of(const ListProblem& problem, const ListedPair& pair);

}  // namespace spherepair
