// SPDX-License-Identifier: MIT
// The studies with wrong results: what is recorded was compared first, in drawing, precision, sets and ablation too.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bench/check/step_result.h"
#include "bench/studies/set_errors.h"
#include "bench/studies/work_precision.h"
#include "tests/faults/faulty_backend.h"
#include "tests/support/images.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

class StudyOfFaults : public testing::Test {
 protected:
  // The message of the difference that a study finds between the CPU and a faulty backend.
  template <typename Work>
  std::string difference_of(Fault fault, Work work) {
    Session session({"cpu", "opengl"}, {.threads = 1}, faulty_opener(fault, 1));
    try {
      work(session);
      session.comparisons.require_complete();
    } catch (const DifferenceFound& difference) {
      return difference.what();
    }
    EXPECT_GT(session.comparisons.made(Comparisons::states), 0u);
    return {};
  }
  Progress progress_;
};

TEST_F(StudyOfFaults, PrecisionComparesStatesBeforeItRecordsErrorsAndTimes) {
  PrecisionPlan plan;
  plan.motions = {{MotionMethod::impact, Precision::float64}};
  plan.error_steps = plan.time_steps = {4};
  plan.seconds = 0.5, plan.error_n = plan.time_n = 50;
  plan.sampling.rounds = 1;
  plan.sampling.software_seconds = 1e-4;
  const auto errors = [&](Session& session) { measure_errors(session, plan, progress_); };
  const auto times = [&](Session& session) { measure_times(session, plan, progress_); };
  EXPECT_EQ(difference_of(Fault::none, errors), "");
  EXPECT_EQ(difference_of(Fault::none, times), "");
  for (const NamedFault& fault : state_faults()) {
    EXPECT_NE(difference_of(fault.fault, errors).find(fault.found_as), std::string::npos) << fault.name;
    EXPECT_NE(difference_of(fault.fault, times).find(fault.found_as), std::string::npos) << fault.name;
  }
  EXPECT_NE(difference_of(Fault::wide_bit, times).find("first in word"), std::string::npos);
}

TEST_F(StudyOfFaults, SetsComparesSetsAndStatesBeforeItRecordsErrors) {
  SetPlan plan;
  plan.motions = {{MotionMethod::paper, Precision::float32}};
  plan.steps = {4}, plan.seconds = 0.5, plan.n = 300;
  const auto sets = [&](Session& session) { measure_motion_sets(session, plan, progress_); };
  EXPECT_EQ(difference_of(Fault::none, sets), "");
  for (const auto* faults : {&set_faults(), &state_faults()})
    for (const NamedFault& fault : *faults)
      EXPECT_NE(difference_of(fault.fault, sets).find(fault.found_as), std::string::npos) << fault.name;
}

class StudyProgram : public ProgramTest {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(SPHEREPAIR_FAULTY_PROGRAM))
      GTEST_SKIP() << "no " << SPHEREPAIR_FAULTY_PROGRAM << " here";
  }
  Outcome study(const char* fault, const std::string& words) const {
    return run_shell(
        fmt::format("SPHEREPAIR_FAULT={} '{}' {} --backends cpu,opengl --threads 1 --rounds 1 --results '{}'", fault,
                    SPHEREPAIR_FAULTY_PROGRAM, words, path("study")),
        folder_);
  }
  void expect_no_wrong_result_timed(const std::string& words) const {
    const Outcome right = study("none", words);
    EXPECT_EQ(right.code, 0) << right.errors;
    for (const NamedFault& fault : {set_faults().front(), state_faults().front()}) {
      const Outcome wrong = study(fault.name, words);
      EXPECT_EQ(wrong.code, 1) << fault.name << wrong.output;
      EXPECT_NE(wrong.errors.find(fault.found_as), std::string::npos) << wrong.errors;
    }
  }
};

TEST_F(StudyProgram, FramesTimesNoWrongImage) {
  const std::string words =
      "frames --n 500 --draws compute --places outside --works frame,lit --size 64x48 --min-seconds 0.001";
  const Outcome right = study("none", words), wrong = study("image_pixel", words);
  EXPECT_EQ(right.code, 0) << right.errors;
  EXPECT_EQ(wrong.code, 1) << wrong.output;
  EXPECT_NE(wrong.errors.find("differs from that of"), std::string::npos) << wrong.errors;
}

