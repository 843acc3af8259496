// SPDX-License-Identifier: MIT
// What is said on the command line and of it: options that change nothing, misspelt names, counts, `auto`, times.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "bench/cli/commands.h"
#include "common/scene/known_name.h"
#include "tests/support/backends.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

class CommandLineTest : public ProgramTest {
 protected:
  // Exit code 2, nothing on standard output, and all of these words in the message.
  void expect_refused(const std::string& arguments, std::initializer_list<const char*> words) const {
    const Outcome outcome = run(arguments, "timeout 20");
    EXPECT_EQ(outcome.code, kUsage) << arguments << "\n" << outcome.errors;
    EXPECT_EQ(outcome.output, "") << arguments;
    for (const char* word : words)
      EXPECT_NE(outcome.errors.find(word), std::string::npos) << arguments << ": " << outcome.errors;
  }
  uint64_t spheres_of(const std::string& n) const {
    const Outcome outcome = run(fmt::format("run --backend cpu --n {} --json {}", n, path("run.json")));
    EXPECT_EQ(outcome.code, kOk) << outcome.errors;
    return read_json("run.json").at("scene").at("n");
  }
};

TEST_F(CommandLineTest, OptionsThatChangeNothingAreRefusedWithTheReason) {
  const std::string run = "run --backend cpu --n 64 ", image = "render --backend cpu --n 64 --output " + path("a.png");
  for (const auto& [arguments, option] :
       {std::pair{run + "--packing-fraction 0.1", "--packing-fraction"},
        {run + "--scene lattice --packing-fraction 0.1", "--packing-fraction"},
        {run + "--groups 8", "--groups"},
        {run + "--scene uniform --group-size 8", "--group-size"},
        {run + "--scene gas --contact spring --steps 1 --walls", "--walls"},
        {run + "--scene bed --contact spring --steps 1 --walls", "--walls"},
        {run + "--contact none --steps 1 --drag 1", "--drag"},
        {run + "--motion paper", "--motion"},
        {run + "--dt 0.5", "--dt"},
        {run + "--restitution 0.5", "--restitution"},
        {run + "--per-step", "--per-step"},
        {run + "--save " + path("s") + " --save-every 5", "--save-every"},
        {run + "--block 64", "--block"},
        {run + "--method parallel --block 64", "--block"},
        {"run --n 64 --method collide_tensor --block 64", "--block"},
        {run + "--gl-device 0", "--gl-device"},
        {run + "--cuda-device 0", "--cuda-device"},
        {run + "--no-gpu", "--no-gpu"},
        {run + "--require-hardware", "--require-hardware"},
        {image + " --every 3", "--every"},
        {image + " --rate 10", "--rate"},
        {image + " --motion paper", "--motion"},
        {std::string("devices --backends cpu --compile"), "--compile"},
        {"compare --tables none --rounds 9 --results " + path("r"), "--rounds"},
        {"contacts --measure steps --laws spring --results " + path("r"), "--laws"},
        {"contacts --measure errors --averaged 9 --results " + path("r"), "--averaged"},
        {"contacts --measure errors --rest-layers 9 --results " + path("r"), "--rest-layers"},
        {"contacts --measure steps --drag-steps 0.1:9 --results " + path("r"), "--drag-steps"},
        {"contacts --measure rates --rounds 6 --results " + path("r"), "--rounds"},
        {"frames --draws compute --most mesh:9 --results " + path("r"), "--most"}})
    expect_refused(arguments, {option, "has no effect", "omit"});
  for (const char* file : {"a.png", "s", "r"}) EXPECT_FALSE(std::filesystem::exists(path(file))) << file;
}

TEST_F(CommandLineTest, AMethodThatTheDeviceLacksIsRefusedWithTheReason) {
  expect_refused("run --backend cpu --n 64 --method collide_tensor",
                 {"cpu", "compute capability 9.0", "choose another"});
}

TEST_F(CommandLineTest, SweptPathsHaveNoDrag) {
  expect_refused("run --backend cpu --n 64 --contact spring --drag 1 --swept", {"--swept", "--drag", "omit"});
}

