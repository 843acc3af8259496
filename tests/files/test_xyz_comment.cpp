// SPDX-License-Identifier: MIT
// The comment of extended XYZ is read as its specification says, and no periodic box is lost.
#include "bench/text/xyz_comment.h"
#include "tests/files/columns_of_files.h"

namespace spherepair {
namespace {

using Words = std::vector<std::pair<std::string, std::string>>;

// Values of flags are "-", of incomplete pairs "?".
Words words_of(const std::string& comment) {
  Words words;
  for (const CommentPair& pair : parse_comment(comment))
    words.emplace_back(pair.key, pair.complete ? pair.value.value_or("-") : "?");
  return words;
}

TEST(XyzComment, IsSplitAsTheGrammarSays) {
  for (const auto& [comment, expected] : std::vector<std::pair<std::string, Words>>{
           {"", {}},
           {" \t ", {}},
           {"a=1", {{"a", "1"}}},
           {"a = 1", {{"a", "1"}}},
           {"a\t=\t1\tb  =2 c= 3", {{"a", "1"}, {"b", "2"}, {"c", "3"}}},
           {"flag a=1 other", {{"flag", "-"}, {"a", "1"}, {"other", "-"}}},
           {"flag  other =1", {{"flag", "-"}, {"other", "1"}}},
           {R"(a="1 2" b="x=y")", {{"a", "1 2"}, {"b", "x=y"}}},
           {R"("a key" = "q \" and \\ and \n")", {{"a key", "q \" and \\ and \n"}}},
           {R"(a="b=1 c" d)", {{"a", "b=1 c"}, {"d", "-"}}},
           {R"(a\ b=c\=d)", {{"a b", "c=d"}}},
           {"a={1 2 3} b=[1, 2] c=[[1,2],[3,4]]", {{"a", "1 2 3"}, {"b", "1, 2"}, {"c", "[1,2],[3,4]"}}},
           {R"(a=["x]", "y"] b)", {{"a", "\"x]\", \"y\""}, {"b", "-"}}},
           {"a='1 2' it's b='", {{"a", "1 2"}, {"it's", "-"}, {"b", "'"}}},
           {R"(a="1 2)", {{"a", "?"}}},
           {"a=[1, [2]", {{"a", "?"}}},
           {"a=", {{"a", "?"}}},
           {"a= =1", {{"a", "?"}, {"1", "-"}}},
           {"positions{angstrom} b=1", {{"positions", "-"}, {"angstrom", "-"}, {"b", "1"}}},
           {"a=1,b=2", {{"a", "1"}, {"b", "2"}}},
           {R"(a="1"b=2)", {{"a", "1"}, {"b", "2"}}}})
    EXPECT_EQ(words_of(comment), expected) << comment;
}

std::string frame_of(const std::string& comment) { return "2\n" + comment + "\nAr 1 5 5\nAr 9 5 5\n"; }
const std::vector<vec4> two_atoms = {{1, 5, 5, 0.5f}, {9, 5, 5, 0.5f}};
const SphereFileOptions half = {.radius = 0.5};
const std::string lattice_numbers = "10 0 0 0 10 0 0 0 10";

TEST(XyzComment, PeriodicBoxesAreRefusedHoweverTheyAreWritten) {
  SphereFileOptions ignoring = half;
  ignoring.ignore_periodic = true;
  for (const std::string& comment :
       std::vector<std::string>{"Lattice = \"" + lattice_numbers + "\"",
                                "Lattice= \"" + lattice_numbers + "\"",
                                "Lattice\t=\t\"" + lattice_numbers + "\"",
                                "Lattice={" + lattice_numbers + "}",
                                "Lattice = [[10,0,0],[0,10,0],[0,0,10]]",
                                "Lattice = [10, 10, 10]",
                                "\"Lattice\" = \"" + lattice_numbers + "\"",
                                "energy = 3 Lattice = \"" + lattice_numbers + "\" Properties = species:S:1:pos:R:3",
                                "LATTICE = \"" + lattice_numbers + "\"",
                                "pbc = \"T T T\"",
                                "pbc = [T, F, F]",
                                "pbc = \"FALSE FALSE TRUE\"",
                                "pbc={true false false}",
                                "PBC = \"False False True\"",
                                "pbc=[[T], [F], [F]]",
                                "box = \"10 10 10\"",
                                "cell = [10, 10, 10]",
                                "unit_cell={10 10 10}",
                                "# CELL(abcABC): 10 10 10 90 90 90 Step: 0 Bead: 0 positions{angstrom} cell{angstrom}",
                                "# CELL(H): 10 0 0 0 10 0 0 0 10 Step: 4 Bead: 0",
                                "Lattice=\"" + lattice_numbers + "\" Lattice=\"" + lattice_numbers + "\""}) {
    expect_case({"box.xyz", frame_of(comment), half, {}, {"line 2", "--ignore-periodic"}});
    expect_case({"box.xyz", frame_of(comment), ignoring, two_atoms, {"is ignored"}});
  }
}

