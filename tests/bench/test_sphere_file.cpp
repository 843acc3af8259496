// SPDX-License-Identifier: MIT
// Spheres read from NPY and XYZ files: the same bits whatever the layout, and what was rounded is counted.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <fstream>

#include "bench/spheres/columns.h"
#include "tests/bench/sphere_readings.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

std::vector<vec4> some_spheres(size_t n, bool own_radii) {
  std::vector<vec4> spheres = make_scene({.name = "clustered", .n = n, .radius_ratio = 100}).positions;
  for (vec4& sphere : spheres) sphere.w = own_radii ? sphere.w : 0.25f;
  return spheres;
}

template <typename Real>
std::vector<Real> rows_of(const std::vector<vec4>& spheres, size_t columns) {
  std::vector<Real> rows;
  for (const vec4& sphere : spheres)
    for (size_t c = 0; c < columns; ++c) rows.push_back(Real((&sphere.x)[c]));
  return rows;
}

template <typename Real>
void expect_every_layout(const std::vector<vec4>& spheres, size_t columns) {
  SphereFileOptions options;
  if (columns == 3) options.radius = 0.25f;
  for (char version : {1, 2, 3})
    for (bool big_endian : {false, true})
      for (bool fortran_order : {false, true}) {
        const std::string dtype = fmt::format("{}f{}", big_endian ? '>' : '<', sizeof(Real));
        const std::string shape = fmt::format("({}, {})", spheres.size(), columns);
        const std::string data = npy_data(rows_of<Real>(spheres, columns), columns, big_endian, fortran_order);
        SCOPED_TRACE(fmt::format("version {}, {}, {}, {}", int(version), dtype, shape, fortran_order));
        const SphereFile input =
            read_from(npy_file(npy_header(dtype, shape, fortran_order), data, version), options, "npy");
        expect_spheres(input, spheres);
        EXPECT_EQ(input.own_radii, columns == 4);
        EXPECT_EQ(input.values, spheres.size() * columns);
        EXPECT_EQ(input.changed, 0u);
        EXPECT_EQ(input.scene.equal_radii, columns == 3 || spheres.size() < 2);
      }
}

TEST(SphereFile, NpyInEveryLayout) {
  for (size_t n : {0, 1, 2, 5, 1000}) {
    expect_every_layout<float>(some_spheres(n, false), 3);
    expect_every_layout<float>(some_spheres(n, true), 4);
    expect_every_layout<double>(some_spheres(n, false), 3);
    expect_every_layout<double>(some_spheres(n, true), 4);
  }
}

