// SPDX-License-Identifier: MIT
// Memory that ends anywhere in a command, also while threads share its work, ends it with an error.
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

class OutOfMemory : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    SKIP_WHERE_ADDRESS_SPACE_HAS_NO_LIMIT();
    while (run_within(least_, "--version").code != kOk && least_ < 1000000) least_ += 2000;
  }

  // KiB of address space. Small stacks and a single arena leave it to the command's own memory.
  Outcome run_within(int limit, const std::string& arguments) const {
    return run(arguments, fmt::format("ulimit -s 512; export MALLOC_ARENA_MAX=1; ulimit -v {}; timeout 60", limit));
  }

  // From too little memory to enough, which is `most` KiB above what the program needs to start.
  void expect_an_error_or_success(const std::string& arguments, int most, int step) const {
    int failed = 0;
    for (int more = 0; more < most; more += step) {
      const Outcome outcome = run_within(least_ + more, arguments);
      if (outcome.code == kOk) continue;
      ++failed;
      EXPECT_EQ(outcome.code, kDeviceFailure) << more << " KiB more: " << outcome.errors;
      const auto said = [&](const char* text) { return outcome.errors.find(text) != std::string::npos; };
      EXPECT_TRUE(said("out of memory") || said("more than is free") || said("threads could be started"))
          << more << " KiB more: " << outcome.errors;
    }
    EXPECT_GT(failed, 0);
    EXPECT_EQ(run_within(least_ + most, arguments).code, kOk);
  }

 private:
  int least_ = 10000;
};

TEST_F(OutOfMemory, OfAllPairsOnManyThreadsIsAnError) {
  expect_an_error_or_success("run --backend cpu --n 60000 --method parallel --threads 32", 60000, 2500);
}

TEST_F(OutOfMemory, OfThePairsWithinAStepIsAnError) {
  expect_an_error_or_success("run --backend cpu --n 2000 --swept --scene one_cell --threads 2", 150000, 12000);
}

TEST_F(OutOfMemory, OfTheGridAndItsListIsAnError) {
  const std::string pairs = " --pairs " + path("pairs.txt");
  expect_an_error_or_success("run --backend cpu --n 60000 --method collide_grid --scene clustered --threads 8" + pairs,
                             200000, 9000);
}

TEST_F(OutOfMemory, OfReadingSpheresIsAnError) {
  std::string text = "60000\n\n";
  for (int k = 0; k < 60000; ++k) text += fmt::format("{} 2 3 0.25\n", k);
  const std::string files = fmt::format("--input {} --output {}", folder_.write("row.xyz", text), path("row.npy"));
  expect_an_error_or_success("pairs --backend cpu --threads 8 " + files, 100000, 4500);
}

}  // namespace
}  // namespace spherepair
