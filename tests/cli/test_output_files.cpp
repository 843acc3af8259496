// SPDX-License-Identifier: MIT
// No command writes over what it reads, over another of its outputs, or over what is not its own; that is found out
// before the work, of which nothing is printed then.
#include <fmt/format.h>
#include <unistd.h>

#include "bench/cli/commands.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

constexpr const char* spheres = "0 1 0 0.5\n0.9 1 0 0.5\n3 1 0 0.5\n";

class Outputs : public ProgramTest {
 protected:
  std::string input() const { return folder_.write("in.txt", spheres); }

  // Refused before any work, for this reason, and all files stay as they were.
  void expect_refused(const std::string& arguments, const std::string& reason) const {
    const std::vector<std::string> before = contents();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, kUsage) << arguments << '\n' << outcome.errors;
    EXPECT_EQ(outcome.output, "") << arguments;
    EXPECT_NE(outcome.errors.find(reason), std::string::npos) << arguments << '\n' << outcome.errors;
    EXPECT_EQ(contents(), before) << arguments;
  }
  std::vector<std::string> contents() const {
    std::vector<std::string> all;
    for (const std::string& name : folder_.names()) all.push_back(name + ": " + read_bytes(path(name)));
    return all;
  }
};

std::string render_of(const std::string& rest) {
  const char* spheres = rest.find("--input") == rest.npos ? "--n 20 " : "";
  return "render --backend cpu --size 64x48 --samples 1 " + (spheres + rest);
}

TEST_F(Outputs, RunNeverWritesOverItsInput) {
  const std::string in = input();
  fs::create_hard_link(in, path("hard"));
  fs::create_symlink(in, path("symbolic"));
  for (const char* option : {"--pairs", "--save", "--json"})
    for (const char* name : {"in.txt", "./in.txt", "hard", "symbolic"})
      expect_refused(fmt::format("run --backend cpu --input {} {} {}", in, option, path(name)), "is the input");
}

TEST_F(Outputs, OnlyTheNextCheckpointReplacesTheOneThatIsGoneOnWith) {
  const std::string saved = path("run.checkpoint");
  ASSERT_EQ(run(fmt::format("run --backend cpu --n 50 --steps 10 --save {}", saved)).code, kOk);
  for (const char* option : {"--pairs", "--json"})
    expect_refused(fmt::format("run --backend cpu --resume {0} {1} {0}", saved, option), "is the input");
  expect_refused(fmt::format("run --backend cpu --resume {0} --save {0} --pairs {0}", saved), "is the output");
  ASSERT_EQ(run(fmt::format("run --backend cpu --resume {0} --steps 10 --save {0} --save-every 3", saved)).code, kOk);
  ASSERT_EQ(run(fmt::format("run --backend cpu --n 50 --steps 20 --save {}", path("whole"))).code, kOk);
  EXPECT_EQ(read_bytes(saved), read_bytes(path("whole")));
}

TEST_F(Outputs, TwoOutputsHaveTwoNames) {
  const std::string a = path("a"), same = path("./a");
  for (const char* two : {"--pairs {} --json {}", "--save {} --json {}", "--pairs {} --save {}"})
    expect_refused("run --backend cpu --n 10 " + fmt::format(fmt::runtime(two), a, same), "is the output");
  expect_refused(fmt::format("pairs --input {} --radius 1 --output {} --json {}",
                             folder_.write("b.xyz", "1\n\n1 2 3\n"), path("a.txt"), path("a.txt")),
                 "is the output");
  expect_refused(render_of(fmt::format("--output {} --video {}", path("a.png"), path("a.mp4"))), "is the output");
}

// A link to a file that does not exist yet, or a chain of such links, is one more name of that file.
TEST_F(Outputs, ALinkToNoFileYetIsThatFile) {
  fs::create_symlink("later", path("link"));
  fs::create_symlink(path("link"), path("chain"));
  for (const char* two : {"--save {0}/link --json {0}/later", "--json {0}/later --save {0}/chain"})
    expect_refused("run --backend cpu --n 10 " + fmt::format(fmt::runtime(two), path(".")), "is the output");
  EXPECT_FALSE(fs::exists(path("later")));
}

TEST_F(Outputs, RunWritesPairsInTheFormatOfTheirExtension) {
  const std::string scene = fmt::format("run --backend cpu --input {} ", input());
  ASSERT_EQ(run(scene + "--pairs " + path("p.npy") + " --contacts " + path("c.txt")).code, kOk);
  const std::string bytes = read_bytes(path("p.npy"));
  EXPECT_TRUE(bytes.starts_with("\x93NUMPY")) << bytes;
  EXPECT_TRUE(bytes.ends_with(std::string("\0\0\0\0\1\0\0\0", 8)));
  EXPECT_EQ(read_bytes(path("c.txt")), "# contacts\n1\n1\n0\n");
  expect_refused(scene + "--pairs " + path("p.dat"), "the format of --pairs");
  expect_refused(scene + "--contacts " + path("c"), "the format of --contacts");
}

TEST_F(Outputs, InputsWithoutSpheresAreRefused) {
  fs::create_directory(path("folder.txt"));
  expect_refused("run --input " + path("folder.txt"), "Is a directory");
  for (const char* command : {"run --input ", "pairs --output o.txt --input ", "render --output o.png --input "})
    expect_refused(command + folder_.write("empty.txt", ""), "holds no sphere");
  expect_refused("run --input " + folder_.write("a.log", spheres), "needs --columns");
}

