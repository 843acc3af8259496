// SPDX-License-Identifier: MIT
// Bad files of spheres are refused, and the message says where, what was expected and what was found.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/bench/sphere_complaints.h"

namespace spherepair {
namespace {

const std::string dict = npy_header("<f4", "(2, 3)");
const std::string six = npy_data<float>({1, 2, 3, 4, 5, 6}, 3);

TEST(BadSphereFile, NpyBeginning) {
  const std::string good = npy_file(dict, six);
  expect_npy_complaint("", 0, "magic string", "an empty file");
  expect_npy_complaint("PK\x03\x04 this is a zip", 0, "magic string", "a zip archive (.npz, .zip)");
  expect_npy_complaint("\x1f\x8b\x08 packed", 0, "magic string", "a gzip file");
  expect_npy_complaint("2\nxyz\n", 0, "magic string", "'2\\x0axyz\\x0a'");
  expect_npy_complaint(good.substr(0, 7), 7, "version", "the end of the file");
  expect_npy_complaint(npy_file(dict, six, 4), 6, "NPY version 1.0, 2.0 or 3.0", "version 4.0");
  expect_npy_complaint(npy_file(dict, six, 0), 6, "NPY version", "version 0.0");
  expect_npy_complaint(good.substr(0, 9), 9, "the header's length", "the end of the file");
  expect_npy_complaint(npy_file(dict, six, 2).substr(0, 11), 11, "the header's length", "the end of the file");
  expect_npy_complaint(good.substr(0, 100), 8, "a header that ends within the file",
                       "one of 118 bytes in a file of 100");
  expect_npy_complaint(std::string("\x93NUMPY\x02\x00\xff\xff\xff\xff{", 13), 8, "ends within", "one of 4294967295");
}

TEST(BadSphereFile, NpyHeader) {
  const auto header = [](const std::string& text) { return npy_file(text, six); };
  expect_npy_complaint(header(""), 64, "'{'", "the end of the header");
  expect_npy_complaint(header("['<f4', False, (2, 3)]"), 10, "'{'", "'['<f4'");
  expect_npy_complaint(header("{'descr': '<f4', 'fortran_order': False, }"), 10, "the key 'shape'", "none");
  expect_npy_complaint(header("{'descr': '<f4', 'shape': (2, 3), }"), 10, "the key 'fortran_order'", "none");
  expect_npy_complaint(header("{'shape': (2, 3), 'fortran_order': False, }"), 10, "the key 'descr'", "none");
  expect_npy_complaint(header("{'descr': '<f4', 'colour': 3}"), 27, "'descr', 'fortran_order' or 'shape'", "'colour'");
  expect_npy_complaint(header("{'descr' '<f4'}"), 19, "':'", "''<f4'}");
  expect_npy_complaint(header("{'descr': '<f4' 'shape': (2, 3)}"), 26, "',' or '}'", "''shape'");
  expect_npy_complaint(header("{'descr': '<f4"), 20, "a dtype in quotes", "''<f4");
  expect_npy_complaint(header("{descr: '<f4'}"), 11, "in quotes", "'descr");
  expect_npy_complaint(header("{'fortran_order': 0}"), 28, "True or False", "'0}");
  expect_npy_complaint(header("{'shape': 6}"), 20, "in parentheses", "'6}");
  expect_npy_complaint(header("{'shape': (2, -3)}"), 24, "a whole number", "'-3)}");
  expect_npy_complaint(header("{'shape': (2 3)}"), 23, "',' or ')'", "'3)}");
  expect_npy_complaint(header("{'shape': (99999999999999999999, 3)}"), 21, "a whole number", "'9999");
  expect_npy_complaint(header(dict + " {}"), 10 + dict.size() + 1, "nothing but spaces", "'{}");
}

TEST(BadSphereFile, NpyLayout) {
  const auto shaped = [](const std::string& shape) { return npy_file(npy_header("<f4", shape), six); };
  for (const char* dtype : {"<f3", "<i3", "|b1", "<c8", "<U3", "f4", "|f4", ""})
    expect_npy_complaint(npy_file(npy_header(dtype, "(2, 3)"), six), 20, "float32", fmt::format("'{}'", dtype));
  for (const char* shape : {"(6,)", "(2, 3, 1)", "()", "(3, 2)", "(1, 6)", "(2, 5)"})
    expect_npy_complaint(shaped(shape), 60, "(n, 3)", shape);
  expect_npy_complaint(shaped("(2147483648, 3)"), 60, "at most 2147483647 spheres", "(2147483648, 3)");
  expect_npy_complaint(npy_file(dict, six.substr(0, 23)), 151, "24 bytes of data from byte 128",
                       "the end of the file after 23");
  expect_npy_complaint(npy_file(dict, ""), 128, "24 bytes of data", "the end of the file after 0");
  expect_npy_complaint(shaped("(2147483647, 3)"), 152, "25769803764 bytes of data", "the end of the file after 24");
  expect_npy_complaint(npy_file(dict, six + "?"), 152, "the end of the file", "1 trailing byte");
  expect_npy_complaint(npy_file(npy_header("<f8", "(1, 3)"), six + six), 152, "the end", "24 trailing bytes");
}

TEST(BadSphereFile, NpyRowsOfFields) {
  const std::string xyz = "[('x', '<f4'), ('y', '<f4'), ('z', '<f4')";
  const auto structured = [&](const std::string& fields, const std::string& shape) {
    return npy_file(fmt::format("{{'descr': {}], 'fortran_order': False, 'shape': {}}}", fields, shape), six);
  };
  expect_npy_complaint(structured(xyz, "(2,)"), 27, "fields of 4 columns, by --columns", "3",
                       {.columns = {"x", "y", "z", "radius"}});
  // Rows of 2^34 bytes: 2^30 of them have 2^64 bytes.
  const std::string wide = structured(xyz + ", ('p', 'V131072', (131071,)), ('q', 'V131060')", "(1073741824,)");
  expect_npy_complaint(wide.substr(0, wide.size() - six.size()), wide.size() - six.size(), "of data from byte",
                       "the end of the file after 0");
}

TEST(BadSphereFile, NpyValues) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const auto with = [](size_t place, double value, size_t columns, bool fortran_order = false,
                       bool big_endian = false) {
    std::vector<double> rows(3 * columns, 1);
    rows[place] = value;
    const std::string dtype = big_endian ? ">f8" : "<f8", shape = fmt::format("(3, {})", columns);
    return npy_file(npy_header(dtype, shape, fortran_order), npy_data(rows, columns, big_endian, fortran_order));
  };
  expect_npy_complaint(with(0, nan, 3), 128, "a finite number",
                       "nan (x of sphere 0; the first of 1 such numbers of 9)");
  expect_npy_complaint(with(5, -infinity, 3), 128 + 40, "a finite number", "-inf (z of sphere 1");
  expect_npy_complaint(with(5, infinity, 3, false, true), 128 + 40, "a finite number", "inf (z of sphere 1");
  expect_npy_complaint(with(5, nan, 3, true), 128 + 8 * 7, "a finite number", "nan (z of sphere 1");
  for (double beyond : {1e39, 0x1.ffffffp127, -1e300})
    expect_npy_complaint(with(4, beyond, 3), 128 + 32, "the range of float32", fmt::format("{} (y of", beyond));
  for (double radius : {-0.5, -1e-300})
    expect_npy_complaint(with(7, radius, 4), 128 + 56, "not negative", fmt::format("{} (radius of", radius), {});
  expect_npy_complaint(with(11, infinity, 4), 128 + 88, "a finite number", "inf (radius of sphere 2", {});