TEST(XyzComment, OpenBoxesAreRead) {
  for (const char* open : {"pbc=\"F F F\"", "pbc = \"FALSE FALSE FALSE\"", "pbc = [False, false, F]", "pbc={F F F}",
                           "pbc = \"0 0 0\"", "\"pbc\" = \"F F F\" note = \"a box\""}) {
    expect_case({"open.xyz", frame_of("Lattice = \"" + lattice_numbers + "\" " + open), half, two_atoms});
    EXPECT_EQ(describe(read_from(frame_of(open), half)).find("WARNING"), std::string::npos) << open;
  }
}

TEST(XyzComment, OtherWordsForABoxAreWarnedOf) {
  for (const char* comment :
       {"box 10 10 10", "spheres in a periodic box", "Lattice 10 0 0 0 10 0 0 0 10", "# cell: 10 10 10",
        "note=\"the cell is 10\"", "boxsize=10", "PBC: yes", "supercell 2x2x2", "Box{10}", "lattice_constant=10"}) {
    const std::string said = describe(read_from(frame_of(comment), half));
    EXPECT_NE(said.find("WARNING: a comment has a word for a box"), said.npos) << comment << ": " << said;
    SphereFileOptions ignoring = half;
    ignoring.ignore_periodic = true;
    EXPECT_EQ(describe(read_from(frame_of(comment), ignoring)).find("WARNING"), std::string::npos) << "as asked for";
  }
  EXPECT_NE(describe(read_from("# box 10 10 10, periodic\n1 2 3 4\n", {}, "txt")).find("WARNING"), std::string::npos);
  for (const char* comment : {"", "an excellent day", "cancelled", "energy=3 step=4", "Atoms. Timestep: 0"})
    EXPECT_EQ(describe(read_from(frame_of(comment), half)).find("WARNING"), std::string::npos) << comment;
}

TEST(XyzComment, WhatIsNoValueIsRefused) {
  for (const char* comment : {"Lattice=", "Lattice = \"10 0 0", "pbc=[T, T, T", "Properties = ", "Lattice= =3"})
    expect_case({"bad.xyz", frame_of(comment), half, {}, {"line 2", "whose quotes or brackets end"}});
  for (const char* comment : {"pbc=\"F F F\" pbc=\"T T T\"", "Properties=pos:R:3 properties=species:S:1:pos:R:3"})
    expect_case({"bad.xyz", frame_of(comment), half, {}, {"line 2", "once"}});
  for (const char* comment : {"pbc=T", "pbc=\"T T\"", "pbc=\"T T maybe\"", "pbc = \"TRUE FALSE\"", "pbc=\"tRUE F F\""})
    expect_case({"bad.xyz", frame_of(comment), half, {}, {"line 2", "pbc with T or F"}});
}

TEST(XyzComment, PropertiesAndExponents) {
  const std::vector<vec4> own = {{1, 2, 3, 0.5f}, {4, 5, 6, 0.75f}};
  for (const char* key :
       {"Properties = species:S:1:radius:R:1:pos:R:3", "Properties\t=species:S:1:radius:R:1:pos:R:3",
        "properties = \"species:S:1:radius:R:1:pos:R:3\"", "a = 1 Properties = species:S:1:Radius:R:1:Pos:R:3",
        "Properties={species:S:1:radius:R:1:pos:R:3}", "Properties=species:S:1:radius:R:1:x:R:1:y:R:1:z:R:1"})
    expect_case({"named.xyz", "2\n" + std::string(key) + "\nAr 0.5 1 2 3\nAr 0.75 4 5 6\n", {}, own});
  expect_case({"fortran.xyz", "2\n\nAr 1.0D+00 0.2d1 3D0 5d-1\nAr 4.d0 5 .6D+01 75d-2\n", {}, own});
  expect_case({"fortran.txt", "1.0D+00 0.2d1 3D0 5d-1\n4.d0 5 .6D+01 75d-2\n", {}, own});
  for (const char* wrong : {"1d", "d1", "D", "1.0dd3", "1e5d3", "1d+", "0x1d"})
    EXPECT_FALSE(parse_decimal(wrong)) << wrong;
  EXPECT_TRUE(parse_decimal("1.000000001d0")->changed) << "digits are counted before a D as before an e";
}

}  // namespace
}  // namespace spherepair