TEST_F(CommandLineTest, TheSameOptionsAreTakenWhereTheyChangeSomething) {
  for (const std::string& arguments :
       {std::string("--scene far --packing-fraction 0.1"), std::string("--scene aligned --groups 8 --group-size 8"),
        std::string("--steps 1 --motion paper --dt 0.5 --restitution 0.5 --per-step"),
        "--dt 0.5 --motion paper --save " + path("s"), std::string("--swept --dt 0.5"),
        std::string("--swept --motion impact-linear --restitution 0.5"),
        std::string("--swept --contact spring --walls"),
        std::string("--steps 1 --contact spring --drag 1 --no-sleeping"),
        std::string("--method collide_group --block 64")}) {
    const Outcome outcome = run("run --backend cpu --n 64 " + arguments);
    EXPECT_EQ(outcome.code, kOk) << arguments << "\n" << outcome.errors;
  }
}

TEST_F(CommandLineTest, CountsTakeSuffixesAndPowersOfTen) {
  EXPECT_EQ(spheres_of("1k"), 1000u);
  EXPECT_EQ(spheres_of("1.5k"), 1500u);
  EXPECT_EQ(spheres_of("1e3"), 1000u);
  EXPECT_EQ(spheres_of("0.01M"), 10000u);
  expect_refused("crossover --backends cpu --n 1e2,1.0001k --results " + path("r"), {"1.0001k", "whole number"});
}

TEST_F(CommandLineTest, AMisspeltNameIsAnsweredWithTheNearest) {
  expect_refused("run --stesp 3", {"unknown option --stesp; did you mean --steps?"});
  expect_refused("compre", {"unknown subcommand 'compre'; did you mean compare?"});
  expect_refused("run --backend opnegl", {"did you mean opengl?"});
  expect_refused("compare --backends cpu,cdua", {"did you mean cuda?"});
  expect_refused("pair --input x", {"unknown subcommand 'pair'", "did you mean pairs?"});
  expect_refused("run --backend cpu --method colide_grid", {"did you mean collide_grid?"});
  expect_refused("run --backend cpu --scene randon", {"did you mean random?"});
  expect_refused("run --backend cpu --steps 1 --motion ancored", {"did you mean anchored?"});
  expect_refused("run --backend cpu --precision flaot64", {"did you mean float64?"});
  expect_refused("compare --backends cpu --tables exactnes --results " + path("r"), {"did you mean exactness?"});
  const std::string render = "render --backend cpu --n 9 --output " + path("a.png");
  expect_refused(render + " --color specis", {"--color: unknown", "'specis'; did you mean species?"});
  expect_refused(render + " --ground lowst", {"--ground lowst: did you mean lowest? Give none, plane"});
  expect_refused(render + " --ground 1e16", {"--ground 1e16: give none, plane, lowest or a height"});
  EXPECT_EQ(nearest_name("grid", {"collide_tiled", "collide_grid"}), "collide_grid");
  EXPECT_EQ(nearest_name("nothing", {"cpu", "opengl", "cuda"}), "");
}

TEST_F(CommandLineTest, AutoSaysWhatItTookAndWhyNotTheOthers) {
  const Outcome outcome = run("run --backend auto --no-gpu --n 64 --json " + path("run.json"));
  ASSERT_EQ(outcome.code, kOk) << outcome.errors;
  EXPECT_TRUE(outcome.output.starts_with("cpu on ")) << outcome.output;
  const Outcome any = run("run --n 64 --verbose --json " + path("any.json"));
  ASSERT_EQ(any.code, kOk) << any.errors;
  const nlohmann::json record = read_json("any.json");
  for (const auto& reason : record.at("passed_over"))
    EXPECT_NE(any.output.find("passed over: " + reason.get<std::string>()), std::string::npos) << any.output;
  const std::vector<std::string> order = {"cuda", "vulkan", "opengl", "cpu"};
  const auto taken = std::ranges::find_if(order, [&](const auto& name) { return any.output.starts_with(name); });
  const size_t before = size_t(taken - order.begin());
  EXPECT_EQ(record.at("passed_over").size(), before);
}

