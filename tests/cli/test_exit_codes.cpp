// SPDX-License-Identifier: MIT
// Trouble that no input shows: output that cannot be written, threads that cannot be started, a file that shrinks.
#include <fmt/format.h>

#include <filesystem>

#include "bench/cli/commands.h"
#include "common/files/file_bytes.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

class ExitCodes : public ProgramTest {
 protected:
  // Standard output goes where nothing can be written.
  void expect_lost_output(const std::string& arguments, const std::string& to = ">/dev/full") const {
    SCOPED_TRACE(arguments + " " + to);
    const Outcome outcome = run(arguments + " " + to);
    EXPECT_EQ(outcome.code, kUsage);
    const size_t said = outcome.errors.find("cannot write to standard output: ");
    EXPECT_NE(said, std::string::npos) << outcome.errors;
    EXPECT_EQ(outcome.errors.find("cannot write", said + 1), std::string::npos) << "once: " << outcome.errors;
    EXPECT_EQ(outcome.errors.find("cannot write"), said) << outcome.errors;
  }

  void expect_too_many_threads(const std::string& arguments) const {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run(arguments + " --threads 4096", "ulimit -v 2000000;");
    EXPECT_EQ(outcome.code, kDeviceFailure);
    EXPECT_NE(outcome.errors.find("of 4096 threads could be started"), std::string::npos) << outcome.errors;
    EXPECT_NE(outcome.errors.find("--threads"), std::string::npos) << outcome.errors;
  }
};

TEST_F(ExitCodes, OutputToAFullDeviceIsAnErrorOfEveryCommand) {
  folder_.write("two.xyz", "2\n\nH 0 0 0 1\nH 1 0 0 1\n");
  const std::string spheres = " --input " + path("two.xyz"), cpu = " --backends cpu --threads 2";
  expect_lost_output("--help");
  expect_lost_output("--version");
  expect_lost_output("compare --help");
  expect_lost_output("devices" + cpu);
  expect_lost_output("run --backend cpu --n 64");
  expect_lost_output("run --backend cpu --n 64", ">&-");
  expect_lost_output("run --backend cpu --n 64 --steps 300 --per-step");  // more than one buffer full
  expect_lost_output("pairs --backend cpu --output -" + spheres);
  expect_lost_output("pairs --backend cpu --json - --output " + path("pairs.txt") + spheres);
  expect_lost_output("pairs --backend cpu --output " + path("pairs.txt") + spheres);
  expect_lost_output("render --backend cpu --size 8x8 --samples 1 --output " + path("two.png") + spheres);
  expect_lost_output("sweep --n 64 --rounds 1 --results " + path("sweep") + cpu);
  expect_lost_output("ablate --n 64 --rounds 1 --results " + path("ablate") + cpu);
  expect_lost_output("compare --tables none --scenes grazing --n 64 --methods parallel --results " + path("one") + cpu);
  expect_lost_output(fmt::format("equal {0}/results.json {0}/results.json", path("one")));
}

TEST_F(ExitCodes, ErrorsToAFullDeviceKeepTheirCode) {
  EXPECT_EQ(run("run --backend cpu --scene none 2>/dev/full").code, kUsage);
  EXPECT_EQ(run("run --backend cpu --no-such-option 2>/dev/full").code, kUsage);
}

// Threads that spin while they wait make a busy machine's steps up to forty times as long.
TEST_F(ExitCodes, ThreadsSleepWhileTheyWaitUnlessAskedOtherwise) {
  const auto shown = [&](const std::string& before) {
    return run("run --n 64", before + "OMP_DISPLAY_ENV=true").errors;
  };
  const auto last_policy = [](const std::string& text) {
    const size_t at = text.rfind("OMP_WAIT_POLICY = '");
    return at == text.npos ? std::string() : text.substr(at + 19, text.find('\'', at + 19) - at - 19);
  };
  if (last_policy(shown("OMP_WAIT_POLICY=active ")).empty()) GTEST_SKIP() << "this OpenMP does not tell its settings";
  EXPECT_EQ(last_policy(shown("")), "PASSIVE") << shown("");
  EXPECT_EQ(last_policy(shown("OMP_WAIT_POLICY=active ")), "ACTIVE");
}

TEST_F(ExitCodes, ThreadsThatCannotBeStartedAreTroubleAndNoDifference) {
  SKIP_WHERE_ADDRESS_SPACE_HAS_NO_LIMIT();
  folder_.write("two.xyz", "2\n\nH 0 0 0 1\nH 1 0 0 1\n");
  expect_too_many_threads("run --backend cpu --n 64");
  expect_too_many_threads("run --backend cpu --n 100000 --method collide_grid");
  expect_too_many_threads("pairs --backend cpu --output - --input " + path("two.xyz"));
  expect_too_many_threads("precision --quick --backends cpu --results " + path("precision"));
  expect_too_many_threads("compare --backends cpu --quick --results " + path("one"));
}

TEST(FileBytesTest, StayWhatWasReadWhenTheFileShrinks) {
  const ScratchFolder folder;
  const std::string text(1 << 20, 'x'), file = folder.write("shrinks.npy", text);
  const FileBytes bytes(file);
  std::filesystem::resize_file(file, 0);
  EXPECT_TRUE(bytes.bytes() == text);
}

}  // namespace
}  // namespace spherepair
