// SPDX-License-Identifier: MIT
// Names in comments, and names that other programs write beside those that are read.
#include "tests/files/columns_of_files.h"

namespace spherepair {
namespace {

const std::vector<vec4> two_halves = {{1, 2, 3, 0.5f}, {11, 2, 3, 0.5f}};

TEST(ColumnMeaning, ThreeComponentsStandBeforeOneAndLowerCaseBeforeUpper) {
  expect_cases({
      {"quip.xyz", "2\nProperties=species:S:1:pos:R:3:Z:I:1\nH 1 2 3 1\nO 11 2 3 8\n", sized, two_halves},
      {"quip.xyz", "2\nProperties=Z:I:1:pos:R:3:radius:R:1\n1 1 2 3 .5\n8 11 2 3 .5\n", {}, two_halves},
      {"quip.xyz", "2\nProperties=Z:S:1:pos:R:3:radius:R:1\nH 1 2 3 .5\nO 11 2 3 .5\n", {}, two_halves},
      {"both.xyz", "2\nProperties=x:R:1:pos:R:3\n9 1 2 3\n9 11 2 3\n", sized, two_halves},
      {"both.xyz", "2\nProperties=positions:R:3:pos:R:3\n7 8 9 1 2 3\n7 8 9 11 2 3\n", sized, two_halves},
      {"both.xyz",
       "1\nProperties=pos:R:3:velocities:R:3:vel:R:3\n1 2 3 7 8 9 0 0 0\n",
       sized,
       {{1, 2, 3, 0.5f}},
       {"vx 7, vy 8, vz 9"}},
      {"both.xyz", "1\nProperties=pos:R:3:vx:R:1:velo:R:3\n1 2 3 7 0 0 0\n", sized, {{1, 2, 3, 0.5f}}, {"vx 5, vy 6"}},
      {"twice.xyz",
       "1\nProperties=pos:R:3:pos:R:3\n1 2 3 7 4 5\n",
       sized,
       {},
       {"x stands twice", "--columns x,y,z,_,_,_"}},
      {"string.xyz", "1\nProperties=pos:S:3:Z:I:1\n1 2 3 7\n", sized, {}, {"pos:R:3"}},
      {"element.csv", "element,Z,x,y,z\nH,1,1,2,3\nO,8,11,2,3\n", sized, two_halves},
      {"element.csv", "Z,X,Y,Z,z\n8,1,2,9,3\n8,11,2,9,3\n", sized, two_halves},
      {"upper.csv", "X,Y,Z,R\n1,2,3,.5\n11,2,3,.5\n", {}, two_halves},
      {"upper.csv", "x,y,Z,Z\n1,2,3,.5\n", sized, {}, {"z stands twice", "--columns x,y,z,_"}},
  });
  const auto npy = [](const char* fields) {
    return npy_file(fmt::format("{{'descr': [{}], 'fortran_order': False, 'shape': (1,)}}", fields),
                    npy_data<double>({1, 2, 3, 8, 0.5}, 5));
  };
  expect_case({"z.npy", npy("('pos', '<f8', (3,)), ('Z', '<f8'), ('radius', '<f8')"), {}, {{1, 2, 3, 0.5f}}});
  expect_case(
      {"z.npy", npy("('x', '<f8'), ('y', '<f8'), ('z', '<f8'), ('Z', '<f8'), ('r', '<f8')"), {}, {{1, 2, 3, 0.5f}}});
}

TEST(ColumnMeaning, ProseInACommentIsNoNames) {
  for (const char* comment :
       {"# columns: x, y, z, radius", "# [x, y, z, r]", "# (x y z r)", "# each line is x, y, z, radius",
        "# x y z; radius", "# centre x y z and radius of each sphere", "# positions: x y z", "# my type z data",
        "# x, y and z", "# x y and z", "# centres (x,y,z) and radii", "# positions x y z", "# id of run",
        "# data x y z radius", "# columns: [x, y, z, r]", "# a type of bed", "# origin x=0 y=0 z=0",
        "# x y z radius vx vy vz", "# 1:x 2:y 3:z 4:radius"})
    expect_case({"prose.txt", fmt::format("{}\n1 2 3 .5\n11 2 3 .5\n", comment), {}, two_halves});
}

TEST(ColumnMeaning, NamesInACommentMayHaveNumbersLabelsAndUnitsWithCommas) {
  for (const char* comment : {"# 1:id 2:x 3:y 4:z", "# 1: id 2: x 3: y 4: z", "# 1=id, 2=x, 3=y, 4=z",
                              "# id x y z (m, kg)", "# [id, x, y, z]", "# columns: id, x, y, z", "# columns = id x y z",
                              "# Point Nr, X [mm], Y [mm], Z [mm]", "# Point Nr\tX\tY\tZ", "# id; x; y; z"}) {
    expect_case({"named.txt", fmt::format("{}\n1 1 2 3\n0 11 2 3\n", comment), sized, two_halves});
    expect_case({"named.txt", fmt::format("{}\n1 1 2 3\n0 11 2 3\n", comment), {}, {}, {"no radii"}});
  }
  expect_case({"first.txt", "# radius, x, y, z [m, m]\n.5 1 2 3\n.5 11 2 3\n", {}, two_halves});
  for (const char* comment : {"# each line is id, x, y, z of a sphere", "# z y x and radius", "# radius and x y z",
                              "# 1:id 2:type 3:x 4:y 5:z", "# x y z mass radius", "# x y z vx vy vz",
                              "# x y z and diameter", "# particle, kind, x, y, z"})
    expect_case({"order.txt", fmt::format("{}\n1 1 2 3\n0 11 2 3\n", comment), {}, {}, {"line 1", "--columns"}});
  expect_case(
      {"order.txt", "# z y x and radius\n3 2 1 .5\n3 2 11 .5\n", columns({"z", "y", "x", "radius"}), two_halves});
}

TEST(ColumnMeaning, AnErrorGivesColumnsThatWork) {
  const std::string both = "2\nProperties=species:S:1:pos:R:3:radius:R:1:diameter:R:1\nH 1 2 3 .5 9\nH 11 2 3 .5 9\n",
                    some = "x,y,z,radius,vx\n1,2,3,.5,7\n11,2,3,.5,7\n",
                    named = "2\nProperties=centre:R:3:r:R:1\n1 2 3 .5\n11 2 3 .5\n";
  expect_cases({
      {"both.xyz", both, {}, {}, {"radius and diameter", "--columns species,x,y,z,radius,_"}},
      {"both.xyz", both, columns({"species", "x", "y", "z", "radius", "_"}), two_halves},
      {"both.xyz", both, columns({"pos=pos", "radius=radius"}), two_halves},
      {"both.xyz", both, columns({"x=pos", "radius=radius"}), {}, {"'pos' has 3 columns", "pos=NAME"}},
      {"some.csv", some, {}, {}, {"vx, vy and vz only some", "--columns x,y,z,radius,_"}},
      {"some.csv", some, columns({"x", "y", "z", "radius", "_"}), two_halves},
      {"named.xyz", named, {}, {}, {"pos=NAME"}},
      {"named.xyz", named, columns({"pos=centre", "radius=r"}), two_halves},
      {"three.xyz", "1\nProperties=pos:R:3:r:R:3\n1 2 3 4 5 6\n", sized, {}, {"radius:R:1", "--columns"}},
      {"three.xyz", "1\nProperties=pos:R:3:r:R:3\n1 2 3 4 5 6\n", columns({"pos=pos"}, 0.5), {{1, 2, 3, 0.5f}}},
  });
  EXPECT_EQ(complaint_of_column("pos=centre"), "");
  EXPECT_NE(complaint_of_column("pos"), "");
}

TEST(ColumnMeaning, UnitsOfVelocitiesAndBracketsThatAreNone) {
  for (const char* unit : {"m/s", "ms-1", "ms^-1", "m s^-1", "m"})
    expect_case({"units.csv",
                 fmt::format("x [m],y [m],z [m],r [m],vx [{0}],vy [{0}],vz [{0}]\n1,2,3,.5,0,0,0\n"
                             "11,2,3,.5,0,0,0\n",
                             unit),
                 {},
                 two_halves,
                 {"in m,"}});
  expect_cases({
      {"units.csv", "x [m],y [m],z [m],r,vx [mm/s],vy [mm/s],vz [mm/s]\n1,2,3,.5,0,0,0\n", {}, {}, {"mm/s"}},
      {"axes.csv", "x (first axis),y (second axis),z (third axis),r\n1,2,3,.5\n11,2,3,.5\n", {}, two_halves},
      {"digits.csv", "x[0],y[1],z[2],r[3]\n1,2,3,.5\n11,2,3,.5\n", {}, two_halves},
      {"blank.csv", "x [],y [ ],z [m],r\n1,2,3,.5\n11,2,3,.5\n", {}, two_halves, {"in m,"}},
  });
}

TEST(ColumnMeaning, AWarningOfABoxHasItsWordsInOnePairOfQuotes) {
  expect_case({"box.xyz", "2\nCELL: 10 10 10\nH 1 2 3 .5\nH 11 2 3 .5\n", {}, two_halves, {"read: 'CELL: 10 10 10';"}});
  expect_case({"box.txt", "# CELL: 10 10 10\n1 2 3 .5\n11 2 3 .5\n", {}, two_halves, {"read: 'CELL: 10 10 10';"}});
  expect_case({"box.xyz",
               "2\nCELL: 10 10 10\nH 1 2 3 .5\nH 11 2 3 .5\n",
               {.ignore_periodic = true},
               two_halves,
               {"asked for: 'CELL: 10 10 10' is"}});
}

}  // namespace
}  // namespace spherepair
