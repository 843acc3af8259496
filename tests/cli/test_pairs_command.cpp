// SPDX-License-Identifier: MIT
// spherepair pairs as a whole: a file of spheres in, pairs and a summary out, and nothing lost when it fails.
#include "tests/support/pairs_command.h"

namespace spherepair {
namespace {

TEST_F(PairsCommand, FindsThePairsOnEveryBackend) {
  ASSERT_GT(expected_.size(), 1000u);
  for (const OpenedBackend& entry : all_backends()) {
    PairsOptions chosen = options(entry.name + ".txt");
    chosen.backend = entry.name;
    if (!entry.backend) continue;
    EXPECT_EQ(run(chosen), "");
    EXPECT_EQ(read_bytes(chosen.output_file), text_of(expected_)) << entry.name;
  }
  PairsOptions fastest = options("fastest.txt");
  fastest.backend = "";
  EXPECT_EQ(run(fastest), "");
  EXPECT_EQ(read_bytes(fastest.output_file), text_of(expected_)) << output_;
}

TEST_F(PairsCommand, WritesNpy) {
  EXPECT_EQ(run(options("pairs.npy")), "");
  const std::string bytes = read_bytes(folder_.path("pairs.npy"));
  const std::string header =
      fmt::format("{{'descr': '<u4', 'fortran_order': False, 'shape': ({}, 2), }}", expected_.size());
  ASSERT_EQ(bytes.size(), 128 + 8 * expected_.size());
  EXPECT_EQ(bytes.substr(0, 10 + header.size()), std::string("\x93NUMPY\x01\x00\x76\x00", 10) + header);
  EXPECT_EQ(bytes[127], '\n');
  EXPECT_EQ(std::memcmp(bytes.data() + 128, expected_.data(), 8 * expected_.size()), 0);
}

TEST_F(PairsCommand, WritesNoPairsToo) {
  PairsOptions lone = options("none.npy");
  lone.input_file = folder_.write("lone.xyz", "1\n\n1. 2 3 4\n");
  EXPECT_EQ(run(lone), "");
  EXPECT_EQ(read_bytes(lone.output_file).size(), 128u);
  lone.input_file = folder_.write("lone.xyz", "0\n\n");
  lone.output_file = folder_.path("none.txt");
  EXPECT_EQ(run(lone), "");
  EXPECT_TRUE(fs::exists(lone.output_file));
  EXPECT_NE(output_.find("0 pairs, 0 of 0 spheres"), std::string::npos) << output_;
}

TEST_F(PairsCommand, KeepsStandardOutputForThePairs) {
  EXPECT_EQ(run(options("-")), "");
  EXPECT_EQ("# i j\n" + output_, text_of(expected_)) << "no names on standard output";
  EXPECT_NE(errors_.find(fmt::format("{} pairs", expected_.size())), std::string::npos) << errors_;
}

TEST_F(PairsCommand, SummaryAndJson) {
  PairsOptions all = options("pairs.txt");
  all.json_file = folder_.path("pairs.json");
  EXPECT_EQ(run(all), "");
  std::vector<uint> counts(spheres().size());
  for (const Pair& pair : expected_) ++counts[pair.first], ++counts[pair.second];
  const uint64_t colliding_spheres = uint64_t(std::count_if(counts.begin(), counts.end(), colliding));
  EXPECT_NE(output_.find(fmt::format("{} pairs, {} of 1500 spheres collide", expected_.size(), colliding_spheres)),
            std::string::npos)
      << output_;
  const json record = json::parse(read_bytes(all.json_file));
  EXPECT_EQ(record.at("pairs"), expected_.size());
  EXPECT_EQ(record.at("colliding_spheres"), colliding_spheres);
  EXPECT_EQ(record.at("input").at("n"), 1500);
  EXPECT_EQ(record.at("input").at("numbers"), 6000);
  EXPECT_TRUE(record.at("context").contains("build") && record.at("seconds").contains("load"));
}

// Control characters and invalid UTF-8 are escaped; the JSON file stays valid.
TEST_F(PairsCommand, NamesMayBeAnyBytes) {
  PairsOptions odd = options("pairs.txt");
  odd.input_file = folder_.write("odd\xff.xyz", "1\nProperties=\x1b\xff:S:1:pos:R:3:radius:R:1\nH 1 2 3 4\n");
  odd.json_file = folder_.path("pairs.json");
  EXPECT_EQ(run(odd), "");
  EXPECT_NE(output_.find("'\\x1b\\xff:S:1"), std::string::npos) << output_;
  EXPECT_TRUE(json::accept(read_bytes(odd.json_file)));
}

TEST_F(PairsCommand, NeverOverwritesTheInput) {
  const std::string before = read_bytes(input_);
  fs::create_hard_link(input_, folder_.path("link.txt"));
  fs::create_symlink(input_, folder_.path("symlink.npy"));
  for (const char* output : {"link.txt", "symlink.npy"})
    EXPECT_NE(run(options(output)).find("is the input"), std::string::npos) << output;
  PairsOptions json_over = options("pairs.txt");
  json_over.json_file = folder_.path("./spheres.xyz");
  EXPECT_NE(run(json_over).find("is the input"), std::string::npos);
  json_over.json_file =
      folder_.path("../" + fs::path(folder_.path("")).parent_path().filename().string() + "/pairs.txt");
  EXPECT_NE(run(json_over).find("is the output"), std::string::npos);
  EXPECT_EQ(read_bytes(input_), before);
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"link.txt", "spheres.xyz", "symlink.npy"}));
}

