// SPDX-License-Identifier: MIT
// What the commands print: within 80 columns, with headings, and in grammar.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "bench/cli/commands.h"
#include "bench/io/report.h"
#include "tests/support/backends.h"
#include "tests/support/csv.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

class PrintedTables : public ProgramTest {
 protected:
  // Of the tables and notes: a folder's name may be longer.
  std::string expect_narrow(const std::string& arguments) const {
    const Outcome outcome = run(fmt::format("{} --results {}", arguments, path("r")));
    EXPECT_EQ(outcome.code, kOk) << outcome.errors;
    expect_whole_in_files();
    std::istringstream lines(outcome.output);
    for (std::string line; std::getline(lines, line);) {
      if (line.find("Results: ") != line.npos || line.find(" missing: ") != line.npos) continue;
      EXPECT_LE(line.size(), line.starts_with("Equal on ") ? 100 : kTextWidth) << arguments << "\n" << line;
    }
    return outcome.output;
  }
  // Each text has its tables within the width of a file, and its samples beside it.
  void expect_whole_in_files() const {
    size_t texts = 0;
    for (const auto& entry : std::filesystem::directory_iterator(path("r"))) {
      if (entry.path().extension() != ".txt") continue;
      ++texts;
      std::istringstream lines(read_bytes(entry.path().string()));
      for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), kFileWidth) << entry.path() << line;
      const std::vector<CsvRow> rows =
          read_csv(read_bytes(std::filesystem::path(entry.path()).replace_extension(".csv").string()));
      EXPECT_FALSE(rows.empty()) << entry.path();
      expect_all_told_apart(rows);
    }
    EXPECT_GT(texts, 0u);
  }
  static bool has_opengl() {
    return std::ranges::any_of(open_backends(), [](Backend* backend) { return backend->info().name == "opengl"; });
  }
  // However its lines are broken.
  static std::string words_of(const std::string& text) { return wrapped(text, "", "", text.size() + 1); }
};

// Those of contacts: ContactStudy.
TEST_F(PrintedTables, OfEveryStudyFitInto80Columns) {
  if (!has_opengl()) GTEST_SKIP() << "no OpenGL here";
  expect_narrow(
      "compare --quick --backends cpu,opengl --n 64 --scenes random --blocks 64 --rounds 1 --min-seconds 1e-5");
  expect_narrow("crossover --backends cpu,opengl --n 64 --kinds gas,one_cell --rounds 1");
  expect_narrow("ablate --backends cpu,opengl --n 64 --names radius_load_all_pairs,cells --rounds 1");
  expect_narrow("launches --backends cpu,opengl --n 64 --rounds 1");
  expect_narrow("sets --quick --backends cpu --motions impact-linear");
  expect_narrow("precision --quick --backends cpu,opengl --motions impact-linear --n 100 --rounds 6");
}

TEST_F(PrintedTables, OfTheStepsOfARunFitsInto80Columns) {
  std::istringstream lines(run("run --backend cpu --scene uniform --n 300k --steps 100 --per-step --hashes").output);
  size_t steps = 0;
  bool of_table = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("fingerprint of the pairs") != line.npos) of_table = true;
    if (line.find("simulated ") != line.npos) break;
    if (!of_table) continue;
    EXPECT_LE(line.size(), kTextWidth) << line;
    ++steps;
  }
  EXPECT_GT(steps, 100u);
}

TEST_F(PrintedTables, FramesHasHeadings) {
  if (!has_opengl()) GTEST_SKIP() << "no OpenGL here";
  const std::string text = expect_narrow(
      "frames --backends cpu,opengl --n 64 --draws compute,points --rounds 1 --size 64x48 --min-seconds 1e-5");
  for (const char* words : {"Drawing 64 spheres at 64x48: an image", "draw     camera   work", "frame_all"})
    EXPECT_NE(text.find(words), std::string::npos) << text;
  for (const char* row : {"\ncompute  outside  frame_all ", "\npoints   inside   loop "})
    EXPECT_NE(text.find(row), std::string::npos) << text;
  EXPECT_NE(read_bytes(path("r/frames.txt")).find("median"), std::string::npos);
}

TEST_F(PrintedTables, OneOfAThingIsSingular) {
  const std::string one = folder_.write("one.xyz", "1\n\n1. 2 3 1\n"),
                    two = folder_.write("two.txt", "0 0 0 1\n1 0 0 1\n");
  const std::string text = words_of(run("run --backend cpu --n 1 --steps 1").output +
                                    run("pairs --backend cpu --output /dev/null --input " + one).output +
                                    run("pairs --backend cpu --output /dev/null --input " + two).output +
                                    run(fmt::format("run --input {} --frame 4", one)).errors);
  for (const char* words : {"1 sphere, 1 step of", "1 sphere, radius", "0 pairs, 0 of 1 sphere collide",
                            "1 pair, 2 of 2 spheres", "has 1 frame,"})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  for (const char* words : {" 1 spheres", " 1 steps", " 1 pairs"})
    EXPECT_EQ(text.find(words), std::string::npos) << text;
}

TEST_F(PrintedTables, TheChoiceOfTheMethodSaysWhatItGoesBy) {
  const std::string text = words_of(run("run --backend cpu --threads 1 --scene uniform --n 100 --verbose").output);
  EXPECT_NE(text.find("more in its cell on average; at this density the grid is faster only from "), std::string::npos)
      << text;
}

}  // namespace
}  // namespace spherepair
