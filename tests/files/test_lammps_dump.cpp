// SPDX-License-Identifier: MIT
// Spheres of LAMMPS's text dumps: columns by their names, boxes by their bounds, frames.
#include <fcntl.h>
#include <unistd.h>

#include "bench/spheres/sphere_file.h"
#include "tests/support/pairs_command.h"

namespace spherepair {
namespace {

std::string dump(const std::string& bounds, const std::string& atoms, size_t count = 2,
                 const std::string& before = "") {
  return fmt::format("{}ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS {}\nITEM: ATOMS {}\n", before,
                     count, bounds, atoms);
}
const std::string open_box = "ff ff ff\n-1 9\n0 4\n0 5.5", periodic = "pp pp ff\n0 4\n0 5\n0 6";
const std::string grains = "id type diameter x y z vx vy vz\n7 1 2 0.5 1 1 1 2 3\n9 2 3 2.5 1 1.25 0 0 0";

class LammpsDump : public PairsCommand {
 protected:
  SphereFile read(const std::string& text, const SphereFileOptions& options = {}) {
    return read_sphere_file(folder_.write("a.lammpstrj", text), options);
  }
  std::string refusal(const std::string& text, const SphereFileOptions& options = {.radius = 1}) {
    return complaint_of([&] { read(text, options); });
  }
  std::string listed(const std::string& name, const std::string& text, double cutoff) {
    PairsOptions asked = options("pairs.txt");
    asked.input_file = folder_.write(name, text);
    asked.cutoff = cutoff;
    EXPECT_EQ(run(asked), "") << name;
    return read_bytes(asked.output_file);
  }
};

TEST_F(LammpsDump, ColumnsMeanWhatTheirNamesSay) {
  const SphereFile file = read(dump(open_box, grains, 2, "ITEM: UNITS\nsi\nITEM: TIME\n0.5\n"));
  ASSERT_EQ(file.scene.size(), 2u);
  const vec4 &p = file.scene.positions[1], &v = file.scene.velocities[0];
  EXPECT_EQ((std::array{p.x, p.y, p.z, p.w}), (std::array{2.5f, 1.0f, 1.25f, 1.5f}));
  EXPECT_EQ((std::array{v.x, v.y, v.z}), (std::array{1.0f, 2.0f, 3.0f}));
  EXPECT_EQ(file.units, "LAMMPS's units si");
  EXPECT_TRUE(file.format.starts_with("LAMMPS dump (id type diameter x y z vx vy vz)")) << file.format;
  EXPECT_TRUE(
      read(dump(open_box, "x y z q\x98\n1 2 3 4", 1), {.radius = 1}).format.starts_with("LAMMPS dump (x y z q\\x98)"));
  ASSERT_TRUE(file.box);
  EXPECT_EQ(file.box->low, (std::array{-1.0f, 0.0f, 0.0f}));
  EXPECT_EQ(file.box->high, (std::array{9.0f, 4.0f, 5.5f}));
}

TEST_F(LammpsDump, OnlyFixedBoundsAreWalls) {
  for (const char* flags : {"ss ff ff", "ff mm ff", "fs ff ff"})
    EXPECT_FALSE(read(dump(std::string(flags) + "\n0 1\n0 1\n0 1", grains)).box) << flags;
  EXPECT_FALSE(read(dump("xy xz yz ff ff ff\n0 5 1\n0 4 0\n0 4 0", grains)).box);
}

TEST_F(LammpsDump, UnwrappedCoordinatesAreTakenWhereThereAreNoOthers) {
  const SphereFileOptions one = {.radius = 1};
  EXPECT_EQ(read(dump(open_box, "id xu yu zu\n1 5 6 7", 1), one).scene.positions[0].x, 5);
  EXPECT_EQ(read(dump(open_box, "id xu yu zu x y z\n1 5 6 7 1 2 3", 1), one).scene.positions[0].x, 1);
  EXPECT_EQ(read(dump(open_box, "id q yu zu xu\n1 5 6 7 8", 1), {.radius = 1, .columns = {"x=q", "y=yu", "z=zu"}})
                .scene.positions[0]
                .x,
            5);
}

TEST_F(LammpsDump, SpeciesAreElementsOrTypes) {
  const SphereFileOptions named = {.radius = 1, .species = true};
  EXPECT_EQ(read(dump(open_box, "type x y z\n2 0 0 0\n1 1 1 1"), named).species, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(read(dump(open_box, "type element x y z\n2 He 0 0 0\n1 Ar 1 1 1"), named).species,
            (std::vector<std::string>{"Ar", "He"}));
}

TEST_F(LammpsDump, FramesAreReadInOrder) {
  const std::string text = dump(open_box, "x y z\n1 0 0", 1) + dump(open_box, "z y x\n0 0 2\n0 0 3\n", 2);
  EXPECT_EQ(read(text, {.radius = 1, .frame = 1}).scene.positions[1].x, 3);
  EXPECT_EQ(read(text, {.radius = 1}).frames, 2u);
  const auto frames = read_sphere_frames(folder_.path("a.lammpstrj"), {.radius = 1});
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].scene.positions[0].x, 1);
}

// The same spheres and box as extended XYZ, whose lists have their own oracle. Tilts that lean to both sides.
TEST_F(LammpsDump, PairsInItsBoxAreThoseOfTheSameLattice) {
  const std::string atoms = "3.75 0.5 0.25\n0.25 4.75 0.5\n1.5 2.5 5.75\n2.75 0.125 3\n";
  const std::string xyz = "4\nLattice=\"{}\" pbc=\"{}\" Properties=pos:R:3\n" + atoms;
  const auto of_dump = [&](const std::string& bounds) {
    return listed("a.dump", dump(bounds, "x y z\n" + atoms, 4), 3.5);
  };
  const auto of_lattice = [&](const char* lattice, const char* pbc) {
    return listed("a.xyz", fmt::format(fmt::runtime(xyz), lattice, pbc), 3.5);
  };
  const std::string straight = of_dump(periodic);
  EXPECT_EQ(straight, of_lattice("4 0 0 0 5 0 0 0 6", "T T F"));
  const std::string tilted = of_lattice("4 0 0 -1.5 5 0 1 -0.5 6", "T T T");
  EXPECT_EQ(of_dump("xy xz yz pp pp pp\n-1.5 5 -1.5\n-0.5 5 1\n0 6 -0.5"), tilted);
  EXPECT_EQ(of_dump("abc origin pp pp pp\n4 0 0 0\n-1.5 5 0 0\n1 -0.5 6 0"), tilted);
  EXPECT_NE(straight, tilted);
  EXPECT_GT(std::ranges::count(straight, '\n'), 1);
}

TEST_F(LammpsDump, AStreamIsKnownByItsFirstItem) {
  PairsOptions asked = options("pairs.txt");
  asked.radius = 1.5;
  const std::string file = folder_.write("pipe", dump(open_box, "x y z\n0 0 0\n1 1 1"));
  const int pipe = open(file.c_str(), O_RDONLY);
  asked.input_file = fmt::format("/dev/fd/{}", pipe);
  EXPECT_EQ(run(asked), "");
  close(pipe);
  EXPECT_EQ(read_bytes(asked.output_file), "# i j\n0 1\n");
}

TEST_F(LammpsDump, WhatIsWrongIsNamed) {
  const std::string good = dump(open_box, "x y z\n0 0 0\n1 1 1");
  const auto expect = [&](const std::string& text, const std::string& words,
                          const SphereFileOptions& options = {.radius = 1}) {
    const std::string found = refusal(text, options);
    EXPECT_NE(found.find(words), found.npos) << text << "\n" << found;
  };
  expect(dump(periodic, "x y z\n0 0 0", 1), "line 5: expected spheres without a periodic box");
  expect(dump(open_box, "xs ys zs\n0 0 0", 1), "line 9: expected coordinates x y z, or xu yu zu");
  expect(dump("\n0 1\n0 1\n0 1", "x y z\n0 0 0", 1), "line 5: expected BOX BOUNDS and for each axis");
  expect(dump("pf ff ff\n0 1\n0 1\n0 1", "x y z\n0 0 0", 1), "line 5: expected BOX BOUNDS and for each axis");
  expect(dump("pp ff\n0 1\n0 1\n0 1", "x y z\n0 0 0", 1), "line 5: expected BOX BOUNDS and for each axis");
  expect(dump("ff ff ff\n0 1\n0 nan\n0 1", "x y z\n0 0 0", 1), "line 7: expected 2 finite numbers of the box");
  expect(dump("xy xz yz ff ff ff\n0 1 0\n0 1\n0 1 0", "x y z\n0 0 0", 1), "line 7: expected 3 finite numbers");
  expect(dump("pp ff ff\n1 1\n0 1\n0 1", "x y z\n0 0 0", 1), "line 6: expected an upper bound above the lower one");
  expect(dump("ff ff ff\n0 1\n1 0\n0 1", "x y z\n0 0 0", 1), "line 7: expected an upper bound above the lower one");
  expect(dump("xy xz yz pp pp pp\n0 0.5 1\n0 4 0\n0 4 0", "x y z\n0 0 0", 1), "line 6: expected an upper bound");
  expect(dump(open_box, "x y z\n0 0 0", 3), "3 spheres as line 4 says");
  expect(dump(open_box, "id x y\n0 0 0", 1), "columns x, y and z must be among");
  expect("ITEM: TIMESTEP\n0\n", "the end of the file");
  expect("ITEM: TIMESTEP\n0\nITEM: ATOMS x y z\n", "line 3: expected ITEM: NUMBER OF ATOMS and ITEM: BOX BOUNDS");
  expect("ITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS x y z\n0 0 0\n",
         "line 3: expected ITEM: NUMBER OF ATOMS and ITEM: BOX BOUNDS");
  expect("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n1\n", "line 3: expected ITEM: NUMBER OF ATOMS");
  expect("1\n\nHe 0 0 0\n", "line 1: expected ITEM:");
  expect(good + "ITEM:", "line 12: expected ITEM:");
  expect(good, "has no periodic box: omit --ignore-periodic", {.radius = 1, .ignore_periodic = true});
  expect(good, "type or element", {.radius = 1, .species = true});
  EXPECT_EQ(read(dump(periodic, "x y z\n0 0 0", 1), {.radius = 1, .ignore_periodic = true}).ignored,
            "BOX BOUNDS pp pp ff");
}

}  // namespace
}  // namespace spherepair