TEST_F(StudyProgram, FrameRatesTimesNoWrongImage) {
  if (const std::string why = why_no_pipeline(*open_backend("cpu")); !why.empty()) GTEST_SKIP() << why;
  const auto compare = [&](const char* fault) {
    return run_shell(
        fmt::format("SPHEREPAIR_FAULT={} '{}' compare --backends cpu,opengl --threads 1 --scenes random --n 64 "
                    "--steps 1 --blocks 128 --tables frame_rates --rounds 1 --min-seconds 0.001 --results '{}'",
                    fault, SPHEREPAIR_FAULTY_PROGRAM, path(fault)),
        folder_);
  };
  const Outcome right = compare("none"), wrong = compare("image_pixel");
  EXPECT_EQ(right.code, 0) << right.errors;
  EXPECT_NE(right.output.find("quadric"), std::string::npos) << right.output;
  EXPECT_EQ(right.output.find("Left out"), std::string::npos) << right.output;
  EXPECT_EQ(wrong.code, 1) << wrong.output;
  EXPECT_NE(wrong.errors.find("give different images"), std::string::npos) << wrong.errors;
}

TEST_F(StudyProgram, AblateTimesNoWrongResult) {
  expect_no_wrong_result_timed("ablate --n 300 --names radius_load,plane_test");
}

TEST_F(StudyProgram, WarnsOfABusyMachineInOutputTablesAndRecord) {
  const auto run = [&](const std::string& others, const std::string& words) {
    return run_shell(fmt::format("SPHEREPAIR_OTHERS={} '{}' {} --backends cpu,opengl --threads 1 --results '{}'",
                                 others, SPHEREPAIR_FAULTY_PROGRAM, words, path("study")),
                     folder_);
  };
  struct Case {
    const char *words, *record, *tables;
  };
  for (const auto& [words, record, tables] : std::initializer_list<Case>{
           {"compare --scenes random --n 64 --steps 1 --blocks 128 --tables step --rounds 1", "results.json",
            "step.txt"},
           {"ablate --n 300 --names radius_load --rounds 1", "ablate.json", "ablate.txt"},
           {"crossover --n 64 --kinds gas --rounds 1", "crossover.json", "crossover.txt"},
           {"launches --n 64 --rounds 1", "launches.json", "launches.txt"},
           {"frames --n 100 --draws compute --places outside --works frame --size 64x48 --rounds 1", "frames.json",
            "frames.txt"}}) {
    const auto warned = [&](const Outcome& outcome) {
      return (outcome.output + outcome.errors).find("WARNING: other programs kept") != std::string::npos;
    };
    const Outcome calm = run("0.1", words);
    EXPECT_EQ(calm.code, 0) << words << calm.errors;
    EXPECT_FALSE(warned(calm)) << words << calm.output << calm.errors;
    const Outcome busy = run("0.9", words);
    EXPECT_EQ(busy.code, 0) << words << busy.errors;
    EXPECT_TRUE(warned(busy)) << words << busy.output << busy.errors;
    EXPECT_NE(read_bytes(path(std::string("study/") + tables)).find("WARNING: other programs kept"), std::string::npos);
    const std::string warnings = read_json(std::string("study/") + record).at("warnings").dump();
    EXPECT_NE(warnings.find(" of this machine's cores busy when this study began"), std::string::npos) << warnings;
  }
}

// No backend of these tests launches anything: every path is left out behind the check, since it goes another way.
TEST_F(StudyProgram, LaunchesTimesNoWrongResult) { expect_no_wrong_result_timed("launches --n 300"); }
TEST_F(StudyProgram, LaunchesTimesNoPathThatGoesAnotherWay) {
  const Outcome right = study("none", "launches --n 300");
  EXPECT_EQ(right.code, 0) << right.errors;
  EXPECT_NE(right.output.find("its steps go another way here"), std::string::npos) << right.output;
}

}  // namespace
}  // namespace spherepair
