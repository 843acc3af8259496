// SPDX-License-Identifier: MIT
// Lists by the host's threads, with every set of vector instructions, against all points and images tried one by one.
#include <cmath>
#include <deque>

#include "common/lists/host_lists.h"
#include "tests/lists/lists_test.h"
#include "tests/oracle/list_oracle.h"

namespace spherepair {
namespace {

class HostListsOf : public testing::Test {
 protected:
  void SetUp() override {
    for (const RowSimd& simd : row_simds()) lists_.emplace_back(2, simd);
  }
  // Every set of vector instructions makes the same list. The same objects make all lists of a test: nothing of one may
  // come into the next.
  std::vector<ListedPair> list(const ListProblem& problem) {
    check_problem(problem);
    std::vector<ListedPair> first;
    for (size_t k = 0; k < lists_.size(); ++k) {
      EXPECT_TRUE(lists_[k].list(problem, true, rows_)) << "left to the search";
      if (k == 0) first = rows_.pairs();
      EXPECT_EQ(first_difference(rows_.pairs(), first), "") << row_simds()[k].name << " and " << row_simds()[0].name;
    }
    return first;
  }
  std::deque<HostLists> lists_;
  PairRows rows_;
};

// All numbers times 2^power, which changes no pair.
ListProblem scaled(ListProblem problem, int power) {
  const auto scale = [&](double& x) { x = std::ldexp(x, power); };
  for (PointSet* const set : {&problem.set, &problem.queries}) {
    for (Point3& point : set->points) std::ranges::for_each(point, scale);
    std::ranges::for_each(set->radii, scale);
  }
  for (ListBox& box : problem.boxes)
    for (Point3& row : box.rows) std::ranges::for_each(row, scale);
  scale(problem.cutoff), scale(problem.skin);
  return problem;
}

// A problem of one of the kinds of random_problem, with so many points that it goes through cells.
ListProblem large_problem(Random& random, uint64_t points) {
  ListProblem problem = random_problem(random);
  const auto fill = [&](PointSet& set, bool sized) {
    set = {};
    for (uint64_t i = 0; i < points; ++i) {
      set.points.push_back(
          {random.between(-16, 16) / 8.0, random.between(-16, 16) / 8.0, random.between(-16, 16) / 8.0});
      if (sized) set.radii.push_back(random.between(2, 3) / 8.0);
    }
    set.offsets = {0, points};
  };
  const bool sized = !problem.set.radii.empty();
  fill(problem.set, sized);
  if (problem.asks) fill(problem.queries, sized);
  problem.boxes.resize(1);
  problem.cutoff = sized ? 0 : random.between(0, 8) / 8.0;
  problem.skin = random.between(0, 1) / 8.0;
  problem.exclusions.clear();
  for (uint32_t k = 0; k < points; ++k) problem.exclusions.push_back({uint32_t(random.below(points)), k});
  return problem;
}

TEST_F(HostListsOf, SmallSystemsEqualThoseOfIntegers) {
  Random random(91);
  uint64_t pairs = 0;
  for (int k = 0; k < 600; ++k) {
    const ListProblem problem = random_problem(random);
    const std::vector<ListedPair> wanted = list_by_integers(problem, 10);
    for (const int power : {0, -430, 430})
      ASSERT_EQ(first_difference(list(scaled(problem, power)), wanted), "") << "case " << k << ", 2^" << power;
    pairs += wanted.size();
  }
  EXPECT_GT(pairs, 2000u);
}

// Multiples of 1/8: many points are on the borders of cells, and many pairs are tangent.
TEST_F(HostListsOf, CellsEqualThoseOfIntegers) {
  Random random(92);
  uint64_t pairs = 0;
  const int cases = by_form(4, 1);
  for (int k = 0; k < cases; ++k) {
    const ListProblem problem = large_problem(random, 513 + random.below(60));
    const std::vector<ListedPair> wanted = list_by_integers(problem, 5);
    for (const int power : {0, -430, 430})
      ASSERT_EQ(first_difference(list(scaled(problem, power)), wanted), "") << "case " << k << ", 2^" << power;
    pairs += wanted.size();
  }
  EXPECT_GT(pairs, 1000u * uint64_t(cases));
}

// Coordinates around 2^20 with steps of 2^-32: float32 tells no pair, float64 not all.
TEST_F(HostListsOf, CellsDecideInRealNumbers) {
  Random random(93);
  ListProblem problem = of_points({}, 1);
  for (int i = 0; i < 515; ++i) {
    const auto near = [&] { return 1048576 + random.between(-4, 4) + random.between(-3, 3) * 0x1p-32; };
    problem.set.points.push_back({near(), near(), near()});
  }
  problem.set.offsets = {0, 515};
  EXPECT_EQ(first_difference(list(problem), list_by_rationals(problem, 0)), "");
}

// Two points each, a little more or less than the cutoff apart: float32 would get a half of them wrong.
TEST_F(HostListsOf, RoundingToFloat32LosesNoPairAndAddsNone) {
  Random random(96);
  ListProblem problem = of_points({}, 1);
  for (int i = 0; i < 260; ++i) {
    const Point3 at = {random.uniform(0, 60), random.uniform(0, 60), random.uniform(0, 60)};
    const double way = 1 + random.between(-3, 3) * 1e-9;
    problem.set.points.push_back(at);
    problem.set.points.push_back({at[0] + 0.6 * way, at[1], at[2] - 0.8 * way});
  }
  problem.set.offsets = {0, 520};
  const std::vector<ListedPair> wanted = list_by_rationals(problem, 0);
  EXPECT_GT(wanted.size(), 150u);
  EXPECT_EQ(first_difference(list(problem), wanted), "");
}

TEST_F(HostListsOf, NoPointsOrFewOfThem) {
  for (const uint64_t count : {0, 1, 2})
    for (const bool half : {false, true})
      for (const bool self : {false, true})
        for (const double cutoff : {0.0, 1.0}) {
          ListProblem problem = of_points(std::vector<Point3>(count, Point3{0.5, 0, 0}), cutoff, cube(4));
          problem.half = half, problem.self_pairs = self, problem.inclusive = true;
          EXPECT_EQ(first_difference(list(problem), list_by_integers(problem, 2)), "") << count << half << self;
        }
}

// Large and small systems side by side, whose rows several threads find.
TEST_F(HostListsOf, SystemsOfAnySizeAreThoseOfEach) {
  Random random(94);
  ListProblem all = of_points({}, 0.75);
  all.set.offsets = {0}, all.boxes.clear();
  std::vector<ListedPair> wanted;
  for (const uint64_t points : {3, 700, 0, 20000, 40, 5000, 1}) {
    ListProblem one = of_points({}, 0.75, points % 2 == 0 ? cube(16) : ListBox{});
    for (uint64_t i = 0; i < points; ++i)
      one.set.points.push_back({random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)});
    one.set.offsets = {0, points};
    const auto before = uint32_t(all.set.size());
    for (const ListedPair& pair : list(one)) wanted.push_back({pair.first + before, pair.second + before, pair.shift});
    all.set.points.insert(all.set.points.end(), one.set.points.begin(), one.set.points.end());
    all.set.offsets.push_back(all.set.size()), all.boxes.push_back(one.boxes[0]);
  }
  EXPECT_GT(wanted.size(), 100'000u);
  EXPECT_EQ(first_difference(list(all), wanted), "");
}

// What cells cannot help with is left to the search, and the list is the same.
TEST_F(HostListsOf, CrowdsAndGiantsAreLeftToTheSearch) {
  Random random(95);
  const std::vector<Backend*> all = open_backends();
  Backend& cpu = **std::ranges::find_if(all, [](Backend* each) { return each->info().on_host; });
  ListProblem crowd = of_points({{4000, 4000, 4000}}, 0.125), giant = of_points({{0, 0, 0}}, 0);
  giant.set.radii = {6};
  for (int i = 0; i < 800; ++i) {
    const auto along = [&] { return random.between(-16, 16) / 8.0; };
    crowd.set.points.push_back({along(), along(), along()}),
        giant.set.points.push_back({along() * 4, along(), along()});
    giant.set.radii.push_back(0.125);
  }
  for (ListProblem* const problem : {&crowd, &giant}) {
    problem->set.offsets = {0, problem->set.points.size()};
    for (HostLists& lists : lists_) EXPECT_FALSE(lists.list(*problem, true, rows_));
    EXPECT_EQ(first_difference(list_pairs(cpu, *problem), list_by_integers(*problem, 0)), "");
  }
}

}  // namespace
}  // namespace spherepair
