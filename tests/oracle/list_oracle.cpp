// SPDX-License-Identifier: MIT
#include "tests/oracle/list_oracle.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

namespace spherepair {
namespace {

using Rational = boost::multiprecision::cpp_rational;

struct Eighths {
  using Number = int64_t;
  static int64_t of(double x) { return int64_t(x * 8); }
};
struct Rationals {
  using Number = Rational;
  static Rational of(double x) { return Rational(x); }
};

bool is_excluded(const ListProblem& problem, uint32_t i, uint32_t j) {
  return std::ranges::any_of(problem.exclusions, [&](const auto& pair) {
    return (pair[0] == i && pair[1] == j) || (!problem.asks && pair[0] == j && pair[1] == i);
  });
}

template <typename Number>
using Triple = std::array<Number, 3>;

template <typename Kind>
Triple<typename Kind::Number> numbers_of(const Point3& point) {
  return {Kind::of(point[0]), Kind::of(point[1]), Kind::of(point[2])};
}

template <typename Kind>
Triple<typename Kind::Number> image_of(const ListBox& box, const Shift& shift) {
  Triple<typename Kind::Number> image{};
  for (size_t k = 0; k < 3; ++k)
    if (shift[k] != 0)
      for (size_t axis = 0; axis < 3; ++axis)
        image[axis] += typename Kind::Number(shift[k]) * Kind::of(box.rows[k][axis]);
  return image;
}

template <typename Kind>
typename Kind::Number reach_of(const ListProblem& problem, uint32_t i, uint32_t j) {
  const auto skin = Kind::of(problem.skin);
  if (problem.set.radii.empty()) return skin + Kind::of(problem.cutoff);
  return skin + Kind::of(problem.firsts().radii[i]) + Kind::of(problem.set.radii[j]);
}

template <typename Number>
bool is_pair(const Triple<Number>& first, const Triple<Number>& second, const Triple<Number>& image,
             const Number& reach, bool inclusive) {
  Number squared = 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    const Number way = second[axis] - first[axis] + image[axis];
    if (way > reach || -way > reach) return false;
    squared += way * way;
  }
  return squared < reach * reach || (inclusive && squared == reach * reach);
}

// Which of the two that stand for the same is in a half list.
bool is_of_half(const ListedPair& pair) {
  if (pair.first != pair.second) return pair.first < pair.second;
  for (const int k : pair.shift)
    if (k != 0) return k > 0;
  return true;
}

template <typename Kind>
struct Image {
  Shift shift;
  Triple<typename Kind::Number> way;
};

template <typename Kind>
std::vector<Image<Kind>> images_of(const ListBox& box, int range) {
  std::vector<Image<Kind>> images;
  const auto to = [&](size_t k) { return box.periodic[k] ? range : 0; };
  for (int x = -to(0); x <= to(0); ++x)
    for (int y = -to(1); y <= to(1); ++y)
      for (int z = -to(2); z <= to(2); ++z) images.push_back({{x, y, z}, image_of<Kind>(box, {x, y, z})});
  return images;
}

template <typename Kind>
std::vector<ListedPair> list_by(const ListProblem& problem, int range) {
  std::vector<ListedPair> list;
  const PointSet &firsts = problem.firsts(), &seconds = problem.set;
  std::vector<Triple<typename Kind::Number>> from, to;
  std::ranges::transform(firsts.points, std::back_inserter(from), numbers_of<Kind>);
  std::ranges::transform(seconds.points, std::back_inserter(to), numbers_of<Kind>);
  for (size_t b = 0; b + 1 < seconds.offsets.size(); ++b) {
    const ListBox& box = problem.boxes[b];
    const std::vector<Image<Kind>> images = images_of<Kind>(box, range);
    for (auto i = uint32_t(firsts.offsets[b]); i < firsts.offsets[b + 1]; ++i)
      for (auto j = uint32_t(seconds.offsets[b]); j < seconds.offsets[b + 1]; ++j) {
        const auto reach = reach_of<Kind>(problem, i, j);
        for (const Image<Kind>& image : images) {
          const ListedPair pair{i, j, image.shift};
          const bool self = !problem.asks && i == j && pair.shift == Shift{};
          if ((self && !problem.self_pairs) || (problem.half && !is_of_half(pair))) continue;
          if (!is_pair(from[i], to[j], image.way, reach, problem.inclusive) || is_excluded(problem, i, j)) continue;
          for (size_t k = 0; k < 3; ++k)
            if (box.periodic[k] && std::abs(pair.shift[k]) == range) throw std::logic_error("the range is too short");
          list.push_back(pair);
        }
      }
  }
  std::ranges::sort(list);
  return list;
}

double eighths(Random& random, int low, int high) { return random.between(low, high) / 8.0; }

PointSet random_set(Random& random, int systems, bool radii) {
  constexpr int sizes[] = {0, 1, 2, 5, 12};
  PointSet set;
  set.offsets = {0};
  for (int b = 0; b < systems; ++b) {
    const int n = sizes[random.below(5)];
    for (int i = 0; i < n; ++i) {
      set.points.push_back({eighths(random, -24, 24), eighths(random, -24, 24), eighths(random, -24, 24)});
      if (i > 0 && random.below(10) == 0) set.points.back() = set.points[set.points.size() - 2];
      if (radii) set.radii.push_back(eighths(random, 0, 12));
    }
    set.offsets.push_back(set.points.size());
  }
  if (radii && set.radii.empty()) set.points.clear(), set.offsets.assign(size_t(systems) + 1, 0);
  return set;
}

ListBox random_box(Random& random) {
  ListBox box;
  for (size_t k = 0; k < 3; ++k) {
    box.periodic[k] = random.below(2) == 1;
    box.rows[k][k] = eighths(random, 20, 60);
    for (size_t axis = 0; axis < k; ++axis) box.rows[k][axis] = eighths(random, -12, 12);
    if (random.below(3) == 0)
      for (double& x : box.rows[k]) x = -x;
  }
  for (size_t k = 2; k > 0; --k) {
    const size_t other = random.below(k + 1);
    std::swap(box.rows[k], box.rows[other]), std::swap(box.periodic[k], box.periodic[other]);
  }
  return box;
}

}  // namespace

