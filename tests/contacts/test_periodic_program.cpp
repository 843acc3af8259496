// SPDX-License-Identifier: MIT
// Runs in periodic boxes: options, checkpoints, files with a box, and what is refused.
#include <algorithm>
#include <set>
#include <sstream>

#include "tests/contacts/run_program.h"

namespace spherepair {
namespace {

using PeriodicProgram = RunProgram;

const std::string gas_run = "run --backend cpu --scene gas --n 200 --contact spring --restitution 0.9 --periodic xyz";

TEST_F(PeriodicProgram, GoesOnFromACheckpoint) {
  good(fmt::format("{} --steps 300 --json {}", gas_run, path("a.json")));
  good(fmt::format("{} --steps 170 --save {}", gas_run, path("ck")));
  const Outcome outcome =
      good(fmt::format("run --backend cpu --resume {} --steps 130 --json {}", path("ck"), path("b.json")));
  EXPECT_EQ(state("a.json"), state("b.json"));
  EXPECT_EQ(read_json("b.json").at("contacts").at("periodic"), "xyz");
  EXPECT_NE(outcome.output.find("periodic along xyz: box from 0, 0, 0 to"), std::string::npos) << outcome.output;
  good(fmt::format("run --backend cpu --resume {} --steps 10 --restitution 0.8 --json {}", path("ck"), path("c.json")));
  EXPECT_EQ(read_json("c.json").at("contacts").at("periodic"), "xyz") << "a new run from its spheres";
}

// `pairs` finds in the written file, whose box is periodic, the pairs that the run found.
TEST_F(PeriodicProgram, WritesItsBoxAndReadsIt) {
  good(fmt::format("{} --packing-fraction 0.5 --steps 200 --spheres {} --json {} --pairs {}", gas_run,
                   path("end.extxyz"), path("a.json"), path("a.csv")));
  const std::string text = read_bytes(path("end.extxyz"));
  EXPECT_NE(text.find("pbc=\"T T T\""), std::string::npos) << text.substr(0, 300);
  good(fmt::format("pairs --backend cpu {} --output {}", path("end.extxyz"), path("b.csv")));
  const std::string found = read_bytes(path("a.csv"));
  EXPECT_GT(std::ranges::count(found, '\n'), 5);
  const auto ids = [](std::string pairs) {  // i and j of each row, whatever follows
    std::istringstream rows(pairs);
    std::set<std::pair<int, int>> all;
    char comma = 0;
    for (int i = 0, j = 0; std::getline(rows, pairs);)
      if (std::istringstream(pairs) >> i >> comma >> j) all.insert({std::min(i, j), std::max(i, j)});
    return all;
  };
  EXPECT_EQ(ids(found), ids(read_bytes(path("b.csv"))));
  const Outcome outcome =
      good(fmt::format("run --backend cpu --input {} --contact spring --gravity 0 --steps 5 --json {}",
                       path("end.extxyz"), path("c.json")));
  EXPECT_EQ(read_json("c.json").at("contacts").at("periodic"), "xyz") << outcome.output;
  EXPECT_FALSE(read_json("c.json").at("contacts").at("walls"));
}

TEST_F(PeriodicProgram, TakesTheBoxOfAFile) {
  const auto file = [&](const std::string& box) {
    folder_.write("box.extxyz", fmt::format("2\nProperties=pos:R:3:radius:R:1 {}\n1 1 1 0.25\n3 1.5 3.9 0.25\n", box));
    return fmt::format("run --backend cpu --input {} --contact spring --steps 3 --json {} ", path("box.extxyz"),
                       path("a.json"));
  };
  const auto contacts = [&] { return read_json("a.json").at("contacts"); };
  const std::string slab = "Lattice=\"4 0 0 0 8 0 0 0 4\" pbc=\"T F T\"";
  good(file(slab));
  EXPECT_EQ(contacts().at("periodic"), "xz");
  EXPECT_FALSE(contacts().at("walls"));
  good(file(slab) + "--walls");
  EXPECT_EQ(contacts().at("periodic"), "xz");
  EXPECT_TRUE(contacts().at("walls")) << "the floor and the lid";
  good(file("Lattice=\"4 0 0 0 8 0 0 0 4\" pbc=\"F F F\"") + "--walls --periodic z");
  EXPECT_EQ(contacts().at("periodic"), "z");
  good(file(slab) + "--ignore-periodic");
  EXPECT_FALSE(contacts().contains("periodic"));
  refused(file("Lattice=\"4 0 0 1 8 0 0 0 4\" pbc=\"T F T\""), "a periodic box along the axes");
  const auto notes = [&](const std::string& arguments, const std::string& words) {
    const Outcome outcome = good(arguments);
    EXPECT_NE(outcome.output.find(words), std::string::npos) << outcome.output;
  };
  const std::string flat = "Lattice=\"4 0 0 0 0 0 0 0 4\" pbc=\"T F T\"";
  notes(file(slab), "open faces spheres can leave: --walls closes them");
  notes(file(slab), "periodic along xz, open along y");
  notes(file("Lattice=\"4 0 0 0 8 0 0 0 3.5\" pbc=\"T F T\""), "1 centre outside the periodic box: wrapped");
  notes(file(flat), "periodic along xz, open along y");
  refused(file(flat) + "--walls", "needs a length");
  refused(file(slab) + "--box 0,0,0,9,9,9", "omit --box");
  refused(file(slab + " Origin=\"0 0\""), "Origin of three numbers");
  folder_.write("box.data",
                "atoms\n\n2 atoms\n-2 2 xlo xhi\n-2 2 ylo yhi\n-2 2 zlo zhi\n\nAtoms # sphere\n\n"
                "1 1 0.5 1000 1.9 0 0\n2 1 0.5 1000 -1.7 0.2 0\n");
  notes("run --backend cpu --contact spring --gravity 0 --steps 3 --input " + path("box.data"),
        "from -2, -2, -2 to 2, 2, 2");
  refused(file("Lattice=\"4 0 0 0 8 0 0 0 4\" pbc=\"T T T\""), "gravity is -9.81");
  refused(fmt::format("run --input {} --steps 3", path("box.extxyz")), "--contact");
}

TEST_F(PeriodicProgram, IsComparedByTheMethodsOfAllPairs) {
  const Outcome outcome = good(
      "compare --scenes gas --n 60 --steps 4 --every 2 --backends cpu --contact spring --periodic xyz --tables none "
      "--results " +
      path("r"));
  EXPECT_EQ(outcome.output.find("collide_group"), std::string::npos) << outcome.output;
}

TEST_F(PeriodicProgram, RefusesWhatHasNoMeaning) {
  refused("run --scene gas --n 20 --periodic xyz --steps 3", "--periodic");
  refused("run --scene gas --n 20 --contact spring --steps 3 --periodic xx", "axes x, y and z");
  refused("run --scene gas --n 20 --contact spring --steps 3 --periodic w", "axes x, y and z");
  refused("run --scene bed --n 20 --contact spring --steps 3 --periodic xyz", "gravity");
  refused("run --scene column --n 20 --contact spring --steps 3 --periodic xz", "need a box");
  refused("run --scene gas --n 2 --contact spring --steps 3 --periodic x --packing-fraction 0.5",
          "must be longer than");
  for (const char* other : {"--swept", "--naive", "--method collide_group"})
    refused(fmt::format("{} --steps 3 {}", gas_run, other), "goes with neither --naive, --swept nor");
}

}  // namespace
}  // namespace spherepair