// Replacing a file needs no right to write into it, but who took that right away wants it kept.
TEST_F(Outputs, AFileThatMayNotBeWrittenIsKept) {
  if (::geteuid() == 0) GTEST_SKIP() << "the superuser may write into every file";
  folder_.write("pairs.txt", "mine");
  fs::permissions(path("pairs.txt"), fs::perms::owner_read);
  expect_refused("run --n 10 --pairs " + path("pairs.txt"), "Permission denied");
}

TEST_F(Outputs, WhatIsNoFileTakesSeveral) {
  const Outcome outcome = run("run --backend cpu --n 10 --pairs /dev/null --json /dev/null --save /dev/null");
  EXPECT_EQ(outcome.code, kOk) << outcome.errors;
}

TEST_F(Outputs, RenderNeverWritesOverItsInput) {
  for (const char* name : {"a.png", "a.json", "a-1.png", "a-2.json"}) {
    const std::string in = folder_.write(name, spheres);
    const bool series = std::string(name).size() > 6;
    expect_refused(render_of(fmt::format("--input {} --output {} --images {}", in, path("a.png"), series ? 3 : 1)),
                   "is the input");
    fs::remove(in);
  }
}

TEST_F(Outputs, RenderReplacesNoRecordButItsOwn) {
  const std::string one = render_of("--output " + path("a.png")), series = one + " --images 3";
  for (const char* name : {"a.json", "a-2.json"})
    for (const char* text : {"{\"title\": \"a scene\", \"camera\": 1}\n", "no JSON", "[]"}) {
      folder_.write(name, text);
      expect_refused(name == std::string("a.json") ? one : series, fmt::format("{}, ", name));
      fs::remove(path(name));
    }
  ASSERT_EQ(run(one).code, kOk);
  ASSERT_EQ(run(one).code, kOk);
  nlohmann::json old = read_json("a.json");
  EXPECT_EQ(old.at("format"), "spherepair render 1");
  old.erase("format");  // as earlier versions wrote it
  folder_.write("a.json", old.dump());
  EXPECT_EQ(run(one).code, kOk);
  EXPECT_TRUE(read_json("a.json").contains("format"));
  ASSERT_EQ(run(series).code, kOk);
  EXPECT_EQ(run(series).code, kOk);
}

TEST_F(Outputs, PlacesThatCannotBeWrittenAreFoundBeforeTheWork) {
  const std::string nowhere = path("no/such/folder/a");
  for (const char* command : {"devices --backends cpu --json {}", "run --backend cpu --n 10 --json {}",
                              "run --backend cpu --n 10 --pairs {}"})
    expect_refused(fmt::format(fmt::runtime(command), nowhere), "cannot write " + nowhere);
  const std::string long_name = path(std::string(300, 'a'));
  for (const char* option : {"--json", "--save", "--pairs"})
    expect_refused(fmt::format("run --backend cpu --n 10 {} {}", option, long_name), "File name too long");
  expect_refused(render_of("--output " + nowhere + ".png"), "cannot write " + nowhere + ".png");
  fs::create_directories(path("a-1.json"));
  expect_refused(render_of("--images 3 --output " + path("a.png")), "a-1.json: Is a directory");
}

TEST_F(Outputs, ResultsFoldersAreFoundBeforeTheWork) {
  for (const char* name :
       {"results.json", "methods.txt", "precision.json", "precision.txt", "sets.json", "sets.txt", "contacts.json",
        "contacts.txt", "crossover.json", "ablate.txt", "launches.json", "frames.json"})
    fs::create_directories(path(fmt::format("{}-there/{}", name, name)));
  const auto expect = [&](const std::string& command, const std::string& name) {
    expect_refused(fmt::format("{} --backends cpu --results {}-there", command, path(name)), name + ": Is a directory");
  };
  expect("compare --quick --tables none", "results.json");
  expect("compare --quick --tables methods --n 64 --rounds 6", "methods.txt");
  expect("precision --motions paper --precisions float32", "precision.json");
  expect("precision --motions paper --precisions float32", "precision.txt");
  expect("sets --motions paper", "sets.json");
  expect("sets --motions paper", "sets.txt");
  expect("contacts --laws quartic", "contacts.json");
  expect("contacts --laws quartic", "contacts.txt");
  expect("crossover --n 64", "crossover.json");
  expect("ablate --n 64", "ablate.txt");
  expect("launches --n 64", "launches.json");
  expect("frames --n 64", "frames.json");
}

TEST_F(Outputs, FilesBesideTheResultsStay) {
  fs::create_directory(path("results"));
  const std::string victim = folder_.write("victim", "mine");
  fs::create_symlink(victim, path("results/results.json.new"));
  const Outcome outcome =
      run("compare --tables none --backends cpu --quick --n 64 --steps 1 --results " + path("results"));
  EXPECT_EQ(outcome.code, kOk) << outcome.errors;
  EXPECT_TRUE(fs::is_symlink(path("results/results.json.new")));
  EXPECT_EQ(read_bytes(victim), "mine");
}

}  // namespace
}  // namespace spherepair