std::vector<ListedPair> list_by_integers(const ListProblem& problem, int range) {
  return list_by<Eighths>(problem, range);
}

std::vector<ListedPair> list_by_rationals(const ListProblem& problem, int range) {
  return list_by<Rationals>(problem, range);
}

bool is_pair_by_rationals(const ListProblem& problem, const ListBox& box, const ListedPair& pair) {
  return is_pair(numbers_of<Rationals>(problem.firsts().points[pair.first]),
                 numbers_of<Rationals>(problem.set.points[pair.second]), image_of<Rationals>(box, pair.shift),
                 reach_of<Rationals>(problem, pair.first, pair.second), problem.inclusive);
}

ListProblem random_problem(Random& random) {
  ListProblem problem;
  const int systems = random.between(1, 3);
  const bool radii = random.below(2) == 1;
  problem.set = random_set(random, systems, radii);
  problem.asks = random.below(4) == 0;
  if (problem.asks) problem.queries = random_set(random, systems, radii);
  if (!radii) problem.cutoff = eighths(random, 0, 36);
  problem.skin = random.below(3) == 0 ? eighths(random, 0, 6) : 0;
  for (int b = 0; b < systems; ++b) problem.boxes.push_back(random_box(random));
  if (const uint64_t n = problem.set.size(), m = problem.firsts().size(); n > 0 && m > 0 && random.below(3) == 0)
    for (int e = 0; e < 5; ++e) problem.exclusions.push_back({uint32_t(random.below(m)), uint32_t(random.below(n))});
  problem.inclusive = random.below(2) == 1;
  if (!problem.asks) problem.half = random.below(2) == 1, problem.self_pairs = random.below(3) == 0;
  return problem;
}

}  // namespace spherepair
