// SPDX-License-Identifier: MIT
// Spheres of LAMMPS's data files: columns by the style of the atoms, the box of the header, velocities by id.
#include <fcntl.h>
#include <unistd.h>

#include "tests/bench/sphere_complaints.h"
#include "tests/support/pairs_command.h"

namespace spherepair {
namespace {

const std::string data_box = "0 4 xlo xhi\n-1 4 ylo yhi\n0 6 zlo zhi\n";
const std::string data_grains =
    "7 1 2 2500 0.5 1 1 0 0 -1  # the first\n"
    "9 2 3 2500 2.5 1 1.25 0 0 0\n";

std::string data_file(const std::string& sections, size_t count = 2, const std::string& box = data_box) {
  return fmt::format("written by hand, units = si\n\n{} atoms\n3  atom types # of which two\n5 bonds\n\n{}\n{}", count,
                     box, sections);
}
std::string atoms_section(const std::string& style, const std::string& lines) {
  return (style.empty() ? "Atoms\n\n" : "Atoms  # " + style + "\n\n") + lines + "\n";
}

class LammpsData : public PairsCommand {
 protected:
  SphereFile read(const std::string& text, SphereFileOptions options = {}) {
    options.ignore_periodic = !options.exact;
    return read_sphere_file(folder_.write("a.data", text), options);
  }
  std::string listed(const std::string& name, const std::string& text, double cutoff) {
    PairsOptions asked = options("pairs.txt");
    asked.input_file = folder_.write(name, text);
    asked.cutoff = cutoff;
    EXPECT_EQ(run(asked), "") << name;
    return read_bytes(asked.output_file);
  }
};

std::array<float, 4> floats_of(const vec4& p) { return {p.x, p.y, p.z, p.w}; }

TEST_F(LammpsData, AtomsOfTheStyleSphereHaveDiameters) {
  const std::string masses = "Masses\n\n1 0.5\n2 1\n\n", bonds = "\nBonds\n\n1 1 7 9\n";
  const SphereFile file = read(data_file(masses + atoms_section("sphere", data_grains) + bonds));
  ASSERT_EQ(file.scene.size(), 2u);
  EXPECT_EQ(floats_of(file.scene.positions[0]), (std::array{0.5f, 1.0f, 1.0f, 1.0f}));
  EXPECT_EQ(floats_of(file.scene.positions[1]), (std::array{2.5f, 1.0f, 1.25f, 1.5f}));
  EXPECT_TRUE(file.at_rest);
  EXPECT_EQ(file.units, "LAMMPS's units si");
  EXPECT_TRUE(file.format.starts_with("LAMMPS data (id type diameter density x y z ix iy iz)")) << file.format;
  EXPECT_EQ(read(data_file(atoms_section("sphere", data_grains)), {.species = true}).species,
            (std::vector<std::string>{"1", "2"}));
}

TEST_F(LammpsData, VelocitiesAreThoseOfTheId) {
  const std::string velocities = "\nVelocities # sphere\n\n9 4 5 6 0 0 0\n7 1 2 3 0 0 0\n";
  for (const bool species : {false, true}) {
    const SphereFile file = read(data_file(atoms_section("sphere", data_grains) + velocities), {.species = species});
    ASSERT_EQ(file.scene.size(), 2u);
    EXPECT_EQ(file.scene.velocities[0].z, 3);
    EXPECT_EQ(file.scene.velocities[1].x, 4);
    EXPECT_FALSE(file.at_rest);
    EXPECT_EQ(file.values, 14u);
  }
}

TEST_F(LammpsData, StylesPlaceTheirColumns) {
  for (const auto& [style, line] : {std::pair{"atomic", "5 2 1 2 3"},
                                    {"charge", "5 2 0.5 1 2 3"},
                                    {"bond", "5 8 2 1 2 3"},
                                    {"angle", "5 8 2 1 2 3"},
                                    {"molecular", "5 8 2 1 2 3"},
                                    {"full", "5 8 2 -0.5 1 2 3"}})
    for (const char* images : {"", " 0 -1 0"}) {
      const SphereFile file =
          read(data_file(atoms_section(style, fmt::format("{}{}\n", line, images)), 1), {.radius = 4, .species = true});
      EXPECT_EQ(floats_of(file.scene.positions.at(0)), (std::array{1.0f, 2.0f, 3.0f, 4.0f})) << style;
      EXPECT_EQ(file.species, std::vector<std::string>{"2"}) << style;
    }
  const SphereFile file = read(data_file(atoms_section("bpm/sphere", "5 8 2 3 2500 1 2 3\n"), 1));
  EXPECT_EQ(floats_of(file.scene.positions.at(0)), (std::array{1.0f, 2.0f, 3.0f, 1.5f}));
}

TEST_F(LammpsData, ColumnsTellWhatNoStyleDoes) {
  const std::string line = "5 2 1 2 3 8\n";
  EXPECT_EQ(
      floats_of(read(data_file(atoms_section("", line), 1), {.columns = {"_", "species", "x", "y", "z", "diameter"}})
                    .scene.positions.at(0)),
      (std::array{1.0f, 2.0f, 3.0f, 4.0f}));
  EXPECT_EQ(floats_of(read(data_file(atoms_section("charge", line), 1), {.columns = {"x=y", "y=x", "z=z", "radius=q"}})
                          .scene.positions.at(0)),
            (std::array{3.0f, 2.0f, 8.0f, 1.0f}));
}

// The same spheres and box as extended XYZ and as a dump, whose lists have their own tests.
TEST_F(LammpsData, PairsInItsBoxAreThoseOfTheSameLattice) {
  const std::string points = "3.75 0.5 0.25\n0.25 4.75 0.5\n1.5 2.5 5.75\n2.75 0.125 3\n";
  const std::string lines = "1 1 3.75 0.5 0.25\n2 1 0.25 4.75 0.5\n3 1 1.5 2.5 5.75\n4 1 2.75 0.125 3\n";
  const auto of_data = [&](const std::string& box) {
    return listed("a.lmp", data_file(atoms_section("atomic", lines), 4, box), 3.5);
  };
  const auto of_lattice = [&](const char* lattice) {
    return listed("a.xyz", fmt::format("4\nLattice=\"{}\" Properties=pos:R:3\n{}", lattice, points), 3.5);
  };
  const std::string straight = of_data(data_box), tilted = of_lattice("4 0 0 -1.5 5 0 1 -0.5 6");
  EXPECT_EQ(straight, of_lattice("4 0 0 0 5 0 0 0 6"));
  EXPECT_EQ(of_data(data_box + "-1.5 1 -0.5 xy xz yz\n"), tilted);
  EXPECT_EQ(of_data("4 0 0 avec\n-1.5 5 0 bvec\n1 -0.5 6 cvec\n0 0 0 abc origin\n"), tilted);
  EXPECT_NE(straight, tilted);
  EXPECT_GT(std::ranges::count(straight, '\n'), 1);
}

TEST_F(LammpsData, AStreamIsKnownByTheNumberOfAtoms) {
  PairsOptions asked = options("pairs.txt");
  const std::string file = folder_.write("pipe", data_file(atoms_section("sphere", data_grains)));
  const int pipe = open(file.c_str(), O_RDONLY);
  asked.input_file = fmt::format("/dev/fd/{}", pipe);
  EXPECT_EQ(run(asked), "");
  close(pipe);
  EXPECT_EQ(read_bytes(asked.output_file), "# i j sx sy sz\n0 1 -1 0 0\n0 1 0 0 0\n");
}

TEST_F(LammpsData, BadFilesAreRefusedWhereTheyAre) {
  const auto expect = [](const std::string& text, uint64_t line, const std::string& expected, const std::string& found,
                         SphereFileOptions options = {.radius = 1, .exact = true}) {
    expect_complaint("bad.data", text, fmt::format("line {}", line), expected, found, options);
  };
  const SphereFileOptions sphere = {.exact = true};
  const std::string one = atoms_section("atomic", "1 1 0 0 0\n");
  expect("", 2, "a header with the lines `N atoms`", "the end of the file");
  expect("units = ", 2, "a header with the lines", "the end of the file");
  expect("\n\n0 4 xlo xhi\n" + one, 4, "a header with the lines `N atoms`", "'Atoms  # atomic'");
  expect(data_file(one, 1, "0 4 xlo xhi\n0 4 ylo yhi\n"), 10, "zlo zhi", "'Atoms  # atomic'");
  expect(data_file(one, 1, "0 4 xlo xhi\n0 4 ylo yhi\n4 4 zlo zhi\n"), 9, "an upper bound above the lower one", "4 4");
  expect(data_file(one, 1, "0 1 4 xlo xhi\n"), 7, "2 finite numbers", "'0 1 4'");
  expect(data_file(one, 1, "0 inf xlo xhi\n"), 7, "2 finite numbers", "'0 inf'");
  expect(data_file(one, 1, data_box + "0 1 xy xz yz\n"), 10, "3 finite numbers", "'0 1'");
  expect("\n\n-1 atoms\n", 3, "the number of atoms", "'-1'");
  expect("\n\n3000000000 atoms\n", 3, "at most 2147483647", "'3000000000'");
  expect(data_file("Masses\n\n1 1\n"), 14, "a section Atoms", "the end of the file");
  expect(data_file("Atoms # atomic\n1 1 0 0 0\n", 1), 12, "a blank line below Atoms", "'1 1 0 0 0'");
  expect(data_file(atoms_section("", "1 1 0 0 0\n"), 1), 11, "Atoms # STYLE, one of angle, atomic, bond", "'Atoms'");
  expect(data_file(atoms_section("hybrid", "1 1 0 0 0\n"), 1), 11, "--columns _,species,x,y,z", "'Atoms  # hybrid'");
  expect(data_file(atoms_section("atomic", "1 1 0 0 0"), 3), 14, "3 lines as line 3 says",
         "the end of the file after 1");
  expect(data_file(one + "\nBonds\n\n1 1 1 1\n", 2), 14, "5 columns", "0: ''");
  expect(data_file(atoms_section("atomic", "1 1 0 0 0\n2 1 0 0 0\n"), 1), 14, "the end of the section after 1 line",
         "'2 1 0 0 0'");
  expect(data_file(atoms_section("atomic", "1 1 0 0 0 9\n"), 1), 13, "5 columns (id type x y z)", "more than 5");
  expect(data_file(atoms_section("sphere", "1 1 2 1 0 0 0\n2 1 2 1 0 0\n")), 14, "7 columns", "6:", sphere);
  expect(data_file(atoms_section("sphere", "1 1 2 1 0 nan 0\n"), 1), 13, "a finite number", "'nan'", sphere);
  expect(data_file(atoms_section("sphere", "1 1 -2 1 0 0 0\n"), 1), 13, "not negative", "'-2'", sphere);
  expect(data_file(one + "Velocities\n\n2 0 0 0\n", 1), 17, "the id of an atom", "'2 0 0 0'");
  expect(data_file(one + "Velocities\n\n1 0 0\n", 1), 17, "id vx vy vz", "3 numbers");
  expect(data_file(atoms_section("atomic", "1 1 0 0 0\n2 1 0 0 0\n") + "Velocities\n\n1 0 0 0\n1 0 0 0\n"), 19,
         "the id of an atom in Atoms, once", "'1 0 0 0'");
  expect(data_file(one + "Velocities\n\n1 0 inf 0\n", 1), 17, "a finite number", "'inf'");
  expect(data_file(one, 1), 9, "spheres without a periodic box",
         "boundary p p p (LAMMPS's default), box (4 0 0), (0 5 0), (0 0 6)", {.radius = 1});
  EXPECT_NE(complaint_of([&] { read(data_file(one, 1)); }).find("has no radii"), std::string::npos);
}

}  // namespace
}  // namespace spherepair
