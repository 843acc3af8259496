// SPDX-License-Identifier: MIT
// When a run with contacts cannot go on, its statistics up to then are in the file, and the message names the step,
// counted from the first start, and a time step that works. All backends say the same.
#include <fmt/format.h>

#include <regex>

#include "bench/options/command.h"
#include "tests/support/backends.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

// Small spheres that fall, by 0.2 m/s more in each step of 0.02 s; a step allows 0.05 m/s in each.
class FailedRun : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    folder_.write("s.txt", "0 0 0 0.001\n0.004 0.002 0 0.001\n0 0.004 0.002 0.001\n");
  }
  // In step k the speed is g dt (k - 1/2). With dt = 0.002 s it is too high in step 26.
  Outcome falls(const std::string& backend, const std::string& rest) const {
    return run(fmt::format("run --backend {} --input {} --contact spring --stiffness 1.29e-4 {}", backend,
                           path("s.txt"), rest));
  }
  static size_t lines_of(const std::string& text) { return size_t(std::ranges::count(text, '\n')); }
};

TEST_F(FailedRun, LeavesTheRowsBefore) {
  for (const Backend* backend : open_backends()) {
    const std::string name = backend->info().name;
    const Outcome outcome = falls(name, "--dt 0.002 --steps 40 --statistics " + path(name));
    EXPECT_EQ(outcome.code, kUsage);
    EXPECT_NE(outcome.errors.find("cannot go on from step 26 of 0.002 s"), std::string::npos) << outcome.errors;
    const std::string rows = read_bytes(path(name));
    EXPECT_EQ(lines_of(rows), 27u) << rows;  // the heading, steps 0 to 25
    EXPECT_NE(rows.find("\n25,0.05"), std::string::npos) << rows;
  }
}

TEST_F(FailedRun, LeavesThemInPipesToo) {
  for (const char* file : {"-", "/dev/stdout"})
    EXPECT_EQ(lines_of(falls("cpu", fmt::format("--dt 0.002 --steps 40 --statistics {} | cat", file)).output), 27u);
}

TEST_F(FailedRun, WritesRowsAsTheyCome) {
  const std::string long_run = "run --backend cpu --scene gas --n 100 --contact spring --steps 100000000 --statistics ";
  folder_.write("s.csv", "of an earlier run\n");
  EXPECT_EQ(run(long_run + path("s.csv"), "timeout --preserve-status -s KILL 2").code, 128 + 9);
  const std::string rows = read_bytes(path("s.csv"));
  EXPECT_EQ(rows.substr(0, 5), "step,");
  EXPECT_GT(lines_of(rows), 10u);
  EXPECT_EQ(rows.back(), '\n');
}

TEST_F(FailedRun, NamesATimeStepThatWorks) {
  for (const double dt : {0.02, 0.004, 0.0021}) {
    const Outcome failed = falls("cpu", fmt::format("--dt {} --steps 1000", dt));
    std::smatch found;
    ASSERT_TRUE(std::regex_search(failed.errors, found, std::regex("from step (\\d+) .*give --dt ([0-9.e-]+) or less")))
        << failed.errors;
    const double named = std::stod(found[2]), seconds = std::stod(found[1]) * dt;
    EXPECT_LT(named, dt);
    EXPECT_GT(named, dt / 20);
    const auto steps = uint64_t(seconds / named);
    EXPECT_EQ(falls("cpu", fmt::format("--dt {} --steps {}", found[2].str(), steps)).code, kOk) << failed.errors;
  }
}

TEST_F(FailedRun, NamesTheStepOfTheWholeRun) {
  const auto message = [](const Outcome& outcome) {
    return outcome.errors.substr(std::min(outcome.errors.find("cannot go on"), outcome.errors.size()));
  };
  const std::string whole = message(falls("cpu", "--dt 0.002 --steps 40"));
  ASSERT_NE(whole.find("step 26 "), std::string::npos) << whole;
  for (const Backend* backend : open_backends()) {
    const std::string name = backend->info().name;
    ASSERT_EQ(falls(name, "--dt 0.002 --steps 9 --save " + path("c")).code, kOk);
    const std::string again = fmt::format("run --backend {} --resume {} ", name, path("c"));
    ASSERT_EQ(run(again + "--steps 12 --save " + path("c")).code, kOk);
    EXPECT_EQ(message(run(again + "--steps 30")), whole) << name;
  }
}

}  // namespace
}  // namespace spherepair
