// SPDX-License-Identifier: MIT
// --help, completion in bash and the manual page.
#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "bench/cli/commands.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

using Help = ProgramTest;

// Of the program and of each subcommand, where nothing is longer than a name without a space.
TEST_F(Help, FitsInto100Columns) {
  const std::string all = run("--help").output;
  for (const char* command : {"", "devices", "run", "pairs", "render", "view", "frames", "compare", "equal",
                              "precision", "contacts", "sets", "sweep", "crossover", "ablate", "launches", "energy"}) {
    const Outcome outcome = run(fmt::format("{} --help", command));
    EXPECT_EQ(outcome.code, kOk);
    std::istringstream lines(outcome.output);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << command << ": " << line;
    EXPECT_NE(all.find(command), std::string::npos);
  }
  const std::string help = run("run --help").output;
  EXPECT_NE(help.find("smallest sphere"), std::string::npos);
  EXPECT_LE(std::ranges::count(help, '\n'), 100) << "two screens";
  for (const char* command : {"run", "ablate"}) {
    const Outcome narrow = run(fmt::format("{} --help", command), "COLUMNS=60");
    std::istringstream lines(narrow.output);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 60u) << line;
  }
  const std::string list = run("ablate --help", "COLUMNS=60").output;
  EXPECT_NE(list.find("\n        order\n          spheres already in cell order"), std::string::npos) << list;
}

std::set<std::string> options_in(const std::string& help) {
  std::set<std::string> names;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  --")) names.insert(line.substr(2, line.find(' ', 2) - 2));
  return names;
}

// Each option that help has: bash completes it, and the manual page has it.
TEST_F(Help, CompletionAndManualHaveEveryOption) {
  const std::string script = folder_.write("script", run("completion").output), manual = run("man").output;
  for (const SceneKind& kind : scene_kinds())
    EXPECT_NE(manual.find(fmt::format("\n{} ", kind.name)), std::string::npos) << kind.name;
  for (const char* command : {"devices", "run", "pairs", "render", "compare", "sweep", "energy"}) {
    const std::string bash = fmt::format(
        "source '{}'; COMP_WORDS=(spherepair {} --); COMP_CWORD=2; _spherepair; printf '  %s \\n' "
        "\"${{COMPREPLY[@]}}\"",
        script, command);
    const Outcome completed =
        run_shell("bash -c " + fmt::format("'{}'", std::regex_replace(bash, std::regex("'"), "'\\''")), folder_);
    const std::set<std::string> wanted = options_in(run(fmt::format("{} --help", command)).output);
    EXPECT_GT(wanted.size(), 5u);
    const std::set<std::string> found = options_in(completed.output);
    const size_t page = manual.find(fmt::format(".SH {}\n", command));
    ASSERT_NE(page, std::string::npos) << command;
    std::string section = manual.substr(page + 5, manual.find("\n.SH", page + 5) - page);
    section = std::regex_replace(section, std::regex(R"(\\-)"), "-");
    for (const std::string& option : wanted) {
      EXPECT_TRUE(found.contains(option)) << command << " " << option << "\n" << completed.output;
      EXPECT_TRUE(std::regex_search(section, std::regex(option + "[ \n]"))) << command << " " << option;
    }
  }
}

}  // namespace
}  // namespace spherepair
