// SPDX-License-Identifier: MIT
// run --statistics: rows of the first, the last and every so many steps, equal from every backend, and no bit of the
// motion changed.
#include <fmt/format.h>

#include <sstream>

#include "bench/options/command.h"
#include "tests/support/backends.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

class StatisticsOption : public ProgramTest {
 protected:
  std::string statistics(const std::string& backend, const std::string& rest) const {
    const Outcome outcome =
        run(fmt::format("run --backend {} --scene gas --n 300 --contact spring --restitution 0.9 {} "
                        "--statistics {}",
                        backend, rest, path("s.csv")));
    EXPECT_EQ(outcome.code, kOk) << outcome.errors;
    return read_bytes(path("s.csv"));
  }
};

std::vector<std::string> first_column(const std::string& text) {
  std::vector<std::string> cells;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) cells.push_back(line.substr(0, line.find(',')));
  return cells;
}

TEST_F(StatisticsOption, HasTheFirstTheLastAndEverySoManySteps) {
  const std::string text = statistics("cpu", "--steps 23 --statistics-every 10");
  EXPECT_EQ(first_column(text), (std::vector<std::string>{"step", "0", "10", "20", "23"}));
  const std::string all = statistics("cpu", "--steps 3");
  EXPECT_EQ(first_column(all), (std::vector<std::string>{"step", "0", "1", "2", "3"}));
}

TEST_F(StatisticsOption, AreEqualFromEveryBackend) {
  const std::string wanted = statistics("cpu", "--steps 60 --statistics-every 20");
  for (const Backend* backend : open_backends())
    EXPECT_EQ(statistics(backend->info().name, "--steps 60 --statistics-every 20"), wanted) << backend->info().name;
}

TEST_F(StatisticsOption, ChangeNoBitAndGoOnFromACheckpoint) {
  const std::string scene = "run --backend cpu --scene gas --n 300 --contact hertz --steps 40 --json " + path("a.json");
  ASSERT_EQ(run(scene).code, kOk);
  const nlohmann::json plain = read_json("a.json");
  ASSERT_EQ(
      run(scene + " --save-every 7 --save " + path("c") + " --statistics-every 9 --statistics " + path("a.csv")).code,
      kOk);
  EXPECT_EQ(read_json("a.json")["steps"], plain["steps"]);
  ASSERT_EQ(run(fmt::format("run --backend cpu --resume {} --statistics {}", path("c"), path("b.csv"))).code, kOk);
  const std::string whole = read_bytes(path("a.csv")), rest = read_bytes(path("b.csv"));
  EXPECT_EQ(rest.substr(rest.find('\n')), whole.substr(whole.rfind('\n', whole.size() - 2)));  // the row of step 40
}

TEST_F(StatisticsOption, OnStandardOutputWithTheReportElsewhere) {
  const Outcome outcome = run("run --backend cpu --scene newton --n 5 --contact spring --steps 2 --statistics -");
  EXPECT_EQ(outcome.code, kOk);
  EXPECT_EQ(first_column(outcome.output), (std::vector<std::string>{"step", "0", "1", "2"}));
  EXPECT_NE(outcome.errors.find("kinetic energy "), std::string::npos) << outcome.errors;
}

TEST_F(StatisticsOption, RefusedWhereNothingPushes) {
  const Outcome outcome = run("run --backend cpu --n 20 --steps 2 --statistics " + path("s.csv"));
  EXPECT_EQ(outcome.code, kUsage);
  EXPECT_NE(outcome.errors.find("--contact"), std::string::npos) << outcome.errors;
  EXPECT_TRUE(folder_.names().empty());
  EXPECT_EQ(run("run --backend cpu --scene gas --n 20 --contact spring --steps 2 --statistics-every 2").code, kUsage);
}

// Whose sums would lack contacts, or have some of the next step.
TEST_F(StatisticsOption, RefusedWhereTheSearchIsNotThatOfThePairs) {
  for (const char* option : {"--naive", "--swept", "--method collide_group"}) {
    const Outcome outcome =
        run(fmt::format("run --backend cpu --scene gas --n 20 --contact spring --steps 2 {} "
                        "--statistics {}",
                        option, path("s.csv")));
    EXPECT_EQ(outcome.code, kUsage) << option;
    EXPECT_NE(outcome.errors.find("every pair"), std::string::npos) << outcome.errors;
    EXPECT_TRUE(folder_.names().empty()) << option;
  }
}

}  // namespace
}  // namespace spherepair
