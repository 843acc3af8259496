// SPDX-License-Identifier: MIT
// pairs of files whose numbers float32 cannot hold: decided in real arithmetic, as rational numbers decide them.
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "bench/npy/rows_file.h"
#include "tests/support/pairs_command.h"

namespace spherepair {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Sphere = std::array<double, 4>;

// The sign of |a - b|^2 - c^2.
int rational_side(const Sphere& a, const Sphere& b, const Rational& reach) {
  Rational square = -reach * reach;
  for (size_t axis = 0; axis < 3; ++axis) square += (Rational(a[axis]) - b[axis]) * (Rational(a[axis]) - b[axis]);
  return square.sign();
}

constexpr uint edge = 6;

// A cubic lattice from (at, -at, at) on.
std::vector<Sphere> lattice(double at, double gap, double radius) {
  std::vector<Sphere> all;
  for (uint k = 0; k < edge * edge * edge; ++k)
    all.push_back({at + gap * (k % edge), -at + gap * (k / edge % edge), at + gap * (k / edge / edge), radius});
  return all;
}

std::vector<double> numbers_of(const std::vector<Sphere>& spheres) {
  std::vector<double> rows;
  for (const Sphere& sphere : spheres) rows.insert(rows.end(), sphere.begin(), sphere.end());
  return rows;
}

class ExactPairs : public PairsCommand {
 protected:
  std::string npy_of(const std::vector<Sphere>& spheres) {
    return folder_.write(
        "a.npy", npy_file(npy_header("<f8", fmt::format("({}, 4)", spheres.size())), npy_data(numbers_of(spheres), 4)));
  }
  std::string text_of_spheres(const std::vector<Sphere>& spheres) {
    std::string text = "x y z radius\n";
    for (const Sphere& sphere : spheres) text += fmt::format("{}\n", fmt::join(sphere, " "));
    return folder_.write("a.txt", text);
  }
};

// Relative overlaps and gaps of 1e-6 to 1e-15. Far from the origin float64 rounds the lattice itself, so that
// neighbours differ.
TEST_F(ExactPairs, LatticesNearTouchingAreDecidedInRealArithmetic) {
  uint64_t pairs = 0, apart = 0;
  for (const double at : {0.0, 1.0 / 3, 1e6})
    for (int exponent = -15; exponent <= -6; ++exponent)
      for (const double sign : {1.0, -1.0}) {
        const auto spheres = lattice(at, 0.1, 0.05 * (1 + sign * std::pow(10, exponent)));
        std::string wanted = "# i j\n";
        for (uint i = 0; i < spheres.size(); ++i)
          for (uint j = i + 1; j < spheres.size(); ++j) {
            if (j != i + 1 && j != i + edge && j != i + edge * edge) continue;  // others are far from touching
            const bool overlaps = rational_side(spheres[i], spheres[j], Rational(spheres[i][3]) + spheres[j][3]) < 0;
            if (overlaps) wanted += fmt::format("{} {}\n", i, j);
            ++(overlaps ? pairs : apart);
          }
        for (const std::string& file : {npy_of(spheres), text_of_spheres(spheres)}) {
          PairsOptions asked = options("pairs.txt");
          asked.input_file = file;
          ASSERT_EQ(run(asked), "");
          ASSERT_EQ(read_bytes(asked.output_file), wanted) << at << ", 1e" << exponent << ", " << sign;
          ASSERT_EQ(errors_, "");
        }
      }
  EXPECT_GT(pairs, 5000u);
  EXPECT_GT(apart, 5000u);
}

TEST_F(ExactPairs, AreTheSameOnEveryBackend) {
  const auto spheres = lattice(1e6, 0.1, 0.05);
  std::string wanted;
  for (const char* method : {"", "collide_grid"})
    for (const OpenedBackend& entry : all_backends()) {
      if (!entry.backend) continue;
      PairsOptions asked = options("pairs.csv");
      asked.backend = entry.name, asked.method = method;
      asked.geometry = true;
      asked.input_file = npy_of(spheres);
      ASSERT_EQ(run(asked), "") << entry.name;
      const std::string written = read_bytes(asked.output_file);
      if (wanted.empty()) wanted = written;
      ASSERT_EQ(written, wanted) << entry.name << " " << method;
    }
  EXPECT_GT(std::ranges::count(wanted, '\n'), 100);
}

TEST_F(ExactPairs, ACutoffIsMetByTheNumbersOfTheFile) {
  const auto points = lattice(1e6, 0.1, 0);
  for (const double cutoff : {0.1, std::nextafter(0.1, 0), 0.1 + 1e-10, 0.1 - 1e-10}) {
    PairsOptions asked = options("pairs.txt");
    asked.input_file = npy_of(points);
    asked.cutoff = cutoff;
    std::string wanted = "# i j\n";
    for (uint i = 0; i < points.size(); ++i)
      for (uint j = i + 1; j < points.size(); ++j)
        if (rational_side(points[i], points[j], cutoff) <= 0) wanted += fmt::format("{} {}\n", i, j);
    ASSERT_EQ(run(asked), "");
    ASSERT_EQ(read_bytes(asked.output_file), wanted) << cutoff;
  }
}

// One sphere lost far out must not make the search slow or large: the others keep their places.
TEST_F(ExactPairs, OneSphereFarOutCostsTheOthersNothing) {
  std::vector<Sphere> spheres;
  for (uint k = 0; k < 100'000; ++k)
    spheres.push_back({0.1 * (k % 50), 0.1 * (k / 50 % 50), 0.1 * (k / 2500), 0.05 + 1e-14});
  spheres.push_back({1e12, -1e12, 1e12, 1});
  for (const double lost : {1e12, -1e12}) {
    spheres.back() = {lost, -lost, lost, 1};
    PairsOptions asked = options("pairs.npy");
    asked.input_file = npy_of(spheres);
    ASSERT_EQ(run(asked), "");
    EXPECT_NE(output_.find("293500 pairs, 100000 of 100001 spheres"), std::string::npos) << output_;
  }
}

TEST_F(ExactPairs, NumbersBeyondTheRangeOfListsAreNamed) {
  PairsOptions asked = options("pairs.txt");
  asked.input_file = folder_.write("tiny.txt", "0 0 0 1\n1e-200 0 0 1\n");
  EXPECT_NE(run(asked).find("tiny.txt: positions[1].x is 1e-200: numbers other than 0 must be from 2^-450"),
            std::string::npos);
}

}  // namespace
}  // namespace spherepair