TEST_F(PairsCommand, FailureLosesNothing) {
  const std::string old = folder_.write("pairs.txt", "old"), neighbour = folder_.write("pairs.txt.new", "another's");
  PairsOptions bad = options("pairs.txt");
  bad.input_file = folder_.write("bad.xyz", "2\n\n1. 2 3 4\n1 2 x 4\n");
  EXPECT_NE(run(bad).find("bad.xyz, line 4"), std::string::npos);
  EXPECT_EQ(read_bytes(old), "old");
  for (const char* output : {"pairs.dat", "no/folder/pairs.txt", "pairs"})
    EXPECT_NE(run(options(output)), "") << output;
  PairsOptions groups = options("pairs.txt");
  groups.method = "collide_group";
  EXPECT_NE(run(groups).find("only pairs within a group"), std::string::npos);
  EXPECT_EQ(read_bytes(old), "old");
  EXPECT_EQ(run(options("pairs.txt")), "");
  EXPECT_EQ(read_bytes(old), text_of(expected_));
  EXPECT_EQ(read_bytes(neighbour), "another's");
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"bad.xyz", "pairs.txt", "pairs.txt.new", "spheres.xyz"}));
}

// 12.5 million pairs, 100 MB as threads find them.
TEST_F(PairsCommand, AListBeyondMemoryIsRefusedWithItsSize) {
  SKIP_WHERE_ADDRESS_SPACE_HAS_NO_LIMIT();
  if (!fs::exists(SPHEREPAIR_PROGRAM)) GTEST_SKIP() << "no " << SPHEREPAIR_PROGRAM << " here";
  std::string text = "5000\n\n";
  for (int k = 0; k < 5000; ++k) text += "1 2 3\n";
  const std::string pairs = "pairs --radius 1 --backend cpu --threads 1 --input " + folder_.write("one.xyz", text);
  for (const char* method : {"parallel", "collide_grid"}) {
    const std::string all = fmt::format("{} --output {} --method {}", pairs, folder_.path("one.npy"), method);
    EXPECT_EQ(run_program(all, "ulimit -v 200000;"), kDeviceFailure);
    EXPECT_NE(errors_.find("12497500 pairs collide, and a list of them takes about 0.3 GB"), std::string::npos)
        << errors_;
    EXPECT_FALSE(fs::exists(folder_.path("one.npy")));
  }
  EXPECT_EQ(run_program(fmt::format("{} --output {}", pairs, folder_.path("one.npy"))), kOk) << errors_;
}

TEST_F(PairsCommand, ProgramsExitCodes) {
  if (!fs::exists(SPHEREPAIR_PROGRAM)) GTEST_SKIP() << "no " << SPHEREPAIR_PROGRAM << " here";
  const std::string pairs = "pairs --backend cpu --output " + folder_.path("pairs.txt") + " --input ";
  EXPECT_EQ(run_program(pairs + input_), kOk) << errors_;
  EXPECT_EQ(read_bytes(folder_.path("pairs.txt")), text_of(expected_));
  fs::remove(folder_.path("pairs.txt"));
  EXPECT_EQ(run_program(pairs + folder_.write("bad.xyz", "1\n\n1 2\n") + " --radius 1"), kUsage);
  EXPECT_NE(errors_.find("bad.xyz, line 3: expected 3 columns"), std::string::npos) << errors_;
  EXPECT_EQ(run_program(pairs + folder_.write("bad.npy", "")), kUsage);
  EXPECT_NE(errors_.find("bad.npy, byte 0: expected the magic string"), std::string::npos) << errors_;
  EXPECT_EQ(run_program(pairs + input_ + " --radius 1"), kUsage);
  EXPECT_EQ(run_program(pairs + input_ + " --radius -1"), kUsage);
  EXPECT_EQ(run_program(pairs + input_ + " --frame 1"), kUsage);
  EXPECT_EQ(run_program("pairs --input " + input_ + " " + input_), kUsage);
  EXPECT_FALSE(fs::exists(folder_.path("pairs.txt")));
  EXPECT_EQ(run_program("run --backend cpu --input " + input_ + " --pairs " + folder_.path("run.txt")), kOk) << errors_;
  EXPECT_EQ(read_bytes(folder_.path("run.txt")), text_of(expected_));
}

}  // namespace
}  // namespace spherepair
