// SPDX-License-Identifier: MIT
// compare and equal as programs, fed wrong answers: a backend that answers wrongly, and records that were tampered
// with.
#include <fmt/format.h>

#include <filesystem>
#include <functional>

#include "tests/faults/faulty_backend.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

using nlohmann::ordered_json;

class CompareProgram : public ProgramTest {
 protected:
  Outcome compare(const std::string& fault, const std::string& more = "--tables none", uint64_t from_step = 0) const {
    return run_shell(
        fmt::format("SPHEREPAIR_FAULT={} SPHEREPAIR_FAULT_FROM={} '{}' compare --backends cpu,opengl --threads 1 "
                    "--scenes random --n 300 --steps 2 --blocks 64 --results '{}' {}",
                    fault, from_step, SPHEREPAIR_FAULTY_PROGRAM, path("results"), more),
        folder_);
  }
  void SetUp() override {
    if (!std::filesystem::exists(SPHEREPAIR_FAULTY_PROGRAM))
      GTEST_SKIP() << "no " << SPHEREPAIR_FAULTY_PROGRAM << " here";
  }
  nlohmann::json results() const { return read_json("results/results.json"); }
};

TEST_F(CompareProgram, SaysHowManyComparisonsOfWhatItMade) {
  const Outcome outcome = compare("none");
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("Equal on cpu, opengl: "), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find(" and 3 states compared, as many as planned"), std::string::npos) << outcome.output;
  EXPECT_EQ(results().at("verdict"), "equal");
  const nlohmann::json counts = results().at("comparisons").at("opengl");
  EXPECT_EQ(counts.at("states"), (nlohmann::json{{"planned", 3}, {"made", 3}}));
  EXPECT_EQ(counts.at("sets").at("made"), counts.at("sets").at("planned"));
  EXPECT_GT(counts.at("sets").at("made"), 9);
}

TEST_F(CompareProgram, FindsAndNamesEveryFault) {
  for (const auto* faults : {&set_faults(), &state_faults()})
    for (const NamedFault& fault : *faults) {
      const Outcome outcome = compare(fault.name, "--tables none", 1);
      EXPECT_EQ(outcome.code, 1) << fault.name << outcome.output;
      EXPECT_NE(outcome.errors.find("DIFFERENCE FOUND"), std::string::npos) << outcome.errors;
      EXPECT_NE(outcome.errors.find(fault.found_as), std::string::npos) << fault.name << ": " << outcome.errors;
      EXPECT_NE(outcome.errors.find("step 1 of"), std::string::npos) << outcome.errors;
      EXPECT_EQ(outcome.output.find("No difference"), std::string::npos) << outcome.output;
      EXPECT_EQ(results().at("verdict"), "difference");
      EXPECT_TRUE(results().at("difference").contains("between"));
    }
}

TEST_F(CompareProgram, FindsAFaultOfTheLowBitsAndOneOfTheGuards) {
  EXPECT_EQ(compare("wide_bit", "--tables none --motion impact --precision float64").code, 1);
  EXPECT_EQ(compare("guard_overwritten").code, 3);
  EXPECT_EQ(results().at("verdict"), "error");
}

TEST_F(CompareProgram, TimesNoWrongAnswer) {
  const Outcome outcome = compare("swapped_pairs", "--tables step --rounds 1", 1);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(results().at("measurements").empty());
}

TEST_F(CompareProgram, RefusesABackendOfWhichNothingWouldBeCompared) {
  const Outcome outcome = compare("no_methods");
  EXPECT_EQ(outcome.code, 2) << outcome.output;
  EXPECT_NE(outcome.errors.find("no result of opengl would be compared"), std::string::npos) << outcome.errors;
  EXPECT_EQ(outcome.output.find("No difference"), std::string::npos) << outcome.output;
}

class EqualProgram : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (IsSkipped()) return;
    const Outcome outcome = run(
        "compare --backends cpu --threads 1 --scenes random --n 300 --steps 2 --blocks 64 --tables none --results '" +
        path("run") + "'");
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    right_ = ordered_json::parse(read_bytes(path("run/results.json")));
  }

  using Change = std::function<void(ordered_json&)>;
  Outcome equal(const Change& change) {
    ordered_json changed = right_;
    change(changed);
    return run(fmt::format("equal '{}' '{}'", path("run/results.json"), folder_.write("other.json", changed.dump())));
  }
  static ordered_json& point(ordered_json& results) { return results["equality"][0]["checkpoints"][1]; }

  ordered_json right_;
};

TEST_F(EqualProgram, AcceptsTheSameRecord) {
  const Outcome outcome = equal([](ordered_json&) {});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("configurations compared, 0 differ"), std::string::npos);
}