  std::vector<float> rows(600'000, 1);
  rows[599'999] = rows[300'000] = rows[300'004] = float(nan);
  const std::string many = npy_file(npy_header("<f4", "(200000, 3)"), npy_data(rows, 3));
  for (int threads : {0, 1, 4})
    expect_npy_complaint(many, 128 + 4 * 300'000, "a finite number",
                         "nan (x of sphere 100000; the first of 3 such numbers of 600000)",
                         {.radius = 1, .threads = threads});
}

TEST(BadSphereFile, XyzLines) {
  expect_xyz_complaint("", 1, "the number of spheres", "the end of the file");
  expect_xyz_complaint("\n\n", 1, "the number of spheres", "''");
  for (const char* count : {"abc", "2.5", "-1", "2 3", "1e3", "+2", "99999999999999999999"})
    expect_xyz_complaint(fmt::format("{}\n\n1 2 3\n", count), 1, "the number of spheres", fmt::format("'{}'", count));
  expect_xyz_complaint("3000000000\n\n", 1, "at most 2147483647", "3000000000");
  expect_xyz_complaint("1", 2, "the comment line", "the end of the file");
  expect_xyz_complaint("3\n\n1 2 3\n4 5 6\n", 5, "3 spheres as line 1 says", "the end of the file after 2");
  expect_xyz_complaint("2147483647\n\n1 2 3\n", 4, "2147483647 spheres", "the end of the file after 1");
  expect_xyz_complaint("1\n\n1 2 3\n4 5 6\n", 4, "another frame, or the end", "'4 5 6'");
  expect_xyz_complaint("1\n\n1 2 3\n1\n", 5, "the comment line", "the end of the file");
  expect_xyz_complaint("1\n\n1 2 3\n\n2\n\n1 2 3\n", 8, "2 spheres as line 5 says", "the end of the file after 1");
}

TEST(BadSphereFile, XyzColumns) {
  expect_xyz_complaint("1\n\nH 1 2\n", 3, "4 columns, species x y z", "3: 'H 1 2'");
  expect_xyz_complaint("1\n\n1 2\n", 3, "3 columns, x y z", "2: '1 2'");
  expect_xyz_complaint("1\n\n\n", 3, "3 columns", "0: ''");
  expect_xyz_complaint("1\n\nH 1 2 3 4 5\n", 3, "others need Properties=", "6: ");
  expect_xyz_complaint("2\n\nH 1 2 3\nH 1 2\n", 4, "4 columns (species x y z)", "3: 'H 1 2'");
  expect_xyz_complaint("2\n\n1 2 3\n1 2 3 4\n", 4, "3 columns (x y z)", "more than 3: ");
  expect_xyz_complaint("1\nProperties=species:S:1:pos:R:3\nH 1 2\n", 3, "4 columns ('species:S:1:pos:R:3')", "3: ");
  for (const char* properties : {"pos:R", "pos:R:3:radius", "pos:R:x", "pos:Q:3", "pos:R:2", "pos:S:3", "pos:R:0",
                                 "species:S:1", "pos:R:3:pos:R:3", "pos:R:3:radius:R:2", "pos:R:3:radius:S:1", "\"\""})
    EXPECT_NO_FATAL_FAILURE(
        expect_xyz_complaint(fmt::format("1\nProperties={}\n1 2 3\n", properties), 2, "Properties",
                             properties == std::string("\"\"") ? "''" : fmt::format("'{}'", properties)));
}

TEST(BadSphereFile, XyzValues) {
  expect_xyz_complaint("2\n\nH 1 2 3\nH 1 abc 3\n", 4, "a number for y in column 3", "'abc'");
  expect_xyz_complaint("1\n\n1 2 3,\n", 3, "a number for z in column 3", "'3,'");
  for (const char* wrong : {"nan", "inf", "-infinity", "1e39", "-1e999"})
    expect_xyz_complaint(fmt::format("1\n\n1 2 {}\n", wrong), 3, "a finite number within the range of float32 for z",
                         fmt::format("'{}'", wrong));
  for (const char* radius : {"-0.5", "-1e-300"})
    expect_xyz_complaint(fmt::format("1\n\nH 1 2 3 {}\n", radius), 3, "a radius that is not negative",
                         fmt::format("'{}'", radius), {});
  expect_xyz_complaint(fmt::format("1\n\n1 {} 3\n", std::string(500, 'x')), 3, "a number", "'xxx");
  // Of two errors far apart, the first in the file, on any number of threads.
  std::string text = "100000\n\n";
  for (int i = 0; i < 100000; ++i) text += i == 40000 || i == 90000 ? fmt::format("1 2 bad{}\n", i) : "1 2 3\n";
  for (int threads : {0, 1, 4})
    expect_xyz_complaint(text, 40003, "a number for z", "'bad40000'", {.radius = 1, .threads = threads});
}

TEST(BadSphereFile, OptionsThatDoNotFit) {
  const ScratchFolder folder;
  const auto complaint = [&](const std::string& name, const std::string& bytes, const SphereFileOptions& options) {
    return complaint_of([&] { read_sphere_file(folder.write(name, bytes), options); });
  };
  const auto expect = [](const std::string& text, const char* word) { EXPECT_NE(text.find(word), text.npos) << text; };
  const std::string four = npy_file(npy_header("<f4", "(1, 4)"), npy_data<float>({1, 2, 3, 4}, 4));
  expect(complaint("a.npy", npy_file(dict, six), {}), "give the radius of all spheres with --radius");
  expect(complaint("a.npy", four, {.radius = 1}), "omit --radius if column 4 holds radii");
  expect(complaint("a.xyz", "1\n\nH 1 2 3\n", {}), "give the radius of all spheres with --radius");
  expect(complaint("a.xyz", "1\n\nH 1 2 3 4\n", {.radius = 1}), "omit --radius if column 5 holds radii");
  for (float radius : {-1.0f, std::nanf(""), std::numeric_limits<float>::infinity()})
    expect(complaint("a.xyz", "1\n\nH 1 2 3\n", {.radius = radius}), "finite and not negative");
  expect(complaint("a.xyz", "1\n\n1 2 3\n", {.radius = 1, .frame = 1}), "has 1 frame, counted from 0");
  expect(complaint("a.npy", four, {.frame = 0}), "--frame is for extended XYZ and LAMMPS dump");
  for (const char* name : {"a.log", "a", "a.xyz.gz", ".xyz"}) expect(complaint(name, six, {}), ".extxyz");
  expect(complaint_of([&] { read_sphere_file(folder.path("none.npy"), {}); }), "No such file");
  std::filesystem::create_directory(folder.path("folder.xyz"));
  expect(complaint_of([&] { read_sphere_file(folder.path("folder.xyz"), {}); }), "Is a directory");
}

}  // namespace
}  // namespace spherepair
