// SPDX-License-Identifier: MIT
// What tests of lists share: the first difference of two lists, problems of a few points, and the fixture.
#pragma once

#include <fmt/format.h>

#include <algorithm>

#include "common/lists/device_lists.h"
#include "common/lists/pair_list.h"
#include "tests/support/backends.h"

namespace spherepair {

inline std::string text_of(const ListedPair& pair) {
  return fmt::format("({}, {}, [{}, {}, {}])", pair.first, pair.second, pair.shift[0], pair.shift[1], pair.shift[2]);
}

// The first pair that one of the two lists lacks, or has in another place.
inline std::string first_difference(const std::vector<ListedPair>& given, const std::vector<ListedPair>& wanted) {
  const auto [a, b] = std::ranges::mismatch(given, wanted);
  if (a == given.end() && b == wanted.end()) return "";
  return fmt::format("row {}: {}, not {}; {} rows, not {}", a - given.begin(), a == given.end() ? "end" : text_of(*a),
                     b == wanted.end() ? "end" : text_of(*b), given.size(), wanted.size());
}

// The CPU backend also makes lists through its search, and in software OpenGL and Vulkan also run the kernels that CUDA
// mirrors; they must give the same list.
inline std::vector<ListedPair> list_of(Backend& backend, const ListProblem& problem) {
  std::vector<ListedPair> all = list_pairs(backend, problem);
  if (backend.info().on_host) {
    EXPECT_EQ(first_difference(list_by_search(backend, problem).pairs(), all), "") << "the search";
  }
  Device* const device = backend.device();
  if (!device || !backend.info().software) return all;
  if (const auto made = DeviceLists(*device).list(problem)) {
    EXPECT_EQ(first_difference(made->pairs(), all), "") << "kernels of lists, not the search";
  }
  return all;
}

class Lists : public BackendTest {  // Vulkan in software is where a machine without a GPU runs the kernels of lists
 protected:
  std::vector<ListedPair> list(const ListProblem& problem) { return list_of(backend(), problem); }
};

inline ListProblem of_points(std::vector<Point3> points, double cutoff, const ListBox& box = {}) {
  ListProblem problem;
  problem.set.offsets = {0, points.size()};
  problem.set.points = std::move(points);
  problem.cutoff = cutoff;
  problem.boxes = {box};
  return problem;
}

inline ListBox cube(double edge) { return {{{{edge, 0, 0}, {0, edge, 0}, {0, 0, edge}}}, {true, true, true}}; }

}  // namespace spherepair
