// SPDX-License-Identifier: MIT
// Columns of text mean what the file or an option says. Where neither does, the file is refused.
#include "tests/files/columns_of_files.h"

namespace spherepair {
namespace {

TEST(ColumnMeaning, EveryLineHasAsManyColumns) {
  expect_cases({
      {"welded.txt", "5 5 5 13 0 0 1\n6 5 5 1\n", {}, {}, {"line 2", "7 columns", "line 1", "found 4"}},
      {"welded.csv", "5,5,5,13,0,0,1\n6,5,5,1\n", {}, {}, {"line 2", "7 columns", "line 1", "found 4"}},
      {"welded.tsv", "5\t5\t5\t13\t0\t0\t1\n6\t5\t5\t1\n", {}, {}, {"line 2", "7 columns"}},
      {"later.txt", "5 5 5 1\n9 5 5 12 0 0 3\n", {}, {}, {"line 2", "4 columns", "found more than 4"}},
      {"semicolons.csv", "5;5;5;1\n9;5;5;12;0;0;3\n", {}, {}, {"line 2", "found more than 4"}},
      {"points.txt", "5 5 5\n9 5 56 5 5\n", sized, {}, {"line 2", "3 columns"}},
      {"first.txt", "5 5 56 5 5\n9 5 5\n", sized, {}, {"line 1", "found 5"}},
      {"moving.txt", "5 5 5 1\n6 5 5 1 0 0 0\n", {}, {}, {"line 2", "4 columns"}},
      {"comment.txt", "# a bed\n\n5 5 5 1 # the first\n6 5 5\n", {}, {}, {"line 4", "line 3", "found 3"}},
      {"named.csv", "x,y,z,radius\n5,5,5,13,5,5,1\n", {}, {}, {"line 2", "4 columns", "names in line 1"}},
      {"chosen.log",
       "a 5 5 5 1\nb 5 5 51 c 5 5 5\n",
       columns({"_", "x", "y", "z", "radius"}),
       {},
       {"line 2", "by --columns"}},
      {"welded.xyz", "2\n\nH 5 5 5 1\nH 6 5 5 1H 7 5 5 1\n", {}, {}, {"line 4", "5 columns", "more than 5"}},
  });
}

TEST(ColumnMeaning, RIsARadiusUnlessItIsAColourOrADistance) {
  const std::vector<vec4> halves = {{1, 2, 3, 0.5f}, {11, 2, 3, 0.5f}};
  for (const char* names : {"x,y,z,r,g,b", "X,Y,Z,R,G,B", "\"x\",\"y\",\"z\",\"r\",\"g\",\"b\"", "x,y,z,b,g,r"}) {
    const std::string text = fmt::format("{}\n1,2,3,200,0,0\n11,2,3,9,80,0\n", names);
    expect_case({"rgb.csv", text, sized, halves});
    expect_case({"rgb.csv", text, {}, {}, {"no radii", "--radius"}});
  }
  expect_cases({
      {"rgb.txt", "x y z r g b\n1 2 3 200 0 0\n11 2 3 9 80 0\n", sized, halves},
      {"rgb.txt", "# x y z r g b\n1 2 3 200 0 0\n11 2 3 9 80 0\n", sized, halves},
      {"rgba.csv", "r,g,b,a,x,y,z\n200,0,0,1,1,2,3\n9,8,0,1,11,2,3\n", sized, halves},
      {"own.csv", "x,y,z,r,g,b,radius\n1,2,3,200,0,0,.5\n11,2,3,9,80,0,.5\n", {}, halves},
      {"chosen.csv", "x,y,z,r,g,b\n1,2,3,.5,0,0\n11,2,3,.5,80,0\n", columns({"x=x", "y=y", "z=z", "radius=r"}), halves},
      {"skipped.csv", "X,Y,Z,R,G,B\n1,2,3,200,0,0\n11,2,3,9,80,0\n", columns({"x", "y", "z", "_", "_", "_"}, 0.5),
       halves},
      {"polar.csv", "r,theta,z,x,y\n7,8,3,1,2\n7,8,3,11,2\n", sized, halves},
      {"polar.csv", "r,phi,z,x,y\n7,8,3,1,2\n7,8,3,11,2\n", {}, {}, {"no radii"}},
      {"radius.csv", "x,y,z,r,id\n1,2,3,.5,1\n11,2,3,.5,2\n", {}, halves},
      {"rgb.xyz", "2\nProperties=pos:R:3:r:I:1:g:I:1:b:I:1\n1 2 3 200 0 0\n11 2 3 9 80 0\n", sized, halves},
  });
  const std::string fields = "[('x', '<f4'), ('y', '<f4'), ('z', '<f4'), ('{}', '<f4'), ('g', '<f4'), ('b', '<f4')]";
  const auto npy = [&](const char* name) {
    return npy_file("{'descr': " + fmt::format(fmt::runtime(fields), name) + ", 'fortran_order': False, 'shape': (1,)}",
                    npy_data<float>({1, 2, 3, 200, 5, 6}, 3));
  };
  expect_case({"rgb.npy", npy("r"), sized, {{1, 2, 3, 0.5f}}});
  expect_case({"rgb.npy", npy("r"), {}, {}, {"no radii"}});
  expect_case({"rgb.npy", npy("radius"), {}, {{1, 2, 3, 200}}});
  expect_case({"rgb.npy", npy("r"), columns({"x=x", "y=y", "z=z", "radius=b"}), {{1, 2, 3, 6}}});
}

TEST(ColumnMeaning, NumbersThatMayMeanTwoThingsAreRefusedWithTheOptionThatTells) {
  const std::string scan = "1.5 2 3 0.25 20 18 9\n1.75 2 3 0.125 90 91 92\n",
                    types = "2\nAtoms. Timestep: 7\n1 1 2 3\n2 11 2 3\n";
  const std::vector<vec4> halves = {{1, 2, 3, 0.5f}, {11, 2, 3, 0.5f}};
  expect_cases({
      {"scan.txt", scan, sized, {}, {"line 1", "--columns x,y,z,_,_,_,_"}},
      {"scan.txt", scan, {}, {}, {"line 1", "--columns x,y,z,radius,vx,vy,vz", "--columns x,y,z,_,_,_,_"}},
      {"scan.txt", scan, columns({"x", "y", "z", "_", "_", "_", "_"}, 0.5), {{1.5f, 2, 3, 0.5f}, {1.75f, 2, 3, 0.5f}}},
      {"four.txt", "1 2 3 4\n", sized, {}, {"4 columns", "--columns x,y,z,_"}},
      {"four.txt", "1 2 3 4\n", columns({"x", "y", "z", "_"}, 0.5), {{1, 2, 3, 0.5f}}},
      {"types.xyz", types, {}, {}, {"line 3", "may be a type", "--columns species,x,y,z", "--columns x,y,z,radius"}},
      {"types.xyz", types, sized, halves, {"a type"}},
      {"types.xyz", types, columns({"_", "x", "y", "z"}, 0.5), halves, {"by --columns"}},
      {"types.xyz", types, columns({"species", "x", "y", "z"}, 0.5), halves},
      {"types.xyz", types, columns({"x", "y", "z", "radius"}), {{1, 1, 2, 3}, {2, 11, 2, 3}}},
      {"numbers.xyz", "3\nfrom ase\n8 0.1 0 0\n1 0.9 0 0\n1 -0.2 0.9 0\n", {}, {}, {"may be a type"}},
      {"radii.xyz", "2\n\n1 2 3 .5\n1.5 2 3 .5\n", {}, {{1, 2, 3, 0.5f}, {1.5f, 2, 3, 0.5f}}},
      {"negative.xyz", "2\n\n1 2 3 .5\n-1 2 3 .5\n", {}, {{1, 2, 3, 0.5f}, {-1, 2, 3, 0.5f}}},
      {"radii.xyz", "2\n\n1 2 3 .5\n1.5 2 3 .5\n", sized, {}, {"4 columns", "--columns x,y,z,_"}},
      {"charge.xyz", "1\n\nNa 1 2 3 1\n", sized, {}, {"5 columns", "--columns species,x,y,z,_"}},
      {"charge.xyz", "1\n\nNa 1 2 3 1\n", columns({"_", "x", "y", "z", "_"}, 0.5), {{1, 2, 3, 0.5f}}},
      {"five.xyz", "1\n\n1 1 2 3 .5\n", columns({"_", "x", "y", "z", "radius"}), {{1, 2, 3, 0.5f}}},
  });
  const SphereFile dark = read_from("0 0 0 1 0 0 1\n1 1 1 2 1 0 0\n", {}, "txt");
  EXPECT_EQ(dark.scene.velocities[0].z, 1) << "colours of 0 and 1 alone would be black";
  const std::string rows = npy_file(npy_header("<f4", "(1, 6)"), npy_data<float>({1, 2, 3, 4, 5, 6}, 6));
  expect_case({"six.npy", rows, {}, {}, {"--columns"}});
  expect_case({"six.npy", rows, columns({"_", "z", "y", "x", "radius", "_"}), {{4, 3, 2, 5}}});
  expect_case({"six.npy", rows, columns({"x", "y", "z"}, 1), {}, {"shape (n, 3), by --columns"}});
}

TEST(ColumnMeaning, NamesStandInACommentOrAHeader) {
  const std::vector<vec4> halves = {{1, 2, 3, 0.5f}, {11, 2, 3, 0.5f}};
  const std::string rows = "1 1 2 3\n2 11 2 3\n";
  for (const char* comment :
       {"# id x y z", "#id x y z", "# ID X Y Z", "#  type\tx\ty\tz", "# columns: id x y z", "## id x y z",
        "# written by a program\n# id x y z", "# id x y z\n# in metres, all of them", "# id x [m] y [m] z [m]"}) {
    expect_case({"saved.txt", comment + ("\n" + rows), sized, halves});
    expect_case({"saved.txt", comment + ("\n" + rows), {}, {}, {"no radii"}});
  }
  expect_cases({
      {"saved.csv", "# id,x,y,z\n1,1,2,3\n2,11,2,3\n", sized, halves, {"names in line 1"}},
      {"saved.csv", "#,x,y,z\n1,1,2,3\n2,11,2,3\n", sized, halves},
      {"unknown.txt", "# id px py pz\n" + rows, sized, {}, {"id px py pz", "--columns"}},
      {"unknown.txt", "# id px py pz\n" + rows, columns({"x=px", "y=py", "z=pz"}, 0.5), halves},
      {"more.txt", "# id type x y z\n" + rows, sized, {}, {"line 1", "4 columns", "--columns"}},
      {"order.txt", "# x y z radius vx vy vz\n1 2 3 0.5\n11 2 3 0.5\n", {}, halves},
      {"prose.txt", "# spheres of a bed\n1 2 3 0.5\n11 2 3 0.5\n", {}, halves},
      {"later.txt", "1 2 3 0.5\n# z y x radius\n11 2 3 0.5\n", {}, halves},
      {"paraview.csv", "\"ids\",\"Points:0\",\"Points:1\",\"Points:2\"\n0,1,2,3\n1,11,2,3\n",
       columns({"_", "x", "y", "z"}, 0.5), halves},
      {"paraview.csv",
       "\"ids\",\"Points:0\",\"Points:1\",\"Points:2\"\n0,1,2,3\n1,11,2,3\n",
       columns({"x=Points:0", "y=Points:1", "z=Points:2"}, 0.5),
       halves,
       {"by --columns"}},
      {"paraview.csv", "\"Points:0\",\"Points:1\",\"Points:2\"\n1,2,3\n", sized, {}, {"x=NAME", "Points:0 Points:1"}},
      {"same.csv", "x,y,z,radius\n1,2,3,.5\n11,2,3,.5\n", columns({"x", "y", "z", "radius"}), halves},
      {"twice.csv", "names\nx,y,z\n1,2,3\n", columns({"x", "y", "z"}, 0.5), {}, {"line 2", "found 'x'"}},
      {"none.csv", "1,2,3\n", columns({"x=a", "y=b", "z=c"}, 0.5), {}, {"no names of columns"}},
      {"wrong.csv", "a,b,c\n1,2,3\n", columns({"x=a", "y=b", "z=d"}, 0.5), {}, {"no column 'd'", "'a b c'"}},
      {"alike.csv", "a,A,c,d\n1,2,3,4\n", columns({"x=a", "y=A", "z=c"}, 0.5), {{1, 2, 3, 0.5f}}},
      {"alike.csv", "a [m],a [mm],c,d\n1,2,3,4\n", columns({"x=a", "y=c", "z=d"}, 0.5), {}, {"several columns", "'a'"}},
      {"mixed.csv", "a,b,c\n1,2,3\n", columns({"x", "y=b", "z=c"}, 0.5), {}, {"for each column", "x=NAME"}},
  });
}

TEST(ColumnMeaning, UnitsDiametersAndDecimalCommas) {
  const std::vector<vec4> halves = {{1, 2, 3, 0.5f}, {11, 2.5f, 3, 0.5f}};
  SphereFileOptions commas = {.decimal_comma = true}, chosen = columns({"_", "x", "y", "z", "diameter"});
  chosen.decimal_comma = true;
  expect_cases({
      {"sheet.csv",
       "Nr;X [mm];Y [mm];Z [mm];Radius [mm]\n1;1,0;2,0;3;0,5\n2;11;2,5;3;0,5\n",
       commas,
       halves,
       {"in mm"}},
      {"sheet.csv", "Nr;X [mm];Y [mm];Z [mm];Radius [mm]\n1;1,0;2,0;3;0,5\n", {}, {}, {"line 2", "--decimal-comma"}},
      {"sheet.csv", "Nr;A;B;C;D\n1;1,0;2,0;3;1\n2;11;2,5;3;1\n", chosen, halves},
      {"sheet.tsv", "Point Nr\tX (mm)\tY (mm)\tZ (mm)\tR (mm)\n1\t1,0\t2\t3\t0,5\n2\t11\t2,5\t3\t0,5\n", commas,
       halves},
      {"sheet.txt", "Point Nr\tX (mm)\tY (mm)\tZ (mm)\tR (mm)\n1\t1,0\t2\t3\t0,5\n2\t11\t2,5\t3\t0,5\n", commas,
       halves},
      {"blanks.txt", "1,0 2,0 3,0 0,5\n11 2,5 3,0 0,5\n", commas, halves},
      {"blanks.txt", "1,0 2,0 3,0 0,5\n", {}, {}, {"--decimal-comma"}},
      {"points.csv", "1;2;3;0.5\n", commas, {}, {"found '0.5'", "decimal comma"}},
      {"thousands.csv", "1.000,5;2;3;1\n", commas, {}, {"line 1", "a number in column 1", "found '1.000,5'"}},
      {"comma.xyz", "1\n\nH 1,0 2,0 3,5\n", {.radius = 0.5, .decimal_comma = true}, {{1, 2, 3.5f, 0.5f}}},
      {"units.csv", "x [m],y [m],z [m],radius [m]\n1,2,3,.5\n11,2.5,3,.5\n", {}, halves},
      {"units.csv", "x(cm),y(cm),z(cm),r(cm)\n1,2,3,.5\n11,2.5,3,.5\n", {}, halves, {"in cm"}},
      {"units.txt", "x [m] y [m] z [m] r [m]\n1 2 3 .5\n11 2.5 3 .5\n", {}, halves},
      {"units.txt", "x [in m] y [in m] z [in m] r\n1 2 3 .5\n11 2.5 3 .5\n", {}, halves},
      {"units.csv", "x [m],y [m],z [m],radius [mm]\n1,2,3,.5\n", {}, {}, {"several units, m and mm"}},
      {"units.csv",
       "x [mm],y [mm],z [mm],r,vx [m/s],vy [m/s],vz [m/s]\n1,2,3,.5,0,0,0\n",
       {},
       {},
       {"mm and velocities in m/s"}},
      {"diameter.csv", "x,y,z,diameter\n1,2,3,1\n11,2.5,3,1\n", {}, halves, {"half of"}},
      {"diameter.csv", "X [m],Y [m],Z [m],Diameter [m]\n1,2,3,1\n11,2.5,3,1\n", {}, halves},
      {"diameter.log", "1 2 3 1\n11 2.5 3 1\n", columns({"x", "y", "z", "diameter"}), halves},
      {"diameter.xyz", "2\nProperties=pos:R:3:diameter:R:1\n1 2 3 1\n11 2.5 3 1\n", {}, halves, {"half of"}},
      {"diameter.csv", "x,y,z,diameter,radius\n1,2,3,1,.5\n", {}, {}, {"radius and diameter", "--columns"}},
      {"diameter.csv", "x,y,z,diameter\n1,2,3,-1\n", {}, {}, {"not negative for diameter"}},
      {"quoted.csv", "\"x\",\"y\",\"z\",\"a, b\"\n1,2,3,9\n11,2.5,3,9\n", sized, halves},
      {"quoted.csv", "\"#\",\"x\",\"y\",\"z\"\n7,1,2,3\n8,11,2.5,3\n", sized, halves},
  });
  const std::string halving = npy_file(
      "{'descr': [('pos', '<f8', (3,)), ('diameter', '<f8')], 'fortran_order': False, "
      "'shape': (2,)}",
      npy_data<double>({1, 2, 3, 1, 11, 2.5, 3, 1}, 4));
  expect_case({"diameter.npy", halving, {}, halves, {"half the diameter"}});
  expect_case({"comma.npy", halving, commas, {}, {"--decimal-comma"}});
}

TEST(ColumnMeaning, ADiameterIsHalvedWithoutAnotherRounding) {
  for (const char* diameter :
       {"0.1", "1e-45", "3e-45", "1.17549435e-38", "0.30000000000000004", "3.4e38", "7.0064923e-45"}) {
    const SphereFile input = read_from(fmt::format("x,y,z,diameter\n0,0,0,{}\n", diameter), {}, "csv");
    const double exact = std::strtod(diameter, nullptr) / 2, read = input.scene.positions[0].w;
    EXPECT_LE(std::abs(read - exact), std::max(exact * 0x1p-24, 0x1p-150)) << diameter;
    EXPECT_GE(double(input.largest_rounding), std::abs(read - exact)) << diameter;
  }
}

}  // namespace
}  // namespace spherepair
