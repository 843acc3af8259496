// SPDX-License-Identifier: MIT
// The cells of times and the samples as CSV, of made-up records and of a run of the program.
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/studies/study_report.h"
#include "tests/support/csv.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

const json record = json::parse(R"([
  {"table": "methods", "work": "collide", "n": 512, "scene": {"name": "aligned", "groups": 8, "group_size": 64},
   "exact": true, "block": null, "label": "opengl collide_tiled 64", "backend": "opengl", "batch": 7, "median_ms": 2.5,
   "samples_ms": [2.5, 2.25], "turns": [1, 2], "device_stages_ms": {"collide_tiled": 2}},
  {"n": 64, "scene": {"name": "random", "groups": 0}, "sample":
    {"label": "a, \"b\"", "backend": "cpu", "batch": 1, "samples_ms": [1e-3], "turns": [0]}}])");

TEST(StudyReport, SamplesNameTheirConfigurationAndTimer) {
  EXPECT_EQ(samples_csv(record),
            "work,scene,n,block,exact,contender,backend,timer,kernel,round,turn,batch,seconds\n"
            "collide,aligned 8x64,512,,true,opengl collide_tiled 64,opengl,host,,1,1,7,0.0025\n"
            "collide,aligned 8x64,512,,true,opengl collide_tiled 64,opengl,host,,2,2,7,0.00225\n"
            "collide,aligned 8x64,512,,true,opengl collide_tiled 64,opengl,device,collide_tiled,,,,0.002\n"
            ",random,64,,,\"a, \"\"b\"\"\",cpu,host,,1,0,1,1e-06\n");
  EXPECT_EQ(read_csv(samples_csv(record)).back().at("contender"), "a, \"b\"");
}

TEST(StudyReport, ListsOfARecordHaveTheirNameInAColumn) {
  const std::vector<CsvRow> rows = read_csv(samples_csv({{"times", record}, {"copies", record}}));
  ASSERT_EQ(rows.size(), 8u);
  EXPECT_EQ(rows.front().at("measurement"), "times");
  EXPECT_EQ(rows.back().at("measurement"), "copies");
  expect_all_told_apart(rows);
}

TEST(StudyReport, TimesHaveTheirIntervalFromSixRoundsOn) {
  Samples samples;
  samples.plan.steps = {1};
  samples.seconds = {1e-3, 1.1e-3, 1.2e-3, 1.3e-3, 1.4e-3};
  EXPECT_EQ(time_cell(samples), "1.200");
  samples.seconds.push_back(1.5e-3);
  EXPECT_EQ(time_cell(samples), "1.250 [1.000, 1.500]");
  EXPECT_EQ(time_cell(samples, 1e6), "1250 [1000, 1500]");
  EXPECT_EQ(time_cell(to_json(samples)), time_cell(samples));
  samples.seconds.back() = 9e-3;
  EXPECT_EQ(time_cell(samples), "1.250 [1.000, 9.000] !");
  EXPECT_EQ(time_cell(to_json(samples), 1e6), "1250 [1000, 9000] !");
}

TEST(StudyReport, OfATableWithoutTimesTheCellsAreTheCsv) {
  const Table table{"Title", {{"", "scene", "", true}, {"ours", "n", "spheres"}}, {{"a, b", "64"}}, {}};
  EXPECT_EQ(csv_of(table), "scene,ours n\n\"a, b\",64\n");
}

class SamplesCsv : public ProgramTest {
 protected:
  std::vector<CsvRow> csv(const std::string& table) const { return read_csv(read_bytes(path("r/" + table + ".csv"))); }
};

// The medians of the table and of results.json are those of the samples.
TEST_F(SamplesCsv, HasTheSamplesOfTheTableAndOfTheRecord) {
  const Outcome outcome =
      run("compare --quick --backends cpu --scenes random --n 64,256 --steps 1 --min-seconds 1e-4 "
          "--tables table1,counts,grid,equality --results " +
          path("r"));
  ASSERT_EQ(outcome.code, kOk) << outcome.errors;
  std::map<std::string, std::vector<double>> samples;
  for (const char* table : {"table1", "grid"}) {
    expect_all_told_apart(csv(table));
    for (const CsvRow& row : csv(table))
      samples[fmt::format("{} {} {} {}", table, row.at("contender"), row.at("n"),
                          row.contains("order") ? row.at("order") : "")]
          .push_back(std::stod(row.at("seconds")));
  }
  const nlohmann::json results = read_json("r/results.json");
  const std::string text = read_bytes(path("r/table1.txt"));
  size_t compared = 0;
  for (const nlohmann::json& row : results.at("measurements")) {
    const std::string name =
        fmt::format("{} {} {} {}", row.at("table").get<std::string>(), row.at("label").get<std::string>(),
                    row.at("n").dump(), row.contains("order") ? row.at("order").get<std::string>() : "");
    const std::vector<double>& found = samples.at(name);
    EXPECT_EQ(found.size(), row.at("rounds")) << name;
    EXPECT_NEAR(median(found), row.at("median_ms").get<double>() * 1e-3, 1e-8 * median(found)) << name;
    ++compared;
    if (row.at("table") != "table1") continue;
    const std::string cell = time_cell(found, in_ms, true),
                      part = row.at("work") == "move" ? "motion + plane" : row.at("method");
    bool stands = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      stands = stands || (line.find(row.at("n").dump() + "  " + part) != line.npos && line.find(cell) != line.npos);
    EXPECT_TRUE(stands) << name << ": " << cell << "\n" << text;
  }
  EXPECT_EQ(compared, samples.size());
  EXPECT_EQ(csv("counts").size(), results.at("tables").at("counts")[0].at("rows").size());
  EXPECT_EQ(csv("equality").size(), results.at("tables").at("equality")[1].at("rows").size());
  EXPECT_EQ(read_bytes(path("r/equality.txt")).find("fingerprint  verdict"), std::string::npos);
}

}  // namespace
}  // namespace spherepair