// More rows than a thread takes at once.
TEST(SphereFile, NpyOnAnyNumberOfThreads) {
  const std::vector<vec4> spheres = some_spheres(200'000, true);
  const std::string file =
      scratch().write("many.npy", npy_file(npy_header("<f4", "(200000, 4)"), npy_data(rows_of<float>(spheres, 4), 4)));
  for (int threads : {0, 1, 3}) expect_spheres(read_sphere_file(file, {.threads = threads}), spheres);
}

TEST(SphereFile, NpyHeadersAsOthersWriteThem) {
  const std::string data = npy_data<float>({1, 2, 3}, 3);
  for (const char* header : {"{\"shape\":(1,3),\"fortran_order\":False,\"descr\":\"<f4\"}",
                             "{ 'descr' : '=f4' , 'fortran_order' : True , 'shape' : ( 1L , 3L , ) , }",
                             "{'fortran_order': False, 'descr': '<f4', 'shape': (1, 3)}"})
    expect_spheres(read_from(npy_file(header, data), {.radius = 2}, "npy"), {{1, 2, 3, 2}});
}

TEST(SphereFile, NpyCountsWhatFloat32CannotHold) {
  const float rounded = float(0.1), smallest = 0x1p-149f;
  const std::vector<double> values = {0.5, 0.1, 1e-60, 16777217, double(rounded), 3e38, -0.0, double(smallest)};
  std::vector<double> rows(12, 1);
  std::copy(values.begin(), values.end(), rows.begin());
  const std::string bytes = npy_file(npy_header("<f8", "(4, 3)"), npy_data(rows, 3));
  const SphereFile input = read_from(bytes, {.radius = 1}, "npy");
  EXPECT_EQ(input.changed, 4u) << "0.1, 1e-60, 16777217 and 3e38";
  EXPECT_EQ(input.values, 12u);
  expect_spheres(input, {{0.5f, rounded, 0, 1}, {16777216, rounded, 3e38f, 1}, {-0.0f, smallest, 1, 1}, {1, 1, 1, 1}});
  EXPECT_NE(describe(input).find("4 of 12 numbers have more digits than float32 keeps"), std::string::npos);
}

TEST(SphereFile, ClassicXyz) {
  const std::vector<vec4> equal = {{1, -2.5f, 3, 0.25f}, {4, 5, 6, 0.25f}}, own = {{1, 2, 3, 0.5f}, {4, 5, 6, 0.75f}};
  const SphereFileOptions radius = {.radius = 0.25f};
  expect_spheres(read_from("2\na comment\nH 1 -2.5 3\nC4 4 5 6\n", radius), equal);
  expect_spheres(read_from("2\n\n1 -2.5 3\n4 5 6", radius), equal);
  expect_spheres(read_from(" 2 \r\nhello\r\n\tH\t1  -2.5e0 +3.0 \r\n C 4. 5 .6e1\r\n\r\n \r\n", radius), equal);
  expect_spheres(read_from("2\n\nH 1 2 3 0.5\nH 4 5 6 0.75\n"), own);
  expect_spheres(read_from("2\n\n1. 2 3 0.5\n4 5 6 75e-2\n"), own);
  expect_spheres(read_from("0\nnothing\n"), {});
}

TEST(SphereFile, ExtendedXyzFindsColumnsByName) {
  const std::vector<vec4> own = {{1, 2, 3, 0.5f}, {4, 5, 6, 0.75f}};
  expect_spheres(read_from("2\nProperties=species:S:1:pos:R:3:radius:R:1\nH 1 2 3 0.5\nHe 4 5 6 0.75\n"), own);
  expect_spheres(read_from("2\nLattice=\"9 0 0  0 9 0  0 0 9\" Properties=radius:R:1:force:R:2:pos:R:3 pbc=\"F F F\"\n"
                           "0.5 9 9 1 2 3\n0.75 9 9 4 5 6\n",
                           {}, "extxyz"),
                 own);
  expect_spheres(
      read_from("2\nnote='Properties=pos:R:3' \"a key\"={x y} flag Properties=\"id:I:1:pos:I:3:radius:R:1\"\n"
                "7 1 2 3 .5\n8 4 5 6 .75\n"),
      own);
  // A number in front is the species here, since the properties say so.
  expect_spheres(read_from("1\nProperties=species:S:1:pos:R:3\n6 1 2 3\n", {.radius = 1}), {{1, 2, 3, 1}});
}

TEST(SphereFile, ExtendedXyzKnowsRadiiAndVelocities) {
  const SphereFile input = read_from("1\nProperties=pos:R:3:radii:R:1:velo:R:3\n1 2 3 .5 6 7 8\n");
  ASSERT_EQ(input.scene.size(), 1u);
  EXPECT_EQ(input.scene.positions[0].w, 0.5f);
  EXPECT_EQ(input.scene.velocities[0].z, 8);
}

TEST(SphereFile, WithoutASpeedIsAtRestInEveryFormat) {
  const ScratchFolder folder;
  const auto at_rest = [&](const std::string& name, const std::string& text) {
    return read_sphere_file(folder.write(name, text), {}).at_rest;
  };
  EXPECT_TRUE(at_rest("a.txt", "0 0 0 1\n3 0 0 1\n"));
  EXPECT_TRUE(at_rest("a.csv", "x,y,z,radius\n0,0,0,1\n"));
  EXPECT_TRUE(at_rest("a.xyz", "1\n\n0 0 0 1\n"));
  EXPECT_FALSE(at_rest("b.txt", "0 0 0 1 0 0 0\n3 0 0 1 0 2.5 0\n"));
  EXPECT_FALSE(at_rest("b.xyz", "1\nProperties=pos:R:3:radius:R:1:velo:R:3\n0 0 0 1 0 0 2\n"));
}

TEST(SphereFile, ExtendedXyzSaysThatMomentaAreNoVelocities) {
  const auto says = [](const std::string& text) {
    return describe(read_from(text)).find("momenta are not read") != std::string::npos;
  };
  const std::string row = " 1 2 3 .5 6 7 8\n", both = " 1 2 3 .5 6 7 8 6 7 8\n";
  EXPECT_TRUE(says("1\nProperties=pos:R:3:radius:R:1:momenta:R:3\n" + row));
  EXPECT_FALSE(says("1\nProperties=pos:R:3:radius:R:1:velo:R:3\n" + row));
  EXPECT_FALSE(says("1\nProperties=pos:R:3:radius:R:1:momenta:R:3:velo:R:3\n" + both));
}

TEST(SphereFile, FramesOfXyz) {
  const std::string frames = "1\nfirst\n1 2 3\n\n2\nProperties=pos:R:3:radius:R:1\n4 5 6 1\n7 8 9 2\n0\n\n";
  const SphereFile first = read_from(frames, {.radius = 1});
  expect_spheres(first, {{1, 2, 3, 1}});
  EXPECT_EQ(first.frames, 3u);
  EXPECT_NE(describe(first).find("frame 0 of 3"), std::string::npos) << describe(first);
  expect_spheres(read_from(frames, {.radius = 1, .frame = 0}), {{1, 2, 3, 1}});
  expect_spheres(read_from(frames, {.frame = 1}), {{4, 5, 6, 1}, {7, 8, 9, 2}});
  expect_spheres(read_from(frames, {.frame = 2}), {});
  EXPECT_EQ(read_from("1\n\n1 2 3\n", {.radius = 1}).frames, 1u);
}

// Lines are shared out among threads.
TEST(SphereFile, LongXyz) {
  const std::vector<vec4> spheres = some_spheres(100'000, true);
  std::string text = fmt::format("{}\n\n", spheres.size());
  for (const vec4& s : spheres) text += fmt::format("Ar {} {} {} {}\n", s.x, s.y, s.z, s.w);
  for (int threads : {0, 1, 3}) {
    const SphereFile input = read_from(text, {.threads = threads});
    expect_spheres(input, spheres);
    EXPECT_EQ(input.changed, 0u) << "the shortest decimals are kept to their last digit";
  }
}

TEST(SphereFile, DecimalsAreRoundedOnceAndCounted) {
  for (const char* kept : {"0.1", "0.100000001", "0.100000001490116119384765625", "-1e30", "0", "-0.0", "16777216",
                           "1.17549435e-38", "1.4e-45", "123456.789", "0e-999", "3.40282347e+38"})
    EXPECT_FALSE(parse_decimal(kept).value().changed) << kept;
  for (const char* changed :
       {"0.1000000000", "0.123456789", "16777217", "1e-60", "1e-999", "-2.00000001", "1234567.89"})
    EXPECT_TRUE(parse_decimal(changed).value().changed) << changed;
  // A hair above the middle of two floats, and exactly there for float64.
  EXPECT_EQ(parse_decimal("1.00000005960464477539062500001").value().rounded, 0x1.000002p0f);
  EXPECT_EQ(parse_decimal("1.00000005960464477539062500000").value().rounded, 1);
  for (const char* wrong : {"", "+", "+-1", "1,5", "0x10", "1e", "1 2", "abc", "1.5f"})
    EXPECT_FALSE(parse_decimal(wrong)) << wrong;
}

RC_GTEST_PROP(SphereFile, ShortestDecimalAndNineDigitsKeepEveryFloat32, ()) {
  const float value = bits_float(*rc::gen::arbitrary<uint>());
  RC_PRE(std::isfinite(value));
  std::array<char, 32> shortest;
  const auto end = std::to_chars(shortest.begin(), shortest.end(), value, std::chars_format::scientific).ptr;
  for (const std::string& text : {std::string(shortest.begin(), end), fmt::format("{:.8e}", value)}) {
    const auto decimal = parse_decimal(text);
    RC_ASSERT(decimal && float_bits(decimal->rounded) == float_bits(value) && !decimal->changed);
  }
}

TEST(SphereFile, TenMillionPointsAreReadWhole) {
  if (!full_stress()) GTEST_SKIP() << "writes 120 MB; STRESS=full asks for it";
  const size_t n = 10'000'000;
  const ScratchFolder folder;
  const std::string file = folder.path("points.npy");
  {
    std::ofstream stream(file, std::ios::binary);
    stream << npy_file(npy_header("<f4", fmt::format("({}, 3)", n)), "");
    const std::vector<float> rows = rows_of<float>(make_scene({.name = "uniform", .n = n}).positions, 3);
    stream.write(reinterpret_cast<const char*>(rows.data()), std::streamsize(rows.size() * sizeof(float)));
  }
  const auto start = std::chrono::steady_clock::now();
  const SphereFile input = read_sphere_file(file, {.radius = 0.5f});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fmt::print("{} points in {:.3f} s\n", input.scene.size(), seconds);
  EXPECT_EQ(state_hash(input.scene.positions, {}), state_hash(make_scene({.name = "uniform", .n = n}).positions, {}));
}

}  // namespace
}  // namespace spherepair
