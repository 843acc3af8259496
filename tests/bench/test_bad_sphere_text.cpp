// SPDX-License-Identifier: MIT
// Bad columns, fields, boxes and kinds of files are refused where they are.
#include "tests/bench/sphere_complaints.h"

namespace spherepair {
namespace {

TEST(BadSphereFile, NpyFields) {
  const auto file = [](const std::string& fields) {
    return npy_file("{'descr': " + fields + ", 'fortran_order': False, 'shape': (1,)}",
                    npy_data<float>({1, 2, 3, 4, 5, 6}, 3));
  };
  expect_npy_complaint(file("[]"), 64, "fields", "none");
  expect_npy_complaint(file("[('x', '<f4')"), 35, "a field in parentheses", "''fort");
  expect_npy_complaint(file("['x', '<f4']"), 21, "a field in parentheses", "''x'");
  expect_npy_complaint(file("[(('title', 'x'), '<f4')]"), 22, "a field's name", "'('title");
  expect_npy_complaint(file("[('x', [('a', '<f4')])]"), 27, "a dtype in quotes", "'[('a'");
  expect_npy_complaint(file("[('x', '<f4', 3)]"), 34, "in parentheses", "'3)]");
  expect_npy_complaint(file("[('x', '<f4', (3, 3))]"), 34, "one axis", "(3, 3)");
  expect_npy_complaint(file("[('x', '<f4', (3,), 1)]"), 38, "')'", "', 1)]");
  expect_npy_complaint(file("[('x', '|O')]"), 27, "fixed size", "'|O'");
  expect_npy_complaint(file("[('pos', '<U3', (3,))]"), 29, "float32", "'<U3'");
  const ScratchFolder folder;
  const auto complaint = [&](const std::string& fields) {
    return complaint_of([&] { read_sphere_file(folder.write("a.npy", file(fields)), {.radius = 1}); });
  };
  EXPECT_NE(complaint("[('x', '<f4'), ('y', '<f4')]").find("x, y and z must be among 'x y'"), std::string::npos);
  EXPECT_NE(complaint("[('x', '<f4'), ('x', '<f4')]").find("x stands twice"), std::string::npos);
  EXPECT_NE(complaint("[('pos', '<f4', (3,)), ('vx', '<f4')]").find("only some"), std::string::npos);
}

// What is beyond the boundary of a periodic box would be missed in silence.
TEST(BadSphereFile, XyzWithAPeriodicBox) {
  const auto file = [](const std::string& box) { return "1\n" + box + " Properties=pos:R:3\n1 2 3\n"; };
  const std::string lattice = "Lattice=\"9 0 0 0 9 0 0 0 9\"";
  for (const std::string& box :
       {lattice, lattice + " pbc=\"T F F\"", std::string("pbc=\"F F T\""), "pbc=[1, 0, 0] " + lattice})
    expect_xyz_complaint(file(box), 2, "--ignore-periodic", box.starts_with("pbc=\"") ? "pbc='F F T'" : "Lattice='9 0");
  expect_xyz_complaint(file("PBC=\"F F T\""), 2, "--ignore-periodic", "pbc='F F T'");
  expect_xyz_complaint(file("lattice=\"9 0 0\""), 2, "--ignore-periodic", "Lattice='9 0 0'");
  expect_xyz_complaint(file("cell=\"9 0 0 0 9 0 0 0 9\""), 2, "--ignore-periodic", "cell='9 0 0 0 9");
  expect_xyz_complaint(file("pbc=\"T T\""), 2, "pbc with T or F", "'T T'");
  expect_xyz_complaint(file("pbc=\"T T yes\""), 2, "pbc with T or F", "'T T yes'");
  const ScratchFolder folder;
  for (const std::string& open : {folder.write("none.xyz", file("")), folder.write("off.xyz", file("pbc=\"F F F\"")),
                                  folder.write("a.txt", "1 2 3\n"), folder.write("a.csv", "x,y,z\n1,2,3\n")})
    EXPECT_NE(complaint_of([&] {
                read_sphere_file(open, {.radius = 1, .ignore_periodic = true});
              }).find("has no periodic box"),
              std::string::npos)
        << open << ": the option changes nothing";
  for (const std::string& box : {lattice + " pbc=\"F F F\"", std::string("pbc=\"0 false F\" cell=\"9 0 0\"")})
    EXPECT_EQ(read_sphere_file(folder.write("open.xyz", file(box)), {.radius = 1}).ignored, "") << box;
  const SphereFile input =
      read_sphere_file(folder.write("box.xyz", file(lattice)), {.radius = 1, .ignore_periodic = true});
  EXPECT_EQ(input.ignored, "Lattice='9 0 0 0 9 0 0 0 9'");
  EXPECT_NE(describe(input).find("Lattice='9 0 0 0 9 0 0 0 9' is ignored"), std::string::npos) << describe(input);
}

TEST(BadSphereFile, OtherKindsAreNamed) {
  for (const auto& [bytes, kind] : {std::pair("PK\x03\x04 zip", "a zip archive"),
                                    {"\x1f\x8b\x08 gz", "a gzip file"},
                                    {"\x89HDF\r\n", "an HDF5 file"},
                                    {"\x93NUMPY\x01", "an NPY file"},
                                    {"\xff\xfe 1", "UTF-16 text"},
                                    {"\x89PNG\r", "a PNG image"}})
    for (const char* name : {"bad.xyz", "bad.txt", "bad.csv"})
      expect_complaint(name, bytes, "line 1", "text", kind, {.radius = 1});
}

TEST(BadSphereFile, TextLines) {
  const auto expect_text_complaint = [](const std::string& text, uint64_t line, const std::string& expected,
                                        const std::string& found, const SphereFileOptions& options = {}) {
    expect_complaint("bad.txt", text, fmt::format("line {}", line), expected, found, options);
  };
  expect_text_complaint("1 2 3 4 5\n", 1, "others need --columns", "5");
  expect_text_complaint("# x y\n\n1 2 3 4\n1 2 3\n", 4, "4 columns (x y z radius)", "3: '1 2 3'");
  expect_text_complaint("1 2 3 4\n1 x 3 4\n", 2, "a number for y in column 2", "'x'");
  expect_text_complaint("1,2,,4\n", 1, "a number for z in column 3", "''");
  expect_text_complaint("1;2;3;0,5\n", 1, "a number for radius in column 4", "'0,5'");
  expect_text_complaint("1,2,3,4,\n", 1, "others need --columns", "5");
  expect_text_complaint("1 2 3 -4\n", 1, "not negative", "'-4'");
  expect_text_complaint("1 2 3 4 5 6 7\n1 2 3 4 5 6 nan\n", 2, "a finite number within the range of float32 for vz",
                        "'nan'");
  expect_text_complaint("a 1 2 3 .5\nb 1 2 x .5\n", 2, "a number for z", "'x'",
                        {.columns = {"_", "x", "y", "z", "radius"}});
  const ScratchFolder folder;
  const auto complaint = [&](const std::string& text, const SphereFileOptions& options, const char* name = "a.txt") {
    return complaint_of([&] { read_sphere_file(folder.write(name, text), options); });
  };
  const auto expect = [](const std::string& text, const char* word) { EXPECT_NE(text.find(word), text.npos) << text; };
  for (const char* empty : {"", "\n\n", "# nothing\n", "x,y,z,radius\n"})
    expect(complaint(empty, {}), "holds no sphere");
  expect(complaint("1 2 3\n", {}), "with --radius");
  expect(complaint("1 2 3 4\n", {.radius = 1}), "omit --radius if column 4 holds radii");
  expect(complaint("x,y,z,r\n1,2,3,4\n", {.radius = 1}, "a.csv"), "leave --radius out");
  expect(complaint("1 2 3 4\n", {.frame = 0}), "--frame is for extended XYZ");
  expect(complaint("1 2 3 4\n", {.columns = {"x", "y", "radius", "_"}}), "x, y and z must be among 'x y radius _'");
  expect(complaint("1 2 3 4\n", {.columns = {"x", "y", "z", "z"}}), "the column z stands twice");
  expect(complaint("1 2 3 4\n", {.columns = {"x", "y", "z", "vx"}}), "only some");
  expect(complaint("a b\n1 2\n", {}), "x, y and z must be among 'a b'");
  EXPECT_EQ(complaint("1\n\n1 2 3\n", {.radius = 1, .columns = {"x", "y", "z"}}, "a.xyz"), "");
  EXPECT_EQ(complaint("1 2 3\n", {.radius = 1, .columns = {"x", "y", "z"}}, "a.log"), "");
}

}  // namespace
}  // namespace spherepair
