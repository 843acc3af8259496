// SPDX-License-Identifier: MIT
// How `pairs` is asked: options that fit together, input by any name, and how much it prints.
#include "tests/support/pairs_command.h"

namespace spherepair {
namespace {

TEST_F(PairsCommand, RefusesOptionsThatDoNotFitTogether) {
  if (!fs::exists(SPHEREPAIR_PROGRAM)) GTEST_SKIP() << "no " << SPHEREPAIR_PROGRAM << " here";
  const std::string file = folder_.write("points.txt", "0 0 0\n1 0 0\n"), out = " --output " + folder_.path("o");
  for (const auto& [arguments, words] :
       {std::pair{"--cutoff 1 --radius 1", "--radius does not go with --cutoff"},
        {"--cutoff -1", "--cutoff is -1, but must be within the range of float32 and not negative"},
        {"--cutoff nan", "must be within the range of float32"},
        {"--cutoff 4e38", "must be within the range of float32"},
        {"--cutoff 1 --geometry OUT.npy", "--cutoff does not go with --geometry"},
        {"--radius 1 --geometry --distances OUT.npy", "--distances does not go with --geometry"},
        {"--radius 1 --geometry --csr OUT.npy", "--csr does not go with --geometry"},
        {"--radius 1 --distances", "--distances has no effect without --output"},
        {"--radius 1 --csr", "--csr has no effect without --output"},
        {"--radius 1 --csr OUT.txt", "--csr writes NPY arrays, but --output is"},
        {"--radius 1 --csr --output -", "--csr writes NPY arrays, but --output is -"},
        {"--radius 1 OUT.dat", ".npy (NPY), .txt (text), .csv (CSV) and -"},
        {"--radius 1 --quiet", "--quiet has no effect without an output"},
        {"--radius 1 --quiet --verbose OUT.npy", "--quiet does not go with --verbose"}}) {
    std::string line = arguments;
    if (const size_t at = line.find("OUT"); at != line.npos) line.replace(at, 3, out);
    EXPECT_EQ(run_program("pairs --backend cpu " + file + " " + line), kUsage) << line;
    EXPECT_NE(errors_.find(words), std::string::npos) << line << ": " << errors_;
    EXPECT_EQ(output_, "") << line;
  }
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"points.txt", "spheres.xyz"}));
}

TEST_F(PairsCommand, NeverWritesTheNeighboursOverTheInput) {
  const std::string npy = npy_file(npy_header("<f4", "(1, 3)"), npy_data<float>({0, 0, 0}, 3));
  PairsOptions list = options("a.npy");
  list.csr = true;
  list.radius = 1;
  list.input_file = folder_.write("a.offsets.npy", npy);
  EXPECT_NE(run(list).find("is the input"), std::string::npos);
  EXPECT_EQ(read_bytes(list.input_file), npy);
}

TEST_F(PairsCommand, TakesTheInputWithoutAnOptionAndNeedsNoOutput) {
  if (!fs::exists(SPHEREPAIR_PROGRAM)) GTEST_SKIP() << "no " << SPHEREPAIR_PROGRAM << " here";
  const std::string file = folder_.write("a.dat", "0 0 0\n1 0 0\n5 0 0\n");
  EXPECT_EQ(run_program("pairs --backend cpu --radius 1 --columns x,y,z " + file), kOk) << errors_;
  EXPECT_NE(output_.find("1 pair, 2 of 3 spheres collide"), std::string::npos) << output_;
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"a.dat", "spheres.xyz"}));
}

// By any name: a pipe, a descriptor of a pipe and one of a file. The NPY file shows that the contents tell the format.
TEST_F(PairsCommand, ReadsStreamsByTheirContents) {
  if (!fs::exists(SPHEREPAIR_PROGRAM)) GTEST_SKIP() << "no " << SPHEREPAIR_PROGRAM << " here";
  const std::vector<float> rows = {0, 0, 0, 1, 1, 0, 0, 1};
  const std::string npy = folder_.write("a", npy_file(npy_header("<f4", "(2, 4)"), npy_data(rows, 4)));
  const std::string pipe = folder_.path("pipe");
  for (const std::string& command : {std::string("pairs --output -"), std::string("run --pairs -")})
    for (const auto& [input, before] : {std::pair{pipe, fmt::format("mkfifo '{}'; cat '{}' >'{}' &", pipe, npy, pipe)},
                                        {"/dev/fd/0", fmt::format("cat '{}' |", npy)},
                                        {"/dev/fd/3 3<" + npy, ""},
                                        {"/dev/stdin <" + npy, ""}}) {
      EXPECT_EQ(run_program(fmt::format("{} --backend cpu --input {}", command, input), before), kOk) << errors_;
      EXPECT_EQ(output_, "0 1\n") << command << " " << input;
      fs::remove(pipe);
    }
  EXPECT_EQ(run_program("pairs --backend cpu --input " + npy), kUsage) << "a file has an extension";
}

TEST_F(PairsCommand, PrintsAsMuchAsAskedFor) {
  PairsOptions chosen = options("pairs.txt");
  const auto lines = [&] { return std::count(output_.begin(), output_.end(), '\n'); };
  EXPECT_EQ(run(chosen), "");
  EXPECT_GE(lines(), 4);
  EXPECT_LE(lines(), 8) << output_;
  EXPECT_EQ(output_.find("seconds: load"), std::string::npos) << output_;
  const auto normal = lines();
  chosen.verbosity = Verbosity::verbose;
  EXPECT_EQ(run(chosen), "");
  EXPECT_GT(lines(), normal);
  for (const char* words : {"method: ", "seconds: load"})
    EXPECT_NE(output_.find(words), std::string::npos) << words << "\n" << output_;
  chosen.verbosity = Verbosity::quiet;
  EXPECT_EQ(run(chosen), "");
  EXPECT_EQ(output_ + errors_, "");
  EXPECT_EQ(read_bytes(chosen.output_file), text_of(expected_));
  chosen.radius = 0.05;
  chosen.input_file = folder_.write("boxed.xyz", "2\nthe box is 5 wide\nH 0 0 0\nH 0.1 0 0\n");
  EXPECT_EQ(run(chosen), "");
  EXPECT_EQ(output_, "");
  EXPECT_NE(errors_.find("a comment has a word for a box"), std::string::npos) << errors_;
}

}  // namespace
}  // namespace spherepair
