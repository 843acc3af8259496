// SPDX-License-Identifier: MIT
// What `pairs` reads and writes other than plain pairs: geometry, numbers of contacts, standard input.
#include "tests/support/pairs_command.h"

namespace spherepair {
namespace {

TEST_F(PairsCommand, WritesOverlapNormalAndPointOfEachPair) {
  PairsOptions three = options("pairs.txt");
  three.geometry = true;
  three.input_file = folder_.write("three.txt", "0 0 0 1\n1.5 0 0 1\n0 0 0 1\n");
  EXPECT_EQ(run(three), "");
  EXPECT_EQ(read_bytes(three.output_file),
            "# i j overlap nx ny nz px py pz\n0 1 0.5 1 0 0 0.75 0 0\n0 2 2 0 0 0 0 0 0\n1 2 0.5 -1 0 0 0.75 0 0\n");
  three.output_file = folder_.path("pairs.csv");
  EXPECT_EQ(run(three), "");
  EXPECT_EQ(read_bytes(three.output_file),
            "i,j,overlap,nx,ny,nz,px,py,pz\n0,1,0.5,1,0,0,0.75,0,0\n0,2,2,0,0,0,0,0,0\n1,2,0.5,-1,0,0,0.75,0,0\n");
  three.output_file = folder_.path("pairs.npy");
  EXPECT_EQ(run(three), "");
  const std::string bytes = read_bytes(three.output_file);
  EXPECT_NE(
      bytes.find("[('i', '<u4'), ('j', '<u4'), ('overlap', '<f8'), ('normal', '<f8', (3,)), ('point', '<f8', (3,))]"),
      std::string::npos);
  ASSERT_EQ(bytes.size() % 64, 0u);
  const std::string last = bytes.substr(bytes.size() - 64);
  std::array<uint, 2> indices;
  std::array<double, 7> numbers;
  std::memcpy(indices.data(), last.data(), 8);
  std::memcpy(numbers.data(), last.data() + 8, 56);
  EXPECT_EQ(indices, (std::array<uint, 2>{1, 2}));
  EXPECT_EQ(numbers, (std::array<double, 7>{0.5, -1, 0, 0, 0.75, 0, 0}));
}

// Also far from the origin, where the numbers of the overlap cancel.
TEST_F(PairsCommand, ContactPointsAreWhereTheFileHasThem) {
  PairsOptions far = options("pairs.csv");
  far.geometry = true;
  far.input_file = folder_.write("far.txt", "100000.125 0 0 1\n100001.625 0 0 1\n");
  EXPECT_EQ(run(far), "");
  EXPECT_EQ(read_bytes(far.output_file), "i,j,overlap,nx,ny,nz,px,py,pz\n0,1,0.5,1,0,0,100000.875,0,0\n");
  far.input_file = folder_.write("near.txt", "1e9 0 0 1\n1000000001.9999999 0 0 1\n");
  EXPECT_EQ(run(far), "");
  EXPECT_NE(read_bytes(far.output_file).find("0,1,1.1920928955078125e-07,1,0,0,1000000001,0,0"), std::string::npos)
      << read_bytes(far.output_file);
}

TEST_F(PairsCommand, WritesTheNumberOfContactsOfEachSphere) {
  std::vector<uint> counts(spheres().size());
  for (const Pair& pair : expected_) ++counts[pair.first], ++counts[pair.second];
  PairsOptions both = options("pairs.txt");
  both.contacts_file = folder_.path("contacts.npy");
  EXPECT_EQ(run(both), "");
  const std::string bytes = read_bytes(both.contacts_file);
  ASSERT_EQ(bytes.size(), 128 + 4 * counts.size());
  EXPECT_EQ(std::memcmp(bytes.data() + 128, counts.data(), 4 * counts.size()), 0);
  both.contacts_file = folder_.path("contacts.txt");
  EXPECT_EQ(run(both), "");
  EXPECT_EQ(read_bytes(both.contacts_file), fmt::format("# contacts\n{}\n", fmt::join(counts, "\n")));
  both.contacts_file = folder_.path("contacts.csv");
  EXPECT_EQ(run(both), "");
  EXPECT_EQ(read_bytes(both.contacts_file), fmt::format("contacts\n{}\n", fmt::join(counts, "\n")));
  both.contacts_file = folder_.path("contacts.dat");
  EXPECT_NE(run(both).find("the format of --contacts"), std::string::npos);
}

// Of float32 centres, whose distance is 0.2 + 9e-11: float32's 0.1 reaches farther.
TEST_F(PairsCommand, TheRadiusGivenIsNotRounded) {
  PairsOptions pair = options("pairs.txt");
  const std::vector<float> rows = {0, 0, 0, 13096 * 0x1p-16f, 390 * 0x1p-16f, 376 * 0x1p-16f};
  pair.input_file = folder_.write("rad.npy", npy_file(npy_header("<f4", "(2, 3)"), npy_data(rows, 3)));
  for (const auto& [radius, lines] : {std::pair(0.1, "# i j\n"), {double(0.1f), "# i j\n0 1\n"}}) {
    pair.radius = radius;
    EXPECT_EQ(run(pair), "");
    EXPECT_EQ(read_bytes(pair.output_file), lines) << radius;
  }
  EXPECT_EQ(errors_, "");
}

// The plane of the paper's scenes is at -5.
TEST_F(PairsCommand, SpheresDeepDownStayWhereTheyAreUntilTheyMove) {
  if (!fs::exists(SPHEREPAIR_PROGRAM)) GTEST_SKIP() << "no " << SPHEREPAIR_PROGRAM << " here";
  const std::string deep = folder_.write("deep.txt", "0 -50 0 1\n0 -60 0 1\n0 -51 0 1\n");
  for (const char* motion : {"", " --motion impact --steps 1", " --motion paper-clamp --steps 1"}) {
    EXPECT_EQ(
        run_program(fmt::format("run --backend cpu --input {}{} --pairs {}", deep, motion, folder_.path("run.txt"))),
        kOk)
        << errors_;
    EXPECT_EQ(read_bytes(folder_.path("run.txt")), "# i j\n0 2\n") << motion;
  }
}

TEST_F(PairsCommand, ReadsStandardInput) {
  if (!fs::exists(SPHEREPAIR_PROGRAM)) GTEST_SKIP() << "no " << SPHEREPAIR_PROGRAM << " here";
  const std::string pairs = "pairs --backend cpu --input - --output -";
  for (const auto& [text, options] : {std::pair("0 0 0 1\\n1 0 0 1\\n", ""),
                                      {"0 0 0\\n1 0 0\\n", " --radius 1"},
                                      {"2\\n\\n0 0 0 1\\n1 0 0 1\\n", ""},
                                      {"A 0 0 0 1\\nB 1 0 0 1\\n", " --columns _,x,y,z,radius"}}) {
    EXPECT_EQ(run_program(pairs + options, fmt::format("printf '{}' |", text)), kOk) << errors_;
    EXPECT_EQ(output_, "0 1\n") << text;
    EXPECT_NE(errors_.find("standard input: "), std::string::npos) << errors_;
  }
  EXPECT_EQ(
      run_program(pairs, fmt::format("cat '{}' |",
                                     folder_.write("a.npy", npy_file(npy_header("<f4", "(2, 4)"),
                                                                     npy_data<float>({0, 0, 0, 1, 1, 0, 0, 1}, 4))))),
      kOk);
  EXPECT_EQ(output_, "0 1\n");
  EXPECT_EQ(run_program(pairs, "printf '' |"), kUsage);
  EXPECT_NE(errors_.find("standard input holds no sphere"), std::string::npos) << errors_;
}

}  // namespace
}  // namespace spherepair
