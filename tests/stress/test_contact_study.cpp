// SPDX-License-Identifier: MIT
// What `spherepair contacts` measures: errors fall with the square of the time step, the momentum stays to the last
// unit, runs go back to the first bits; and what it records.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "bench/io/report.h"
#include "bench/studies/contact/contact_study.h"
#include "tests/faults/faulty_session.h"
#include "tests/support/backends.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

class ContactStudy : public ProgramTest {
 protected:
  static ContactPlan small_plan(const ContactKind& kind) {
    ContactPlan plan;
    plan.kinds = {kind};
    plan.steps_a_contact = {10, 160};
    plan.n = 216;
    return plan;
  }
  std::vector<ContactRun> errors_of(const ContactPlan& plan) {
    Session session({"cpu"}, {});
    return measure_contact_errors(session, plan, progress_);
  }
  Progress progress_;
};

// By 256 with four halvings; less while few steps a contact happen to be right, since a contact lasts a whole number.
TEST_F(ContactStudy, ElasticErrorsFallWithTheSquareOfTheTimeStep) {
  for (const ContactLaw law : {ContactLaw::spring, ContactLaw::hertz, ContactLaw::quartic}) {
    const std::vector<ContactRun> runs = errors_of(small_plan({law}));
    ASSERT_EQ(runs.size(), 2u);
    const ContactRun &coarse = runs.front(), &fine = runs.back();
    EXPECT_EQ(fine.steps, 16 * coarse.steps);
    EXPECT_GT(coarse.position / fine.position, 64) << contact_name(law);
    EXPECT_LT(coarse.position, 1e-2) << contact_name(law);
    EXPECT_LT(std::abs(fine.energy), 1e-5) << contact_name(law);
  }
}

TEST_F(ContactStudy, RunsKeepTheMomentumAndGoBack) {
  for (const ContactKind& kind : ContactPlan{}.kinds) {
    ContactPlan plan = small_plan(kind);
    plan.steps_a_contact = {10};
    for (const ContactRun& run : errors_of(plan)) {
      EXPECT_EQ(run.momentum, (std::array<int64_t, 3>{})) << label(kind);
      ASSERT_EQ(run.returns.has_value(), kind.restitution == 1) << label(kind);
      EXPECT_TRUE(run.returns.value_or(true)) << label(kind);
      EXPECT_GT(run.position, 0) << label(kind);
    }
  }
}

TEST_F(ContactStudy, DifferentStatesAreNotRecorded) {
  ContactPlan plan = small_plan({ContactLaw::quartic});
  plan.steps_a_contact = {10};
  for (const NamedFault& fault : state_faults()) {
    Session session = session_with(fault.fault, 1);
    expect_named(difference_of([&] { measure_contact_errors(session, plan, progress_); }), fault, "contacts");
  }
}

// A small gas for a short time: pressures and cooling times are those of kinetic theory only roughly.
TEST_F(ContactStudy, RatesAreThoseOfEachTimeStepAgainstTheConvergedOne) {
  ContactPlan plan = small_plan({ContactLaw::spring});
  plan.steps_a_contact = {10, 20};
  plan.rates = {.n = 1000, .seeds = 2, .converged = 40, .softer = 16};
  Session session({"cpu"}, {});
  const std::vector<ContactRate> rates = measure_rates(session, plan, progress_);
  ASSERT_EQ(rates.size(), 3 * 3u);
  for (size_t k = 0; k < rates.size(); ++k) {
    const ContactRate &rate = rates[k], &converged = rates[k / 3 * 3 + 2];
    EXPECT_EQ(converged.steps_a_contact, 40u);
    EXPECT_NEAR(rate.dt / converged.dt, 40.0 / rate.steps_a_contact, 1e-6);
    ASSERT_EQ(rate.over_theory.size(), 2u);
    EXPECT_NE(rate.over_theory[0], rate.over_theory[1]) << "by seed";
    for (const double ratio : rate.over_theory) EXPECT_NEAR(ratio, 1, 0.2) << rate.restitution;
    ASSERT_EQ(rate.errors.size(), &rate == &converged ? 0u : 2u);
    for (size_t seed = 0; seed < rate.errors.size(); ++seed) {
      EXPECT_DOUBLE_EQ(rate.errors[seed], rate.found[seed] / converged.found[seed] - 1);
      EXPECT_NE(rate.errors[seed], 0);
    }
  }
  plan.kinds = {{ContactLaw::quartic}};
  EXPECT_TRUE(measure_rates(session, plan, progress_).empty());
}

