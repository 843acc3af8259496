// SPDX-License-Identifier: MIT
// --too-fast divide: a run with divided steps has the bits of one that was given the smaller time step, at the
// times of the undivided ones; and a run that is refused leaves nothing behind.
#include <fmt/format.h>

#include <sstream>

#include "bench/options/command.h"
#include "tests/support/backends.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

// Small spheres that fall, by 0.2 m/s more in each step of 0.02 s; a step allows 0.05 m/s, and a 64th of it 3.2 m/s.
class TooFastOption : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    folder_.write("s.txt", "0 0 0 0.001\n0.004 0.002 0 0.001\n0 0.004 0.002 0.001\n");
  }
  std::string falling(const std::string& command, const std::string& rest) const {
    return fmt::format("{} --input {} --contact spring --stiffness 1.29e-4 {}", command, path("s.txt"), rest);
  }
  Outcome divided(const std::string& command, const std::string& rest) const {
    return run(falling(command, "--dt 0.02 --too-fast divide " + rest));
  }
};

TEST_F(TooFastOption, HasTheBitsOfTheSmallerStepOnEveryBackend) {
  ASSERT_EQ(run(falling("run", "--backend cpu --dt 0.00125 --steps 48 --json " + path("a.json"))).code, kOk);
  const nlohmann::json plain = read_json("a.json");
  for (const Backend* backend : open_backends()) {
    const std::string name = backend->info().name;
    const Outcome outcome = divided("run", fmt::format("--backend {} --steps 3 --json {}", name, path("b.json")));
    ASSERT_EQ(outcome.code, kOk) << outcome.errors;
    const nlohmann::json record = read_json("b.json");
    EXPECT_EQ(record["steps"][0]["state"], plain["steps"][0]["state"]) << name;
    EXPECT_EQ(record["steps"][0]["step"], 3);
    EXPECT_EQ(record["divided_into"], 16);
    EXPECT_FLOAT_EQ(record["dt"].get<float>(), 0.02f);
    for (const char* line : {"divided into 2 of 0.01 s\n", "divided into 16 of 0.00125 s\n"})
      EXPECT_NE(
          outcome.errors.find(std::string("* sphere 0 is too fast: from the start again, with each step ") + line),
          std::string::npos)
          << name << ": " << outcome.errors;
    EXPECT_NE(outcome.output.find("each step is divided into 16\n"), std::string::npos) << outcome.output;
  }
}

TEST_F(TooFastOption, KeepsTheTimesOfRowsAndCheckpoints) {
  const std::string files = fmt::format("--statistics {} --save {} --save-every 2", path("s.csv"), path("c"));
  ASSERT_EQ(divided("run", "--backend cpu --steps 3 --per-step " + files).code, kOk);
  std::istringstream rows(read_bytes(path("s.csv")));
  std::string row;
  std::getline(rows, row);
  for (const char* wanted : {"0,0,", "1,0.0199999", "2,0.0399999", "3,0.0599999"}) {
    std::getline(rows, row);
    EXPECT_EQ(row.substr(0, std::string(wanted).size()), wanted);
  }
  EXPECT_FALSE(std::getline(rows, row)) << row;
  ASSERT_EQ(run(falling("run", "--backend cpu --dt 0.00125 --steps 48 --save " + path("d"))).code, kOk);
  EXPECT_EQ(read_bytes(path("c")), read_bytes(path("d")));
}

TEST_F(TooFastOption, DrawsTheImagesOfTheSmallerStep) {
  const std::string look = "--backend cpu --no-legend --samples 1 --size 64x48 --color speed --images 2 ";
  ASSERT_EQ(divided("render", look + "--steps 1 --output " + path("a.png")).code, kOk);
  ASSERT_EQ(run(falling("render", look + "--steps 8 --every 8 --dt 0.0025 --output " + path("b.png"))).code, kOk);
  for (const char* k : {"-0", "-1"})
    EXPECT_EQ(read_bytes(path(fmt::format("a{}.png", k))), read_bytes(path(fmt::format("b{}.png", k)))) << k;
  EXPECT_NE(read_bytes(path("a-0.png")), read_bytes(path("a-1.png")));
}

TEST_F(TooFastOption, RefusesBeyond64AndLeavesNothing) {
  const std::string files =
      fmt::format("--statistics {} --statistics-every 4 --save {} --save-every 4", path("s.csv"), path("c"));
  for (const Outcome& outcome :
       {divided("run", "--backend cpu --steps 20 " + files),
        divided("render", "--backend cpu --images 21 --size 64x48 --plain --samples 1 --output " + path("a.png"))}) {
    EXPECT_EQ(outcome.code, kUsage);
    EXPECT_NE(outcome.errors.find("each step is already divided into 64"), std::string::npos) << outcome.errors;
  }
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"s.txt"});
}

TEST_F(TooFastOption, OtherwiseTheRunEnds) {
  const Outcome refused = run(falling("run", "--backend cpu --dt 0.02 --steps 3"));
  EXPECT_EQ(refused.code, kUsage);
  EXPECT_NE(refused.errors.find("sphere 0 moves by more than the smallest radius in a step"), std::string::npos);
  folder_.write("s.txt", "0 0 0 0.001\n0.0005 0 0 0.001\n");  // too deep, which no smaller step mends
  const Outcome deep = divided("run", "--backend cpu --steps 1");
  EXPECT_EQ(deep.code, kUsage);
  EXPECT_NE(deep.errors.find("sphere 0 is deeper in another sphere"), std::string::npos) << deep.errors;
  EXPECT_EQ(deep.errors.find("already divided"), std::string::npos) << deep.errors;
  for (const char* rest : {"--n 8 --steps 1 --too-fast divide", "--n 8 --steps 1 --contact none --too-fast divide",
                           "--resume c --too-fast divide", "--n 8 --steps 1 --contact spring --too-fast devide"}) {
    const Outcome outcome = run(fmt::format("run --backend cpu {}", rest));
    EXPECT_EQ(outcome.code, kUsage) << rest;
    EXPECT_NE(outcome.errors.find("--too-fast"), std::string::npos) << outcome.errors;
  }
}

}  // namespace
}  // namespace spherepair
