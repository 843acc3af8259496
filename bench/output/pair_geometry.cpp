// SPDX-License-Identifier: MIT
#include "bench/output/pair_geometry.h"

namespace spherepair {

double distance_of(const ListProblem& problem, const ListedPair& pair) {
  return length(displacement(problem, problem.boxes[0], pair));
}

// The overlap is the gap of the squares over the sum of radii and distance, which avoids the cancellation of a
// difference of lengths.
Contact contact_of(const ListProblem& problem, const ListedPair& pair) {
  const Point3 way = displacement(problem, problem.boxes[0], pair);
  const Point3& from = problem.firsts().points[pair.first];
  const auto [a, b, skin] = problem.reach(pair.first, pair.second);
  const double distance = length(way), reach = a + b + skin;
  Contact contact{.overlap = 0, .normal = {}, .point = {}};
  if (reach + distance > 0) contact.overlap = squared_gap(problem, problem.boxes[0], pair) / (reach + distance);
  const double along = (distance + (a - b)) / 2;
  for (size_t axis = 0; axis < 3; ++axis) {
    if (distance > 0) contact.normal[axis] = way[axis] / distance;
    contact.point[axis] = from[axis] + along * contact.normal[axis];
  }
  return contact;
}

}  // namespace spherepair
