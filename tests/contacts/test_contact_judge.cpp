// SPDX-License-Identifier: MIT
// What compares runs with contacts, fed steps that go wrong: lockstep, compare, equal, statistics and checkpoints each
// find every fault.
#include <fmt/format.h>

#include "bench/check/lockstep.h"
#include "common/shared/contact/contact_rest.h"
#include "tests/faults/faulty_session.h"
#include "tests/support/motion_runs.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

// Spheres fall onto each other and come to rest; the lists of near pairs are renewed on the way.
constexpr uint64_t steps = 1600, every = 100, n = 8;
const SceneOptions bed_scene = {.name = "bed", .n = n, .restitution = 0.3f};
const ContactChoice contact = {.law = ContactLaw::spring, .stiffness = 1e6f, .dt = 1.25e-3f, .drag = 100};
const std::string words = fmt::format(
    "bed --n {} --contact spring --restitution 0.3 --stiffness 1e6 --dt 1.25e-3 --drag 100 --steps {}", n, steps);

std::vector<EqualityEntry> lockstep(Session& session, uint64_t compared) {
  Progress progress;
  return check_lockstep(
      session, {bed_scene, steps, compared, {Method::sequential, Method::collide_grid}, {64}, contact}, progress);
}

TEST(ContactJudge, LockstepAcceptsRightSteps) {
  Session session = session_with(Fault::none);
  EXPECT_EQ(lockstep(session, every).size(), 1u);
}

TEST(ContactJudge, LockstepNamesEveryFault) {
  for (const NamedFault& fault : contact_faults()) {
    Session session = session_with(fault.fault);
    const std::string message = difference_of([&] { lockstep(session, 1); });
    expect_named(message, fault, "lockstep");
    EXPECT_NE(message.find("of leapfrog fixed: "), std::string::npos) << message;
  }
}

// The first step behind which a sphere has the state of the step before.
uint64_t first_step_at_rest() {
  Scene scene = make_scene(bed_scene);
  choose_contacts(scene, contact);
  Backend& cpu = cpu_backend();
  cpu.upload(scene);
  std::vector<Body> before = bodies_of(cpu.save().wide, scene.positions);
  for (uint64_t step = 1; step < steps; ++step) {
    cpu.move();
    const std::vector<Body> now = bodies_of(cpu.save().wide, scene.positions);
    for (uint64_t i = 0; i < n; ++i)
      if (is_same(now[i], before[i])) return step;
    before = now;
  }
  ADD_FAILURE() << "no sphere rests";
  return 0;
}

TEST(ContactJudge, LockstepNamesTheStepWhereAFaultBegins) {
  const uint64_t at_rest = first_step_at_rest();
  for (const auto& [fault, from] : {std::pair(Fault::moves_at_rest, at_rest), {Fault::drag_once_more, uint64_t(5)}}) {
    Session session = session_with(fault, from);
    const std::string message = difference_of([&] { lockstep(session, 1); });
    EXPECT_NE(message.find(fmt::format("step {} of", from + 1)), std::string::npos) << message;
  }
}

class ContactJudgeProgram : public ProgramTest {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(SPHEREPAIR_FAULTY_PROGRAM))
      GTEST_SKIP() << "no " << SPHEREPAIR_FAULTY_PROGRAM << " here";
  }
  Outcome faulty(const std::string& fault, const std::string& arguments) const {
    return run_shell(
        fmt::format("SPHEREPAIR_FAULT={} '{}' {} --threads 1", fault, SPHEREPAIR_FAULTY_PROGRAM, arguments), folder_);
  }
  Outcome compare(const std::string& fault, const std::string& backends) const {
    return faulty(fault, fmt::format("compare --backends {} --scenes {} --every {} --blocks 64 --methods "
                                     "parallel,collide_grid --tables none --results '{}'",
                                     backends, words, every, path(fault)));
  }
  // The statistics and the checkpoint of a run on the faulty backend.
  std::string statistics(const std::string& fault, const std::string& run) const {
    const Outcome outcome =
        faulty(fault, fmt::format("run --backend opengl {} --statistics '{}' --statistics-every {} --save '{}'", run,
                                  path("rows"), every, path("end")));
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return read_bytes(path("rows"));
  }
  std::string end() const { return read_bytes(path("end")); }
};

TEST_F(ContactJudgeProgram, CompareFindsEveryFault) {
  const Outcome right = compare("none", "cpu,opengl");
  EXPECT_EQ(right.code, 0) << right.errors;
  for (const NamedFault& fault : contact_faults()) {
    const Outcome wrong = compare(fault.name, "cpu,opengl");
    EXPECT_EQ(wrong.code, 1) << fault.name << wrong.output;
    EXPECT_NE(wrong.errors.find("DIFFERENCE FOUND"), std::string::npos) << wrong.errors;
    EXPECT_EQ(read_json(fmt::format("{}/results.json", fault.name)).at("verdict"), "difference");
  }
}

// A machine whose one backend is wrong finds no difference of its own; its record does.
TEST_F(ContactJudgeProgram, EqualFindsEveryFault) {
  ASSERT_EQ(compare("none", "cpu").code, 0);
  for (const NamedFault& fault : contact_faults()) {
    ASSERT_EQ(compare(fault.name, "opengl").code, 0) << fault.name;
    const Outcome outcome = run_shell(fmt::format("'{}' equal '{}/results.json' '{}/results.json'",
                                                  SPHEREPAIR_FAULTY_PROGRAM, path("none"), path(fault.name)),
                                      folder_);
    EXPECT_EQ(outcome.code, 1) << fault.name << outcome.output << outcome.errors;
    EXPECT_NE(outcome.output.find("DIFFERENT: "), std::string::npos) << outcome.output;
  }
}

TEST_F(ContactJudgeProgram, StatisticsAndCheckpointsShowEveryFault) {
  const std::string run = "--scene " + words, rows = statistics("none", run), checkpoint = end();
  for (const NamedFault& fault : contact_faults()) {
    EXPECT_NE(statistics(fault.name, run), rows) << fault.name;
    EXPECT_TRUE(end() != checkpoint) << fault.name;
  }
}

// Cut where spheres move.
TEST_F(ContactJudgeProgram, AResumedRunShowsMomentaThatWereNotSaved) {
  statistics("none", fmt::format("--scene {} --steps 300", words.substr(0, words.find(" --steps"))));
  std::filesystem::rename(path("end"), path("cut"));
  const std::string again = fmt::format("--resume '{}' --steps 300", path("cut")), rows = statistics("none", again),
                    checkpoint = end();
  const Outcome refused = faulty(
      "old_momenta",
      fmt::format("run --backend opengl {} --statistics '{}' --statistics-every {}", again, path("rows"), every));
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.errors.find("has another row of step 300"), std::string::npos) << refused.errors;
  std::filesystem::remove(path("rows"));
  EXPECT_NE(statistics("old_momenta", again), rows);
  EXPECT_TRUE(end() != checkpoint);
}

}  // namespace
}  // namespace spherepair
