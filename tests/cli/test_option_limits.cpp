// SPDX-License-Identifier: MIT
// A number that an option cannot mean is refused with its name, at once: nothing wraps, is ignored or runs for ever.
#include <fmt/format.h>

#include <filesystem>

#include "bench/cli/commands.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

class OptionLimits : public ProgramTest {
 protected:
  void expect_refused(const std::string& arguments) const {
    const Outcome outcome = run(arguments, "timeout 10");
    EXPECT_EQ(outcome.code, kUsage) << arguments << "\n" << outcome.errors;
    EXPECT_NE(outcome.errors, "") << arguments;
    EXPECT_FALSE(std::filesystem::exists(path("out"))) << arguments;
  }
  // Each value behind the arguments, which end in the option and what is between the two.
  void expect_refused(const std::string& arguments, std::initializer_list<const char*> values) const {
    for (const char* value : values) expect_refused(fmt::format("{}'{}'", arguments, value));
  }
  void expect_taken(const std::string& arguments) const {
    const Outcome outcome = run(arguments, "timeout 60");
    EXPECT_EQ(outcome.code, kOk) << arguments << "\n" << outcome.errors;
  }

  const std::string render_ = "render --n 8 --backend cpu --samples 1 --output " + path("out");
  const std::string sweep_ = "sweep --backends cpu --n 64 --rounds 1 --results " + path("sweep");
};

constexpr auto no_numbers = {"nan", "inf", "-inf", "-1", "1e39", "1e400", "", "abc"};

TEST_F(OptionLimits, WholeNumbersNeverWrap) {
  const std::string render = render_ + ".png";
  expect_refused(render + " --size=", {"4294967297x1", "1x4294967297", "0x1", "-1x1", "+1x1", " 1x1", "1x1 ", "1x",
                                       "x1", "1x1x1", "16385x1", "99999999999999999999x1", ""});
  expect_refused("compare --backends cpu --tables none --results " + path("out") + " --scenes=",
                 {"aligned:8x4294967298", "aligned:8x 4", "aligned:8x+4", "aligned:8x-4", "aligned:8x0", "aligned:8x",
                  "aligned:4294967297x8", "aligned:2147483647x2"});
  expect_refused(
      "frames --backends cpu --n 64 --results " + path("out") + " --most=",
      {"mesh:-1", "mesh:99999999999999999999", "mesh: 1", "mesh:+1", "mesh:0", "mesh:1x", "mesh:", "mesh", ""});
  expect_refused("run --backend cpu --n 64 --steps 1 --save " + path("out") + " --save-every=",
                 {"0", "-1", "1.5", "99999999999999999999", "9007199254740993", "010", "0x10", ""});
  expect_refused(sweep_ + " --block=", {"0", "1", "33", "2048", "4294967328", ""});
  expect_refused("precision --quick --backends cpu --results " + path("out") + " --n=",
                 {"0", "-1", "2147483648", "0x10"});
  expect_refused("precision --quick --backends cpu --results " + path("out") + " --steps=",
                 {"-1", "21", "0x10", "010"});
  for (const char* option : {"--n", "--seed", "--steps", "--threads", "--groups", "--group-size"})
    expect_refused(fmt::format("run --backend cpu {}=", option),
                   {"-1", "010", "0x10", "99999999999999999999", "1e-1", "1e30", "1.2345k", "k", "1kk", ""});
}

TEST_F(OptionLimits, RealNumbersAreFiniteAndMakeSense) {
  for (const char* option : {"--radius", "--radius-ratio", "--packing-fraction", "--dt", "--restitution"})
    expect_refused(fmt::format("run --backend cpu --n 64 --scene uniform --steps 1 {}=", option), no_numbers);
  expect_refused("run --backend cpu --n 64 --offset=", {"nan", "inf", "-inf", "1e39", "1e400", ""});
  expect_refused("run --backend cpu --n 64 --scene uniform --packing-fraction=", {"0", "1e-38", "1e-300", "0.75"});
  expect_refused("run --backend cpu --n 64 --steps 1 --motion paper --radius 1e30 --radius-ratio=", {"1e20"});
  expect_refused("ablate --backends cpu --n 64 --rounds 1 --results " + path("out") + " --packing-fraction=",
                 no_numbers);
  expect_refused("frames --backends cpu --n 64 --results " + path("out") + " --packing-fraction=", no_numbers);
  expect_refused(sweep_ + " --packing-fractions=", no_numbers);
  expect_refused("compare --tables none --results " + path("out") + " --min-seconds=", no_numbers);
  expect_refused("frames --backends cpu --n 64 --results " + path("out") + " --min-seconds=", no_numbers);
  expect_refused("crossover --backends cpu --n 64 --results " + path("out") + " --most-ms=", no_numbers);
  const std::string render = render_ + ".png --size 8x8";
  for (const char* option : {"--azimuth", "--elevation", "--field", "--near"})
    expect_refused(fmt::format("{} {}=", render, option), {"nan", "inf", "-inf", "1e39", "1e400", "-1000", "", "abc"});
  expect_refused(render + " --field=", {"0", "180", "1e-50"});
  for (const char* option : {"--eye", "--target", "--up"})
    expect_refused(fmt::format("{} {} ", render, option), {"nan,0,0", "0,inf,0", "0,0,1e16", "0,0", ""});
}

TEST_F(OptionLimits, AnEmptyValueIsNotTakenForNone) {
  for (const char* option : {"--json", "--pairs", "--save", "--input", "--resume", "--scene", "--method", "--backend"})
    expect_refused(fmt::format("run --backend cpu --n 64 {} ", option), {""});
}

TEST_F(OptionLimits, OptionsThatNothingUsesAreRefused) {
  const std::string spheres = folder_.write("two.txt", "0 0 0 1\n1 0 0 1\n");
  expect_refused("run --backend cpu --n 64 --frame ", {"0"});
  for (const char* option : {"--scene random", "--n 64", "--seed 1", "--radius-ratio 2", "--packing-fraction 0.1",
                             "--groups 2", "--group-size 2", "--offset 1"})
    expect_refused(fmt::format("run --backend cpu --input {} {}", spheres, option));
}

TEST_F(OptionLimits, TheEndsOfTheRangesAreTaken) {
  expect_taken("run --backend cpu --n 64 --scene uniform --packing-fraction 1e-15");
  expect_taken("run --backend cpu --n 64 --scene uniform --packing-fraction 0.74");
  expect_taken("run --backend cpu --n 64 --steps 1 --save " + path("a.checkpoint") + " --save-every 9007199254740992");
  expect_taken(render_ + ".png --size 64x48 --field 179 --azimuth -360 --elevation 90");
  expect_taken("render --n 300 --backend cpu --samples 1 --size 16384x9 --output " + path("wide.png"));
}

}  // namespace
}  // namespace spherepair
