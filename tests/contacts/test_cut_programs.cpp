// SPDX-License-Identifier: MIT
// `run --save` and `run --resume` with contacts: the last checkpoint has the bytes, and the statistics the rows, of the
// run that was not cut.
#include <fmt/format.h>

#include <map>
#include <sstream>

#include "bench/options/command.h"
#include "tests/support/backends.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

struct CutProgram {
  const char* scene;
  uint64_t steps, cut;
};
constexpr CutProgram programs[] = {
    {"--scene gas --n 200 --contact spring --restitution 0.6 --drag 0.7", 90, 41},
    {"--scene gas --n 150 --contact hertz --radius-ratio 5", 90, 1},
    {"--scene bed --n 30 --contact spring --restitution 0.3 --stiffness 1e6 --drag 40", 700, 650},
    {"--scene bed --n 30 --contact quartic --drag 3 --no-sleeping", 120, 0},
    {"--scene newton --n 5 --contact spring --drag 0.01 --walls", 100, 99}};

std::map<std::string, std::string> rows_of(const std::string& table) {
  std::map<std::string, std::string> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) rows[line.substr(0, line.find(','))] = line;
  return rows;
}

class CutRunsOfThePrograms : public ProgramTest {
 protected:
  // The rows of a run; its last checkpoint goes into the file `name`, its last step's results into NAME.json.
  std::map<std::string, std::string> rows(const std::string& arguments, const std::string& name) const {
    const char* every = arguments.ends_with("--steps 0") ? "" : "--statistics-every 9";
    const Outcome outcome = run(fmt::format("run {} --statistics '{}' {} --save '{}' --json '{}'", arguments,
                                            path("rows"), every, path(name), path(name + ".json")));
    EXPECT_EQ(outcome.code, kOk) << arguments << outcome.errors;
    return rows_of(read_bytes(path("rows")));
  }
  nlohmann::json last_step(const std::string& name) const { return read_json(name + ".json").at("steps").back(); }
};

TEST_F(CutRunsOfThePrograms, EndAsUncutOnes) {
  const std::vector<Backend*> backends = open_backends();
  size_t turn = 0;
  for (const CutProgram& program : programs) {
    const std::string first = backends[turn % backends.size()]->info().name,
                      second = backends[(turn + 1) % backends.size()]->info().name;
    ++turn;
    const auto whole = rows(fmt::format("--backend cpu {} --steps {}", program.scene, program.steps), "whole");
    rows(fmt::format("--backend {} {} --steps {}", first, program.scene, program.cut), "cut");
    const auto end = rows(
        fmt::format("--backend {} --resume '{}' --steps {}", second, path("cut"), program.steps - program.cut), "end");
    for (const auto& [step, row] : whole) EXPECT_EQ(end.contains(step) ? end.at(step) : "", row) << program.scene;
    EXPECT_TRUE(read_bytes(path("end")) == read_bytes(path("whole"))) << program.scene;
    EXPECT_EQ(last_step("end"), last_step("whole")) << program.scene;
  }
}

TEST_F(CutRunsOfThePrograms, AreNotSweptWithTheDragOfTheirCheckpoint) {
  const std::string start = "run --backend cpu --scene gas --n 20 --contact spring --steps 2 --save " + path("cut");
  const std::string again = "run --backend cpu --steps 2 --swept --resume " + path("cut");
  ASSERT_EQ(run(start).code, kOk);
  EXPECT_EQ(run(again).code, kOk);
  ASSERT_EQ(run(start + " --drag 1").code, kOk);
  const Outcome outcome = run(again);
  EXPECT_EQ(outcome.code, kUsage);
  EXPECT_NE(outcome.errors.find("--swept tests paths without drag"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("omit --swept"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace spherepair
