// SPDX-License-Identifier: MIT
// What `pairs` reads and writes other than plain pairs: geometry, numbers of contacts, standard input, rounding.
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

// Also where the spheres were shifted.
TEST_F(PairsCommand, ContactPointsAreWhereTheFileHasThem) {
  PairsOptions far = options("pairs.txt");
  far.geometry = true;
  far.verbosity = Verbosity::verbose;
  far.input_file = folder_.write("far.txt", "100000.1 0 0 1\n100001.6 0 0 1\n");
  EXPECT_EQ(run(far), "");
  EXPECT_NE(output_.find("shifted by (-100001, 0, 0)"), std::string::npos) << output_;
  double point = 0;
  ASSERT_EQ(std::sscanf(read_bytes(far.output_file).c_str(), "# %*[^\n] 0 1 %*f 1 0 0 %lf", &point), 1);
  EXPECT_NEAR(point, 100000.85, 1e-6);
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

// A lattice of tangent spheres in tenths, which no binary number represents.
TEST_F(PairsCommand, SaysHowManyPairsRoundingCanDecide) {
  std::vector<double> rows;
  for (int k = 0; k < 1000; ++k) rows.insert(rows.end(), {100 + 0.1 * (k % 10), 0.1 * (k / 10 % 10), 0.1 * (k / 100)});
  PairsOptions tangent = options("pairs.txt");
  tangent.radius = 0.05f;
  tangent.json_file = folder_.path("pairs.json");
  tangent.input_file = folder_.write("tangent.npy", npy_file(npy_header("<f8", "(1000, 3)"), npy_data(rows, 3)));
  EXPECT_EQ(run(tangent), "");
  EXPECT_NE(errors_.find("2700 pairs are so close to touching"), std::string::npos) << errors_;
  EXPECT_EQ(json::parse(read_bytes(tangent.json_file)).at("pairs_within_rounding"), 2700);
  tangent.radius = 0.06f;
  EXPECT_EQ(run(tangent), "");
  EXPECT_EQ(errors_, "");
  EXPECT_NE(output_.find("2700 pairs, "), std::string::npos) << output_;
}

// Of float32 centres, whose distance is 0.2 + 9e-11: float32's 0.1 reaches farther.
TEST_F(PairsCommand, TheRadiusGivenCanDecideToo) {
  PairsOptions pair = options("pairs.txt");
  pair.radius = 0.1;
  const std::vector<float> rows = {0, 0, 0, 13096 * 0x1p-16f, 390 * 0x1p-16f, 376 * 0x1p-16f};
  pair.input_file = folder_.write("rad.npy", npy_file(npy_header("<f4", "(2, 3)"), npy_data(rows, 3)));
  EXPECT_EQ(run(pair), "");
  EXPECT_NE(errors_.find("1 pair is so close to touching"), std::string::npos) << errors_ << output_;
  pair.radius = 0.125;
  EXPECT_EQ(run(pair), "");
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
