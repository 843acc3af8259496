// SPDX-License-Identifier: MIT
// Records in JSON survive what the machine puts into them: bytes that are not UTF-8 become U+FFFD.
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

class Records : public ProgramTest {
 protected:
  // Runs with an odd byte in the environment and in a word of the command line; both are in the record.
  nlohmann::json record_of(const std::string& command, const std::string& file) const {
    const Outcome outcome =
        run(fmt::format("{}'{}'", command, path(file)), "MESA_ODD=\"$(printf 'a\\377z')\"; export MESA_ODD;");
    EXPECT_EQ(outcome.code, kOk) << command << '\n' << outcome.errors;
    const nlohmann::json record = nlohmann::json::parse(read_bytes(path(file)), nullptr, false);
    EXPECT_FALSE(record.is_discarded()) << command;
    return record;
  }
};

TEST_F(Records, BytesThatAreNotUtf8LoseNone) {
  for (const char* command : {"devices --backends cpu --json ", "run --backend cpu --n 10 --json "}) {
    const nlohmann::json record = record_of(command, "odd\xfe.json");
    EXPECT_EQ(record.at("context").at("environment").at("MESA_ODD"), "a\uFFFDz") << command;
    EXPECT_NE(record.at("context").at("command_line").dump().find("odd\uFFFD.json"), std::string::npos) << command;
  }
}

TEST_F(Records, AFirstUseHasTimesAndMemory) {
  const nlohmann::json record = record_of("devices --backends cpu --first-use --json ", "first.json");
  const nlohmann::json& use = record.at("backends").at(0).at("first_use");
  EXPECT_EQ(use.at("n"), 1'000'000);
  for (const char* time : {"open_ms", "first_search_ms", "later_search_ms"}) EXPECT_GT(use.at(time), 0) << time;
  EXPECT_GT(use.at("host_bytes"), 16'000'000);  // of a million positions and radii alone
  EXPECT_LE(use.at("opened_host_bytes"), use.at("host_bytes"));
  EXPECT_TRUE(use.at("gpu_bytes").is_null()) << "the CPU is no GPU";
}

TEST_F(Records, CompareLosesNoRunToThem) {
  const std::string results = path("results");
  const Outcome outcome =
      run(fmt::format("compare --backends cpu --quick --n 64 --steps 1 --tables equality --results '{}\xfe'", results),
          "MESA_ODD=\"$(printf 'a\\377z')\"; export MESA_ODD;");
  EXPECT_EQ(outcome.code, kOk) << outcome.errors;
  const nlohmann::json record = nlohmann::json::parse(read_bytes(results + "\xfe/results.json"), nullptr, false);
  ASSERT_FALSE(record.is_discarded()) << outcome.errors;
  EXPECT_EQ(record.at("verdict"), "equal");
  EXPECT_EQ(record.at("context").at("environment").at("MESA_ODD"), "a\uFFFDz");
}

}  // namespace
}  // namespace spherepair