TEST_F(CommandLineTest, RunSaysWhereItsTimeWent) {
  const Outcome outcome =
      run("run --backend cpu --n 500 --steps 20 --method parallel --verbose --json " + path("run.json"));
  ASSERT_EQ(outcome.code, kOk) << outcome.errors;
  for (const char* words :
       {" s in all: ", ", 20 moves ", ", 1 search ", "a move ", "the last step on the host's clock: move "})
    EXPECT_NE(outcome.output.find(words), std::string::npos) << words << "\n" << outcome.output;
  const nlohmann::json times = read_json("run.json").at("times");
  EXPECT_EQ(times.at("moves"), 20);
  EXPECT_GT(times.at("last_step_ms").at("parallel").get<double>(), 0);
  EXPECT_GE(times.at("total_s").get<double>(),
            times.at("moves_s").get<double>() + times.at("searches_s").get<double>());
}

TEST_F(CommandLineTest, RunSaysWhereThePlaneIsIfSpheresMove) {
  const std::string high = folder_.write("high.txt", "0 2 0 1\n"), low = folder_.write("low.txt", "0 -6 0 1.25\n");
  for (const auto& [arguments, words, plane] :
       {std::tuple{"--steps 1 --input " + high, std::string("plane at y = -5\n"), -5.0},
        {"--steps 1 --input " + low, "plane at y = -9\n", -9.0},
        {"--steps 1 --n 9", "plane at y = -5\n", -5.0},
        {"--steps 0 --input " + low, "", -9.0}}) {
    const Outcome outcome = run(fmt::format("run --backend cpu {} --json {}", arguments, path("run.json")));
    ASSERT_EQ(outcome.code, kOk) << outcome.errors;
    const size_t at = outcome.output.find("plane at");
    EXPECT_EQ(at == std::string::npos ? "" : outcome.output.substr(at, words.size()), words) << outcome.output;
    EXPECT_EQ(read_json("run.json").at("plane"), plane) << arguments;
  }
}

TEST_F(CommandLineTest, ProgressIsForATerminalAlone) {
  const std::string words =
      fmt::format("run --backend cpu --threads 1 --motion paper --n {} --steps 10k", by_form(20'000, 2000));
  EXPECT_EQ(run(words).errors, "") << "a pipe stays quiet";
  if (run_shell("script -qec true /dev/null", folder_).code != 0) GTEST_SKIP() << "no pseudo-terminals, or no `script`";
  const Outcome outcome =
      run_shell(fmt::format("script -qec '{} {}' /dev/null </dev/null", SPHEREPAIR_PROGRAM, words), folder_);
  EXPECT_NE(outcome.output.find(" of 10000"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("s left: moving"), std::string::npos) << outcome.output;
}

TEST_F(CommandLineTest, JsonGoesToStandardOutputAndTheReportToStandardError) {
  const std::string spheres = folder_.write("two.xyz", "2\n\nH 0 0 0 1\nH 1 0 0 1\n");
  for (const std::string& command :
       {std::string("devices --backends cpu"), std::string("run --backend cpu --n 64"),
        fmt::format("pairs --backend cpu --input {} --output {}", spheres, path("pairs.txt"))}) {
    const Outcome outcome = run(command + " --json -");
    ASSERT_EQ(outcome.code, kOk) << outcome.errors;
    const nlohmann::json record = nlohmann::json::parse(outcome.output, nullptr, false);
    ASSERT_FALSE(record.is_discarded()) << outcome.output;
    EXPECT_TRUE(record.at("backends").at(0).at("details").at("threads").is_number());
    EXPECT_NE(outcome.errors.find("cpu"), std::string::npos);
  }
  expect_refused(fmt::format("pairs --input {} --output - --json -", spheres),
                 {"--json - is the output - of --output"});
}

// Before anything is installed or built.
TEST_F(CommandLineTest, TheScriptsHelp) {
  if (!std::filesystem::exists(SPHEREPAIR_DATA "/../../reproduce")) GTEST_SKIP() << "no scripts here";
  for (const char* words : {"./check --help", "./check -R Methods -h", "./reproduce --help",
                            "./reproduce --full --help", ".ci/sanitize --help", ".ci/tidy --help"}) {
    const Outcome outcome = run_shell(fmt::format("cd '{}/../..' && {}", SPHEREPAIR_DATA, words), folder_);
    EXPECT_EQ(outcome.code, kOk) << words;
    EXPECT_TRUE(outcome.output.starts_with("Usage: ")) << words << "\n" << outcome.output;
    EXPECT_EQ(outcome.output.find("== Packages"), std::string::npos) << words;
  }
}

}  // namespace
}  // namespace spherepair
