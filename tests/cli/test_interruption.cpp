// SPDX-License-Identifier: MIT
// A signal that ends the program: it says in a line what was interrupted and what is kept, and no empty folder stays.
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

class Interruption : public ProgramTest {
 protected:
  // Sends the signal once this file is there, and waits for the end.
  Outcome interrupt_after(const std::string& arguments, const std::string& file, const std::string& signal) const {
    return run_shell(fmt::format("'{}' {} & p=$!; for k in $(seq 600); do [ -e '{}' ] && break; sleep 0.1; done; "
                                 "kill -{} $p; wait $p 2>/dev/null",
                                 SPHEREPAIR_PROGRAM, arguments, file, signal),
                     folder_);
  }
  const std::string long_check_ =
      "compare --backends cpu --scenes random --n 3000 --steps 1M --tables none --results " + path("results/here");
};

TEST_F(Interruption, AStudyWithoutAResultLeavesNoFolder) {
  const Outcome outcome = interrupt_after(long_check_, path("results/here"), "TERM");
  EXPECT_EQ(outcome.code, 143);
  EXPECT_EQ(outcome.errors, "spherepair: compare interrupted: nothing was written\n");
  EXPECT_FALSE(fs::exists(path("results")));
}

TEST_F(Interruption, TheInterruptKeyEndsTheProgramAsUsual) {
  const Outcome outcome = run(long_check_, "timeout --preserve-status -s INT 2");
  EXPECT_EQ(outcome.code, 130);
  EXPECT_EQ(outcome.errors, "spherepair: compare interrupted: nothing was written\n");
  EXPECT_FALSE(fs::exists(path("results")));
}

// Without the warning of a busy machine, as one that runs tests is.
std::string without_load(const std::string& errors) {
  return errors.starts_with("WARNING: other programs") ? errors.substr(errors.find('\n') + 1) : errors;
}

// As timeout sends it: to the program, and at once again to its group, where another thread may take it.
TEST_F(Interruption, ASecondSignalLosesNothing) {
  for (int k = 0; k < 16; ++k) {
    const char* both = k % 2 ? "TERM $p; kill -TERM" : "HUP $p; kill -TERM";
    const Outcome outcome = interrupt_after(long_check_, path("results/here"), both);
    EXPECT_TRUE(outcome.code == 129 || outcome.code == 143) << outcome.code;
    EXPECT_EQ(outcome.errors, "spherepair: compare interrupted: nothing was written\n");
    ASSERT_FALSE(fs::exists(path("results")));
  }
}

TEST_F(Interruption, FoldersThatWereThereStay) {
  fs::create_directories(path("results/here"));
  EXPECT_EQ(run(long_check_, "timeout --preserve-status -s INT 2").code, 130);
  EXPECT_TRUE(fs::exists(path("results/here")));
}

TEST_F(Interruption, WhatIsFinishedStaysAndIsNamed) {
  const std::string ablate = "ablate --backends cpu --n 64,64k --results " + path("r");
  const Outcome study = interrupt_after(ablate, path("r/ablate.json"), "TERM");
  EXPECT_EQ(study.code, 143);
  EXPECT_EQ(without_load(study.errors),
            fmt::format("spherepair: ablate interrupted: what was finished is in {}\n", path("r")));
  EXPECT_FALSE(read_json("r/ablate.json").at("complete").get<bool>());
  const std::string moving = "run --backend cpu --n 500 --steps 1G --trajectory " + path("t.xyz") +
                             " --trajectory-every 1G --save-every 500 --save " + path("s");
  // What goes on from the file is known shortly after it is there.
  const Outcome moved = interrupt_after(moving, path("s"), "CONT $p; sleep 0.3; kill -TERM");
  const size_t command = moved.errors.find("spherepair run --resume");
  EXPECT_TRUE(moved.errors.starts_with(fmt::format("spherepair: run interrupted: {} is of step ", path("s"))));
  ASSERT_NE(command, std::string::npos) << moved.errors;
  const std::string last = " --until-step 1000000000 --save " + path("s") + " --save-every 500 --trajectory ";
  const size_t at = moved.errors.find(last);
  ASSERT_NE(at, std::string::npos) << moved.errors;
  const std::string frames = read_bytes(path("t.xyz")), rest = moved.errors.substr(at + last.size());
  EXPECT_TRUE(rest.ends_with(".xyz --trajectory-every 1000000000\n")) << rest;
  const std::string words = moved.errors.substr(command + 11, at - command - 11);
  const std::string file = rest.substr(0, rest.find(' '));
  EXPECT_EQ(run(fmt::format("{} --steps 1 --trajectory {}", words, file)).code, kOk) << words;
  EXPECT_EQ(read_bytes(path("t.xyz")), frames);
  EXPECT_NE(read_bytes(file).find(" step="), std::string::npos);
}

TEST_F(Interruption, AStudyThatFailsBeforeItsFirstResultLeavesNoFolder) {
  const Outcome ablate = run("ablate --backends cpu --names own_clear --results " + path("r"));
  EXPECT_EQ(ablate.code, kUsage) << ablate.errors;
  EXPECT_FALSE(fs::exists(path("r")));
}

}  // namespace
}  // namespace spherepair
