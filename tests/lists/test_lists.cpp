// SPDX-License-Identifier: MIT
// Lists of pairs on every backend against all points and images tried one by one.
#include <cmath>

#include "tests/lists/lists_test.h"
#include "tests/oracle/list_oracle.h"

namespace spherepair {
namespace {

TEST_P(Lists, EqualThoseOfAllPointsAndImages) {
  Random random(59);
  uint64_t pairs = 0;
  for (int k = 0; k < by_form(backend(), 300, 30); ++k) {
    const ListProblem problem = random_problem(random);
    const std::vector<ListedPair> wanted = list_by_integers(problem, 10);
    ASSERT_EQ(first_difference(list(problem), wanted), "") << "case " << k;
    pairs += wanted.size();
  }
  EXPECT_GT(pairs, 300u);
}

// Coordinates around 2^20 with steps of 2^-32: tangent but for a few units of 2^-53 of the distance.
TEST_P(Lists, DecideInRealNumbersWhatFloat64CannotTell) {
  Random random(60);
  for (int k = 0; k < 12; ++k) {
    ListProblem problem = of_points({}, 0, k % 2 == 0 ? ListBox{} : cube(3 + 0x1p-30));
    for (int i = 0; i < 9; ++i) {
      const auto near = [&] { return 1048576 + random.between(-2, 2) + random.between(-3, 3) * 0x1p-32; };
      problem.set.points.push_back({near(), near(), near()});
      problem.set.radii.push_back(0.5 + random.between(-2, 2) * 0x1p-53);
    }
    problem.set.offsets = {0, 9};
    problem.inclusive = k % 3 == 0;
    EXPECT_EQ(first_difference(list(problem), list_by_rationals(problem, 3)), "") << "case " << k;
  }
}

// A cutoff that is the float64 next to a distance, above and below, in a box that moves the pair far away.
TEST_P(Lists, TheCutoffIsNotRounded) {
  const double edge = 10.1;
  ListProblem problem = of_points({{0.1, 0.2, 0.3}, {0.1 + 7 * edge, 0.2, 1.3}}, 1, cube(edge));
  problem.boxes[0].periodic = {true, false, false};
  for (const double cutoff : {std::nextafter(1.0, 0), 1.0, std::nextafter(1.0, 2), 1 + 0x1p-40}) {
    problem.cutoff = cutoff;
    for (const bool inclusive : {false, true}) {
      problem.inclusive = inclusive;
      EXPECT_EQ(first_difference(list(problem), list_by_rationals(problem, 9)), "") << cutoff - 1;
    }
  }
}

// No reach divides an axis into cells.
TEST_P(Lists, AReachOfZeroHasPointsInOnePlace) {
  ListProblem problem = of_points({{0, 0, 0}, {0.5, 0, 0}, {0.5, 0, 0}, {0.5, 0x1p-40, 0}, {0.5, 1, 1}, {0, 0, 0}}, 0);
  problem.inclusive = true;
  for (const ListBox& box : {ListBox{}, cube(0.5)}) {
    problem.boxes[0] = box;
    EXPECT_EQ(first_difference(list(problem), list_by_rationals(problem, 3)), "");
  }
}

// Two points many boxes apart, so that float64 rounds the way between them by far more than it rounds its square. Their
// decimal numbers make ties common.
TEST_P(Lists, FarImagesAreThoseOfRationalNumbers) {
  Random random(65);
  int pairs = 0, near = 0;
  for (int k = 0; k < by_form(backend(), 200, 80); ++k) {
    const double edge = 0.1 * random.between(13, 17);
    const int boxes = random.between(1000, 100'000);
    ListProblem problem =
        of_points({{0.1 * random.between(0, 9), 0, 0}, {0.1 * random.between(0, 9) + boxes * edge, 0, 0}},
                  0.1 * random.between(1, 9), cube(edge));
    problem.boxes[0].periodic = {true, false, false};
    problem.half = true;
    std::vector<ListedPair> wanted;
    for (int s = -boxes - 3; s <= -boxes + 3; ++s)
      if (const ListedPair pair{0, 1, {s, 0, 0}}; is_pair_by_rationals(problem, problem.boxes[0], pair))
        wanted.push_back(pair);
    ASSERT_EQ(first_difference(list(problem), wanted), "") << "case " << k;
    pairs += int(wanted.size());
    problem.cutoff += 1e-9;
    near += int(list(problem).size() - wanted.size());
  }
  EXPECT_GT(pairs, 20);
  EXPECT_GT(near, 2) << "no ties";
}

// The cutoff is so short that rounding to float32 brings points of neighbouring systems within reach. They are at one
// place, but not in one system.
TEST_P(Lists, SystemsBesideEachOtherShareNoPair) {
  ListProblem problem = of_points({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 1e-12);
  problem.set.offsets = {0, 2, 4};
  problem.boxes.resize(2);
  EXPECT_TRUE(list(problem).empty());
  problem.set.offsets = {0, 0, 4}, problem.boxes.resize(2);
  EXPECT_EQ(list(problem).size(), 2u) << "in one system they are a pair";
}

// A third point far away makes float32 coarse for the two.
TEST_P(Lists, RoundingToFloat32LosesNoPair) {
  Random random(64);
  for (int k = 0; k < 40; ++k) {
    const double x = random.uniform(0, 100), y = random.uniform(0, 100);
    const ListProblem problem = of_points({{x, y, 0}, {x + 0.01, y, 0}, {1000, 1000, 1000}}, 0.01 + 1e-12);
    EXPECT_EQ(list(problem).size(), 2u) << x << ", " << y;
  }
}

// As many as there are in a body-centred lattice, whatever the unit of length is.
TEST_P(Lists, HoldForEveryUnitOfLength) {
  for (const int power : {-400, -150, -30, 0, 60, 200, 400}) {
    const double unit = std::ldexp(4.0, power);
    const ListProblem problem = of_points({{0, 0, 0}, {unit / 2, unit / 2, unit / 2}}, 1.6 * unit, cube(unit));
    EXPECT_EQ(list(problem).size(), 2u * (8 + 6 + 12)) << power;
  }
}

TEST_P(Lists, OfManySystemsAreThoseOfEach) {
  Random random(61);
  ListProblem all = of_points({}, 1.5);
  all.boxes.clear(), all.set.offsets = {0};
  std::vector<ListedPair> wanted;
  for (uint32_t b = 0; b < 24; ++b) {
    ListProblem one = of_points({}, 1.5, b % 3 == 0 ? ListBox{} : cube(2.0 + b));
    for (uint32_t i = 0; i < 3 * b; ++i)
      one.set.points.push_back({random.uniform(0, 4), random.uniform(0, 4), random.uniform(0, 4 + b)});
    one.set.offsets = {0, one.set.size()};
    const auto before = uint32_t(all.set.size());
    for (const ListedPair& pair : list(one)) wanted.push_back({pair.first + before, pair.second + before, pair.shift});
    all.set.points.insert(all.set.points.end(), one.set.points.begin(), one.set.points.end());
    all.set.offsets.push_back(all.set.size());
    all.boxes.push_back(one.boxes[0]);
  }
  EXPECT_GT(wanted.size(), 1000u);
  EXPECT_EQ(first_difference(list(all), wanted), "");
}

TEST_P(Lists, VectorsAndDistancesAreThoseOfTheirPairs) {
  Random random(62);
  for (int k = 0; k < 30; ++k) {
    const ListProblem problem = random_problem(random);
    for (const ListedPair& pair : list(problem)) {
      const auto system =
          std::ranges::upper_bound(problem.firsts().offsets, pair.first) - problem.firsts().offsets.begin();
      const ListBox& box = problem.boxes[size_t(system) - 1];
      const Point3 way = displacement(problem, box, pair);
      for (size_t axis = 0; axis < 3; ++axis) {
        double wanted = problem.set.points[pair.second][axis] - problem.firsts().points[pair.first][axis];
        for (size_t row = 0; row < 3; ++row) wanted += pair.shift[row] ? pair.shift[row] * box.rows[row][axis] : 0;
        EXPECT_EQ(way[axis], wanted) << "multiples of 1/8 are exact";
      }
      EXPECT_NEAR(length(way), std::hypot(way[0], way[1], way[2]), 0x1p-50 * length(way));
    }
  }
}

std::string refusal(Backend& backend, const ListProblem& problem, ListFault fault) {
  try {
    list_pairs(backend, problem);
  } catch (const ListError& error) {
    EXPECT_EQ(int(error.fault), int(fault)) << error.what();
    return error.what();
  }
  return "";
}

TEST_P(Lists, WhatCannotBeListedIsRefusedByName) {
  const Point3 origin = {};
  const auto of = [&](const ListProblem& problem, ListFault fault) { return refusal(backend(), problem, fault); };
  EXPECT_EQ(of(of_points({origin, {0, NAN, 0}}, 1), ListFault::not_finite), "positions[1].y is nan");
  EXPECT_EQ(of(of_points({{-INFINITY, 0, 0}}, 1), ListFault::not_finite), "positions[0].x is -inf");
  EXPECT_EQ(of(of_points({origin}, -1), ListFault::argument), "cutoff is -1, but must not be negative");
  EXPECT_TRUE(
      of(of_points({{0, 0, 1e-300}}, 1), ListFault::range).starts_with("positions[0].z is 1e-300: numbers other"));
  ListBox flat = cube(1);
  flat.rows[2] = {1, 1, 0};
  EXPECT_TRUE(
      of(of_points({origin}, 1, flat), ListFault::argument).starts_with("boxes[0]: its periodic rows span no vol"));
  flat.periodic[2] = false;
  EXPECT_EQ(list(of_points({origin}, 1.25, flat)).size(), 4u) << "a row that is not periodic is not read";
  EXPECT_TRUE(of(of_points({origin}, 10, cube(0.01)), ListFault::range).starts_with("the cutoff reaches over 8"));
  EXPECT_EQ(of(of_points({origin, {1e12, 0, 0}}, 1, cube(1)), ListFault::range),
            "positions[1] lies more than 2^30 boxes away from the box at the origin");
}

// As before and after it on the same backend: nothing of one list comes into the next.
TEST_P(Lists, ARefusalLeavesTheNextListAsItIs) {
  const ListProblem problem = of_points({{0, 0, 0}, {0.5, 0, 0}, {1.5, 0, 0}}, 1.25);
  const std::vector<ListedPair> wanted = {{0, 1, {}}, {1, 0, {}}, {1, 2, {}}, {2, 1, {}}};
  for (int turn = 0; turn < 3; ++turn) {
    EXPECT_EQ(first_difference(list(problem), wanted), "") << turn;
    EXPECT_NE(refusal(backend(), of_points({{0, NAN, 0}}, 1), ListFault::not_finite), "");
    EXPECT_TRUE(list(of_points({}, 1)).empty());
  }
}

INSTANTIATE_BACKENDS(Lists);

}  // namespace
}  // namespace spherepair
