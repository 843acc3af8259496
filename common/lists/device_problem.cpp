// SPDX-License-Identifier: MIT
#include "common/lists/device_problem.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "common/lists/lattice.h"

namespace spherepair {
namespace {

ListRows rows_of(const std::array<Point3, 3>& vectors) {
  ListRows rows;
  for (size_t k = 0; k < 9; ++k) rows.of[k] = vectors[k / 3][k % 3];
  return rows;
}

double size_of_vector(const Point3& vector) { return std::hypot(vector[0], vector[1], vector[2]) * (1 + 0x1p-40); }

ListSystem system_in(const Lattice& lattice) {
  ListSystem system = {};
  system.row = rows_of(lattice.axes());
  system.dual = rows_of(lattice.dual());
  for (size_t k = 0; k < 3; ++k) {
    system.edge[k] = size_of_vector(lattice.axes()[k]);
    system.span[k] = size_of_vector(lattice.dual()[k]);
    system.periodic |= uint(lattice.box().periodic[k]) << k;
  }
  return system;
}

template <typename Item>
bool same_bytes(const std::vector<Item>& a, const std::vector<Item>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Item)) == 0);
}

// Sets for how many rows a group looks, and how many it sorts, and how many keys of a row are kept.
void share_out(ListState& state) {
  while (1u << state.row_bits < LIST_ROWS && state.looking >> state.row_bits > LIST_ROW_GROUPS) ++state.row_bits;
  const uint rows = std::max(state.looking, 1u);
  state.kept = std::clamp(LIST_KEPT_TOTAL / rows, LIST_KEPT_LEAST, LIST_KEPT_MOST);
  while (state.order_bits < 6 && state.looking >> state.order_bits > LIST_ORDER_GROUPS) ++state.order_bits;
}

}  // namespace

DeviceProblem device_problem(const ListProblem& problem) {
  DeviceProblem told;
  ListState& state = told.state;
  state.cutoff = problem.cutoff;
  state.skin = problem.skin;
  state.points = uint(problem.set.size());
  state.queries = problem.asks ? uint(problem.queries.size()) : 0;
  state.looking = uint(problem.firsts().size());
  state.systems = uint(problem.boxes.size());
  state.flags = (problem.asks ? LIST_ASKS : 0) | (problem.half ? LIST_HALF : 0) |
                (problem.inclusive ? LIST_INCLUSIVE : 0) | (problem.self_pairs ? LIST_SELF_PAIRS : 0);
  state.exclusions = uint(problem.exclusions.size());
  share_out(state);
  for (size_t b = 0; b < problem.boxes.size(); ++b) {
    ListSystem system = system_in(Lattice(problem.boxes[b], b));
    system.first_point = uint(problem.set.offsets[b]);
    system.end_point = uint(problem.set.offsets[b + 1]);
    system.first_query = problem.asks ? uint(problem.queries.offsets[b]) : 0;
    system.end_query = problem.asks ? uint(problem.queries.offsets[b + 1]) : 0;
    system.first_cell = system.first_point + uint(b);  // a slot more than there are points
    told.systems.push_back(system);
  }
  for (auto [first, second] : problem.exclusions) {
    if (!problem.asks && first > second) std::swap(first, second);
    told.exclusions.push_back({first, second});
  }
  std::ranges::sort(told.exclusions, {}, [](const uvec2& pair) { return uint64_t(pair.x) << 32 | pair.y; });
  return told;
}

bool DeviceProblem::equals(const DeviceProblem& other) const {
  ListState own = state, others = other.state;
  own.room = others.room = 0;
  own.kept = others.kept = 0;
  own.flags &= ~list_columns, others.flags &= ~list_columns;
  return std::memcmp(&own, &others, sizeof(ListState)) == 0 && same_bytes(systems, other.systems) &&
         same_bytes(exclusions, other.exclusions);
}

bool DeviceProblem::is_small() const {
  return systems.size() <= LIST_PREPARED_SYSTEMS && std::ranges::all_of(systems, [](const ListSystem& system) {
           return system.end_point - system.first_point + system.end_query - system.first_query <= LIST_PREPARED;
         });
}

}  // namespace spherepair
