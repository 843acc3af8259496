// SPDX-License-Identifier: MIT
// pairs of spheres in a periodic box, as extended XYZ has it: Lattice and pbc.
#include "bench/npy/rows_file.h"
#include "tests/oracle/list_oracle.h"
#include "tests/support/pairs_command.h"

namespace spherepair {
namespace {

class PeriodicPairs : public PairsCommand {
 protected:
  // A frame of these points in this box; numbers are multiples of 1/8 or written with all digits.
  std::string file_of(const std::string& name, const ListProblem& problem, bool radii) {
    const ListBox& box = problem.boxes[0];
    std::string text = fmt::format("{}\nLattice=\"", problem.set.size());
    for (size_t k = 0; k < 9; ++k) text += fmt::format("{}{}", k ? " " : "", box.rows[k / 3][k % 3]);
    text += "\" pbc=\"";
    for (size_t k = 0; k < 3; ++k) text += fmt::format("{}{}", k ? " " : "", box.periodic[k] ? 'T' : 'F');
    text += fmt::format("\" Properties=pos:R:3{}\n", radii ? ":radius:R:1" : "");
    for (size_t i = 0; i < problem.set.size(); ++i) {
      text += fmt::format("{}", fmt::join(problem.set.points[i], " "));
      text += radii ? fmt::format(" {}\n", problem.set.radii[i]) : "\n";
    }
    return folder_.write(name, text);
  }

  static std::string lines_of(const std::vector<ListedPair>& list) {
    std::string text = "# i j sx sy sz\n";
    for (const ListedPair& pair : list)
      text += fmt::format("{} {} {}\n", pair.first, pair.second, fmt::join(pair.shift, " "));
    return text;
  }