TEST_F(ContactStudy, RecordsEveryRunAndStep) {
  const Outcome outcome =
      run(fmt::format("contacts --backends cpu --threads 2 --laws spring --steps 10,20 --n 125,64 --averaged 30 "
                      "--drag-steps 0.1:5 --rounds 6 --results {}",
                      path("r")));
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const json record = json::parse(read_bytes(path("r/contacts.json")));
  EXPECT_EQ(record.at("format"), "spherepair contacts 1");
  ASSERT_EQ(record.at("contact_runs").size(), 2 * 2u);
  for (const json& run : record.at("contact_runs")) {
    EXPECT_EQ(run.at("law"), "spring");
    EXPECT_EQ(run.at("n"), 125);
    EXPECT_EQ(run.at("returns").is_null(), run.at("restitution") < 1);
    EXPECT_GT(run.at("position"), 0.0);
    EXPECT_LE(run.at("low"), run.at("seconds_per_step"));
    EXPECT_DOUBLE_EQ(run.at("run_seconds").get<double>(),
                     run.at("steps").get<double>() * run.at("seconds_per_step").get<double>());
  }
  ASSERT_EQ(record.at("gas_steps").size(), 2u);
  const json& steps = record.at("gas_steps").front();
  EXPECT_EQ(steps.at("n"), 125);
  EXPECT_EQ(steps.at("steps"), 30);
  EXPECT_EQ(steps.at("sample").at("batches"), json({1})) << "their mean, no slope";
  EXPECT_DOUBLE_EQ(steps.at("seconds_per_step").get<double>(), steps.at("sample").at("median_ms").get<double>() / 30e3);
  EXPECT_TRUE(steps.at("over_cuda").is_null());
  EXPECT_DOUBLE_EQ(steps.at("sphere_steps_per_second").get<double>(), 125 / steps.at("seconds_per_step").get<double>());
  ASSERT_EQ(record.at("contact_rates").size(), 3 * 3u);
  for (const json& rate : record.at("contact_rates")) {
    EXPECT_EQ(rate.at("quantity"), rate.at("restitution") == 1.0 ? "pressure" : "cooling time");
    EXPECT_LE(rate.at("over_theory").at("low"), rate.at("over_theory").at("high"));
    EXPECT_EQ(rate.at("error").is_null(), rate.at("steps_a_contact") == 80);
  }
  EXPECT_NE(outcome.output.find("Whole steps of the scene gas"), std::string::npos) << outcome.output;
  std::istringstream lines(outcome.output);
  for (std::string line; std::getline(lines, line);)
    EXPECT_TRUE(line.size() <= kTextWidth || line.find("Results: ") != line.npos) << line;
}

// A single layer in few steps; the same bits awake are compared by the study itself.
TEST_F(ContactStudy, RecordsBedsAtRest) {
  const Outcome outcome =
      run(fmt::format("contacts --backends cpu --threads 2 --measure rest --n 90 --rest-layers 8 "
                      "--drag-steps 0.005:12000,0.1:1000 --rounds 6 --results {}",
                      path("r")));
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const json record = json::parse(read_bytes(path("r/contacts.json")));
  EXPECT_EQ(record.at("settings").at("rest").at("stages").at(1), (json{{"drag_a_step", 0.1}, {"steps", 1000}}));
  EXPECT_FLOAT_EQ(record.at("settings").at("rest").at("stiffness"), 8 * 3e5f) << "in proportion to the layers";
  ASSERT_EQ(record.at("beds").size(), 1u);
  const json& bed = record.at("beds").front();
  EXPECT_EQ(bed.at("n"), 4 * (16 + 9)) << "eight whole layers";
  EXPECT_EQ(bed.at("unmoved"), 1.0);
  EXPECT_LT(bed.at("kinetic"), 1e-12);
  EXPECT_NEAR(bed.at("floor_force").get<double>(), 1, 1e-6);
  EXPECT_LT(bed.at("overlap"), 0.05);
  ASSERT_EQ(bed.at("steps").size(), 2u);
  for (const json& steps : bed.at("steps")) {
    ASSERT_EQ(steps.at("awake_over_this").is_null(), !steps.at("sleeping"));
    if (!steps.at("sleeping")) continue;
    EXPECT_GT(steps.at("awake_over_this").at("ratio"), 2.0) << "30 and more on a CPU";
  }
  EXPECT_NE(outcome.output.find("Steps of beds at rest"), std::string::npos) << outcome.output;
}

TEST_F(ContactStudy, RefusesWhatItDoesNotKnow) {
  for (const auto& [words, message] : {std::pair("--laws springs", "did you mean spring"),
                                       {"--laws none", "the law none has no contacts: leave it out of --laws"},
                                       {"--steps 15", "15"},
                                       {"--measure error", "did you mean errors"},
                                       {"--measure rates --laws hertz", "name it, or omit rates"},
                                       {"--measure rest --drag-steps 0.1", "is not a drag a step"},
                                       {"--measure rest --drag-steps 2:9", "is not a drag a step"},
                                       {"--measure rates --n 124", "at least 125"},
                                       {"--n 0", "--n"}}) {
    const Outcome outcome = run(fmt::format("contacts --backends cpu {} --results {}", words, path("r")));
    EXPECT_EQ(outcome.code, 2) << words;
    EXPECT_NE(outcome.errors.find(message), std::string::npos) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(path("r"))) << words;
  }
}

}  // namespace
}  // namespace spherepair