TEST_F(EqualProgram, FindsEveryRecordedDifference) {
  const std::pair<const char*, Change> changes[] = {
      {"pairs", [](ordered_json& r) { point(r)["pairs"] = point(r)["pairs"].get<uint64_t>() + 1; }},
      {"colliding spheres", [](ordered_json& r) { point(r)["colliding_spheres"] = 0; }},
      {"fingerprint", [](ordered_json& r) { point(r)["fingerprint"] = std::string(32, '0'); }},
      {"the fingerprint's last digit",
       [](ordered_json& r) {
         std::string digits = point(r)["fingerprint"];
         digits.back() = digits.back() == '0' ? '1' : '0';
         point(r)["fingerprint"] = digits;
       }},
      {"state", [](ordered_json& r) { point(r)["state"] = std::string(16, 'f'); }}};
  for (const auto& [name, change] : changes) {
    const Outcome outcome = equal(change);
    EXPECT_EQ(outcome.code, 1) << name << outcome.errors;
    EXPECT_NE(outcome.output.find("DIFFERENT: "), std::string::npos) << name;
    EXPECT_NE(outcome.output.find("step 1"), std::string::npos) << name;
    EXPECT_NE(outcome.output.find(", 1 differ"), std::string::npos) << name << outcome.output;
  }
}

TEST_F(EqualProgram, RefusesWhatIsNoRecordOfEquality) {
  const std::tuple<const char*, Change, const char*> changes[] = {
      {"a difference", [](ordered_json& r) { r["verdict"] = "difference"; }, "/verdict: expected 'equal'"},
      {"unfinished", [](ordered_json& r) { r["verdict"] = "unfinished"; }, "/verdict: expected 'equal'"},
      {"an entry's verdict", [](ordered_json& r) { r["equality"][0]["verdict"] = "?"; }, "/equality/0/verdict"},
      {"no verdict", [](ordered_json& r) { r.erase("verdict"); }, "the key 'verdict'"},
      {"format", [](ordered_json& r) { r["format"] = "spherepair sweep 1"; }, "/format: expected"},
      {"no format", [](ordered_json& r) { r.erase("format"); }, "the key 'format'"},
      {"no configuration", [](ordered_json& r) { r["equality"] = ordered_json::array(); },
       "/equality: expected a list"},
      {"no step", [](ordered_json& r) { r["equality"][0]["checkpoints"] = ordered_json::array(); }, "at least one"},
      {"no label", [](ordered_json& r) { r["equality"][0]["configurations"] = ordered_json::array(); },
       "configurations"},
      {"no scene", [](ordered_json& r) { r["equality"][0].erase("scene"); }, "the key 'scene'"},
      {"no size", [](ordered_json& r) { r["equality"][0]["scene"].erase("n"); }, "the key 'n'"},
      {"no set", [](ordered_json& r) { r["equality"][0].erase("set"); }, "the key 'set'"},
      {"no state", [](ordered_json& r) { point(r).erase("state"); }, "the key 'state'"},
      {"a fraction", [](ordered_json& r) { point(r)["pairs"] = 1.5; }, "pairs: expected a whole number"},
      {"a negative count", [](ordered_json& r) { point(r)["colliding_spheres"] = -1; }, "expected a whole number"},
      {"a fractional step", [](ordered_json& r) { point(r)["step"] = 0.5; }, "step: expected a whole number"},
      {"a short fingerprint", [](ordered_json& r) { point(r)["fingerprint"] = "0f"; }, "32 hexadecimal digits"},
      {"two results",
       [](ordered_json& r) {
         r["equality"].push_back(r["equality"][0]);
         r["equality"].back()["checkpoints"][1]["pairs"] = 7;
       },
       "the same run recorded before"},
      {"fewer comparisons", [](ordered_json& r) { r["comparisons"]["cpu"]["sets"]["made"] = 1; },
       "as many made as planned"},
      {"a list", [](ordered_json& r) { r = ordered_json::array(); }, "expected the key 'format'"}};
  for (const auto& [name, change, message] : changes) {
    const Outcome outcome = equal(change);
    EXPECT_EQ(outcome.code, 2) << name << outcome.output;
    EXPECT_NE(outcome.errors.find(message), std::string::npos) << name << ": " << outcome.errors;
  }
}

TEST_F(EqualProgram, NamesWhatOnlyOneRunHas) {
  const Outcome outcome = equal([](ordered_json& r) { r["equality"].erase(r["equality"].begin()); });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("only in"), std::string::npos);
  EXPECT_NE(outcome.output.find("3 configurations, such as {\"name\":\"random\""), std::string::npos) << outcome.output;
  EXPECT_EQ(equal([](ordered_json& r) {
              for (ordered_json& entry : r["equality"]) entry["scene"]["seed"] = 1;
            }).code,
            2)
      << "nothing in common";
}

TEST_F(EqualProgram, ReadsTheRecordedRuns) {
  const auto recorded = [](const std::string& machine) {  // once, or in several processes
    const std::string once = fmt::format("{}/{}/results.json", SPHEREPAIR_DATA, machine);
    return std::filesystem::exists(once) ? once : fmt::format("{}/{}/results/1.json", SPHEREPAIR_DATA, machine);
  };
  const Outcome outcome = run(fmt::format("equal '{}' '{}'", recorded("h100"), recorded("llvmpipe")));
  EXPECT_EQ(outcome.code, 0) << outcome.output << outcome.errors;
}

}  // namespace
}  // namespace spherepair