  // One system of random_problem, as the command searches it.
  static ListProblem one_system(Random& random) {
    for (;;) {
      ListProblem problem = random_problem(random);
      if (problem.asks || problem.boxes.size() != 1 || problem.boxes[0].is_open() || problem.set.size() == 0) continue;
      problem.exclusions.clear(), problem.skin = 0;
      problem.half = true, problem.self_pairs = false;
      problem.inclusive = problem.set.radii.empty();
      return problem;
    }
  }
};

TEST_F(PeriodicPairs, AreThoseOfAllPointsAndImages) {
  Random random(63);
  uint64_t pairs = 0;
  for (int k = 0; k < 100; ++k) {
    const ListProblem problem = one_system(random);
    const bool radii = !problem.set.radii.empty();
    PairsOptions asked = options("pairs.txt");
    asked.input_file = file_of("box.xyz", problem, radii);
    if (!radii) asked.cutoff = problem.cutoff;
    ASSERT_EQ(run(asked), "") << k;
    const std::vector<ListedPair> wanted = list_by_integers(problem, 10);
    ASSERT_EQ(read_bytes(asked.output_file), lines_of(wanted)) << k;
    pairs += wanted.size();
  }
  EXPECT_GT(pairs, 200u);
}

// Decided by the file's digits: float32 would take 2^24 + 1 and 2^24 for one.
TEST_F(PeriodicPairs, NoNumberIsRounded) {
  PairsOptions asked = options("pairs.csv");
  asked.input_file = folder_.write("far.xyz",
                                   "3\nLattice=\"40000000 0 0 0 40000000 0 0 0 40000000\" Properties=pos:R:3\n"
                                   "16777216 0 0\n16777217 0 0\n16777218.0000001 0 0\n");
  asked.cutoff = 1;
  asked.distances = true;
  ASSERT_EQ(run(asked), "");
  EXPECT_EQ(read_bytes(asked.output_file), "i,j,sx,sy,sz,distance\n0,1,0,0,0,1\n");
  EXPECT_EQ(errors_, "");
}

// Two spheres of radius 1 across a boundary, 1.5 apart: the contact is beside the first as given.
TEST_F(PeriodicPairs, ContactsAreThoseOfTheImage) {
  PairsOptions asked = options("pairs.csv");
  asked.input_file =
      folder_.write("two.xyz", "2\nLattice=\"8 0 0 0 8 0 0 0 8\" Properties=pos:R:3:radius:R:1\n7 1 1 1\n0.5 1 1 1\n");
  asked.geometry = true;
  ASSERT_EQ(run(asked), "");
  EXPECT_EQ(read_bytes(asked.output_file), "i,j,sx,sy,sz,overlap,nx,ny,nz,px,py,pz\n0,1,1,0,0,0.5,1,0,0,7.75,1,1\n");
  asked.output_file = folder_.path("pairs.npy");
  ASSERT_EQ(run(asked), "");
  const std::string bytes = read_bytes(asked.output_file);
  EXPECT_NE(bytes.find("[('i', '<u4'), ('j', '<u4'), ('shift', '<i4', (3,)), ('overlap', '<f8'), "), std::string::npos);
  EXPECT_EQ(bytes.size() - bytes.find('\n') - 1, 76u);
}

TEST_F(PeriodicPairs, NeighboursHaveTheirShifts) {
  PairsOptions asked = options("list.npy");
  asked.input_file =
      folder_.write("cubic.xyz", "1\nLattice=\"1 0 0 0 1 0 0 0 1\" pbc=\"T T F\" Properties=pos:R:3\n0 0 5\n");
  asked.cutoff = 1;
  asked.csr = asked.distances = true;
  asked.contacts_file = folder_.path("contacts.txt");
  ASSERT_EQ(run(asked), "");
  const auto numbers = [&](const std::string& name) {
    const std::string bytes = read_bytes(folder_.path(name));
    return bytes.substr(std::min(bytes.size(), bytes.find('\n') + 1));
  };
  const int32_t shifts[] = {-1, 0, 0, 0, -1, 0, 0, 1, 0, 1, 0, 0};
  const uint64_t offsets[] = {0, 4};
  EXPECT_EQ(numbers("list.shifts.npy"), bytes_of(std::span<const int32_t>(shifts)));
  EXPECT_EQ(numbers("list.offsets.npy"), bytes_of(std::span<const uint64_t>(offsets)));
  EXPECT_EQ(numbers("list.neighbours.npy"), std::string(4 * sizeof(uint32_t), '\0'));
  EXPECT_EQ(numbers("list.distances.npy").size(), 4 * sizeof(double));
  EXPECT_EQ(read_bytes(asked.contacts_file), "# contacts\n4\n");
  EXPECT_NE(output_.find("2 pairs"), std::string::npos) << output_;
}

TEST_F(PeriodicPairs, WhatIsNotPossibleIsRefused) {
  const auto refusal = [&](const std::string& comment) {
    PairsOptions asked = options("pairs.txt");
    asked.input_file = folder_.write("box.xyz", "1\n" + comment + " Properties=pos:R:3:radius:R:1\n1 2 3 0.5\n");
    const std::string complaint = run(asked);
    EXPECT_FALSE(fs::exists(folder_.path("pairs.txt"))) << comment;
    return complaint;
  };
  EXPECT_NE(refusal("Lattice=\"1 0 0 0 1 0 0 0 0\"").find("boxes[0]: its periodic rows span no volume"),
            std::string::npos);
  EXPECT_NE(refusal("cell=\"1 1 1\"").find("Lattice=\"...\" of nine numbers"), std::string::npos);
  EXPECT_NE(refusal("Lattice=\"1 1 1\"").find("Lattice=\"...\" of nine numbers"), std::string::npos);
  EXPECT_EQ(run_program(fmt::format("run --input '{}' --steps 1", folder_.path("box.xyz"))), kUsage);
  EXPECT_NE(errors_.find("only `pairs` and runs with --contact find pairs across"), std::string::npos) << errors_;
}

}  // namespace
}  // namespace spherepair
