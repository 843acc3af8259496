// SPDX-License-Identifier: MIT
// pairs --cutoff finds the right pairs of points; --distances and --csr write them.
#include <cmath>

#include "tests/support/pairs_command.h"

namespace spherepair {
namespace {

// Points at many equal distances: the tie at the cutoff is common.
std::vector<vec4> cubic_points() {
  std::vector<vec4> points;
  for (int k = 0; k < 1000; ++k) points.push_back({float(k % 10) / 4, float(k / 10 % 10) / 4, float(k / 100) / 4, 0});
  return points;
}

std::vector<vec4> as_points(std::vector<vec4> points) {
  for (vec4& point : points) point.w = 0;
  return points;
}

std::string text_of_points(const std::vector<vec4>& points) {
  std::string text;
  for (const vec4& p : points) text += fmt::format("{} {} {}\n", double(p.x), double(p.y), double(p.z));
  return text;
}

// Every pair decided by the oracle, at most a float32 cutoff apart.
std::vector<Pair> pairs_within(std::vector<vec4> points, float cutoff) {
  for (vec4& point : points) point.w = cutoff / 2;
  std::vector<Pair> pairs;
  for (uint i = 0; i < points.size(); ++i)
    for (uint j = i + 1; j < points.size(); ++j)
      if (relation(points[i], points[j]) != Relation::apart) pairs.push_back({i, j});
  return pairs;
}

// The data of an NPY file, behind its header.
template <typename Number>
std::vector<Number> numbers_in(const std::string& file) {
  const std::string bytes = read_bytes(file);
  const size_t start = bytes.find('\n') + 1;
  std::vector<Number> numbers((bytes.size() - start) / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data() + start, numbers.size() * sizeof(Number));
  return numbers;
}

double long_distance(const vec4& a, const vec4& b) {
  const auto square = [](float p, float q) { return ((long double)p - q) * ((long double)p - q); };
  return double(std::sqrt(square(a.x, b.x) + square(a.y, b.y) + square(a.z, b.z)));
}

TEST_F(PairsCommand, CutoffFindsAllPointsUpToItAndOnIt) {
  const std::vector<vec4> random = as_points(spheres());
  for (const auto& [points, cutoff] :
       {std::pair{cubic_points(), 0.25f}, {cubic_points(), 0.75f}, {random, 0.3f}, {random, 0.f}}) {
    const std::vector<Pair> expected = pairs_within(points, cutoff);
    PairsOptions within = options("within.txt");
    within.input_file = folder_.write("points.txt", text_of_points(points));
    within.json_file = folder_.path("within.json");
    within.cutoff = cutoff;
    for (const char* method : {"parallel", "collide_grid"}) {
      within.method = method;
      EXPECT_EQ(run(within), "");
      EXPECT_EQ(read_bytes(within.output_file), text_of(expected)) << method << " " << cutoff;
    }
    const Fingerprint print = fingerprint(expected);
    const json record = json::parse(read_bytes(within.json_file));
    EXPECT_EQ(record.at("pairs"), expected.size());
    EXPECT_EQ(record.at("fingerprint"), hex64(print.a) + hex64(print.b));
    std::vector<uint> counts(points.size());
    for (const Pair& pair : expected) ++counts[pair.first], ++counts[pair.second];
    EXPECT_EQ(record.at("colliding_spheres"), std::count_if(counts.begin(), counts.end(), colliding));
  }
}

TEST_F(PairsCommand, CutoffDoesNotUseTheRadiiOfTheFile) {
  const std::vector<float> rows = {0, 0, 0, 9, 0.5f, 0, 0, 9, 2, 0, 0, 9};
  const std::string npy = folder_.write("a.npy", npy_file(npy_header("<f4", "(3, 4)"), npy_data(rows, 4)));
  for (const std::string& file :
       {npy, folder_.write("a.txt", "0 0 0 9\n0.5 0 0 9\n2 0 0 -1\n"),
        folder_.write("a.csv", "x,y,z,diameter\n0,0,0,9\n0.5,0,0,9\n2,0,0,9\n"),
        folder_.write("a.xyz", "3\n\nH 0 0 0 9\nH 0.5 0 0 9\nH 2 0 0 9\n"),
        folder_.write("a.extxyz", "3\nProperties=pos:R:3:radius:R:1\n0 0 0 9\n0.5 0 0 9\n2 0 0 9\n")}) {
    PairsOptions within = options("-");
    within.input_file = file;
    within.cutoff = 0.5;
    EXPECT_EQ(run(within), "") << file;
    EXPECT_EQ(output_, "0 1\n") << file;
    EXPECT_NE(errors_.find("3 points, cutoff 0.5; the file's radii are not used"), std::string::npos) << errors_;
  }
  PairsOptions types = options("-");
  types.cutoff = 0.5;
  types.input_file = folder_.write("types.xyz", "2\n\n1 0 0 0\n1 0 0 0.5\n");
  EXPECT_NE(run(types).find("--columns: the first of four numbers may be a type"), std::string::npos);
}

// 0.1 is no float32 number: a float32 cutoff would take this pair, whose distance is float32's 0.1.
TEST_F(PairsCommand, CutoffIsNotRounded) {
  PairsOptions within = options("-");
  within.cutoff = 0.1;
  within.input_file = folder_.write("single.txt", fmt::format("0 0 0\n{:.17g} 0 0\n", double(0.1f)));
  EXPECT_EQ(run(within), "");
  EXPECT_EQ(output_, "");
  within.cutoff = double(0.1f);
  EXPECT_EQ(run(within), "");
  EXPECT_EQ(output_, "0 1\n");
  within.input_file = folder_.write("tie.txt", "0 0 0\n0.1 0 0\n");
  within.cutoff = 0.1;
  EXPECT_EQ(run(within), "");
  EXPECT_EQ(output_, "0 1\n");
}

TEST_F(PairsCommand, WritesTheDistanceOfEachPair) {
  PairsOptions with = options("pairs.npy");
  with.distances = true;
  EXPECT_EQ(run(with), "");
  struct Row {
    uint i, j;
    double distance;
  };
  const std::vector<Row> rows = numbers_in<Row>(with.output_file);
  ASSERT_EQ(rows.size(), expected_.size());
  std::string text = "i,j,distance\n";
  for (size_t k = 0; k < rows.size(); ++k) {
    ASSERT_EQ((Pair{rows[k].i, rows[k].j}), expected_[k]);
    const double exact = long_distance(spheres()[rows[k].i], spheres()[rows[k].j]);
    ASSERT_LE(std::abs(rows[k].distance - exact), 0x1p-50 * exact) << k;
    text += fmt::format("{},{},{}\n", rows[k].i, rows[k].j, rows[k].distance);
  }
  with.output_file = folder_.path("pairs.csv");
  EXPECT_EQ(run(with), "");
  EXPECT_EQ(read_bytes(with.output_file), text);
  with.output_file = folder_.path("pairs.txt");
  EXPECT_EQ(run(with), "");
  std::ranges::replace(text, ',', ' ');
  EXPECT_EQ(read_bytes(with.output_file), "# " + text);
}

TEST_F(PairsCommand, WritesTheNeighboursOfEachSphere) {
  std::vector<std::vector<uint>> neighbours(spheres().size());
  for (uint i = 0; i < spheres().size(); ++i)
    for (uint j = 0; j < spheres().size(); ++j)
      if (i != j && relation(spheres()[i], spheres()[j]) == Relation::overlapping) neighbours[i].push_back(j);
  PairsOptions list = options("list.npy");
  list.csr = list.distances = true;
  EXPECT_EQ(run(list), "");
  EXPECT_EQ(folder_.names(),
            (std::vector<std::string>{"list.distances.npy", "list.neighbours.npy", "list.offsets.npy", "spheres.xyz"}));
  EXPECT_NE(read_bytes(folder_.path("list.offsets.npy")).find("'<u8', 'fortran_order': False, 'shape': (1501,)"),
            std::string::npos);
  const auto offsets = numbers_in<uint64_t>(folder_.path("list.offsets.npy"));
  const auto others = numbers_in<uint>(folder_.path("list.neighbours.npy"));
  const auto distances = numbers_in<double>(folder_.path("list.distances.npy"));
  ASSERT_EQ(offsets.size(), neighbours.size() + 1);
  ASSERT_EQ(distances.size(), others.size());
  EXPECT_EQ(offsets.front(), 0u);
  EXPECT_EQ(offsets.back(), others.size());
  for (size_t i = 0; i < neighbours.size(); ++i) {
    ASSERT_EQ(std::vector(others.begin() + long(offsets[i]), others.begin() + long(offsets[i + 1])), neighbours[i])
        << i;
    for (size_t k = offsets[i]; k < offsets[i + 1]; ++k)
      ASSERT_DOUBLE_EQ(distances[k], long_distance(spheres()[i], spheres()[others[k]]));
  }
}

}  // namespace
}  // namespace spherepair
