// SPDX-License-Identifier: MIT
// Runs that stop and go on: with unequal radii and sideways speeds, stopped before and after the first bounce, in every
// motion and precision, from each backend to each other. Nothing may tell them from a run that did not stop.
#include <fmt/format.h>

#include <cmath>

#include "common/files/checkpoint.h"
#include "tests/oracle/adversarial.h"
#include "tests/support/motion_runs.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

constexpr uint64_t BEFORE_A_BOUNCE = 5, AFTER_SOME = 60, END = 150;  // steps of 1/64 s

// From 0.5 m above the plane on, so that nothing bounces within 14 steps.
Scene falling_scene(MotionOptions motion, uint64_t n = 300) {
  Random random(30);
  Scene scene = make_scene({.name = "random", .n = n, .radius_ratio = 4, .motion = motion, .restitution = 0.75f});
  for (uint64_t i = 0; i < n; ++i) {
    vec4 &at = scene.positions[i], &v = scene.velocities[i];
    at = {float(random.uniform(-4, 4)), scene.plane + at.w + 0.5f + float(random.uniform(0, 4)),
          float(random.uniform(-4, 4)), at.w * 0.5f};
    v = {float(random.uniform(-3, 3)), float(random.uniform(-1, 1)), float(random.uniform(-3, 3)), 0};
  }
  return scene;
}

struct Look {
  Motion::State state;
  MotionState kept;
  StepResult answer;
};
Look look_at(Backend& backend) {
  Look look{current_state(backend), backend.save(), {}};
  look.answer = run_step(backend, fast_method(backend));
  return look;
}

void expect_equal_looks(const Look& given, const Look& wanted, const std::string& where) {
  expect_equal_states(given.state, wanted.state, where);
  EXPECT_EQ(given.kept.steps, wanted.kept.steps) << where;
  EXPECT_EQ(state_hash(given.kept.anchors, {}, given.kept.flights),
            state_hash(wanted.kept.anchors, {}, wanted.kept.flights))
      << where;
  EXPECT_EQ(given.kept.since, wanted.kept.since) << where;
  EXPECT_EQ(given.kept.next_event, wanted.kept.next_event) << where;
  EXPECT_EQ(given.answer.counts, wanted.answer.counts) << where;
  EXPECT_EQ(given.answer.totals.fingerprint, wanted.answer.totals.fingerprint) << where;
}

class ResumeOf : public BackendTest {};

TEST_P(ResumeOf, EveryMotionGoesOnToTheSameBitsOnEveryBackend) {
  const ScratchFolder folder;
  for (size_t turn = 0; const MotionOptions& motion : all_motions()) {
    const Scene scene = falling_scene(motion);
    run_steps(cpu_backend(), scene, END);
    const Look wanted = look_at(cpu_backend());
    EXPECT_GT(wanted.answer.totals.pairs, 10u);
    for (const uint64_t stop : {turn++ % 2 ? BEFORE_A_BOUNCE : 0, AFTER_SOME}) {
      const Motion::State middle = run_steps(backend(), scene, stop);
      Checkpoint written{scene, backend().save(), stop};
      written.scene.positions = middle.positions;
      written.scene.velocities = middle.velocities;
      write_checkpoint(folder.path("middle"), written);
      const Look stopped = look_at(backend());
      const Checkpoint read = read_checkpoint(folder.path("middle"));
      for (Backend* other : open_backends()) {
        const std::string where =
            fmt::format("{}, stopped at {}, on {}", motion_label(motion), stop, other->info().name);
        run_steps(*other, falling_scene({MotionMethod::anchored, Precision::float64}, 77), 3);
        other->resume(read.scene, read.motion);
        expect_equal_looks(look_at(*other), stopped, where);
        for (uint64_t step = stop; step < END; ++step) other->move();
        expect_equal_looks(look_at(*other), wanted, where);
      }
    }
  }
}

INSTANTIATE_BACKENDS(ResumeOf);

class ResumeProgram : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    const Scene scene = falling_scene({});
    std::string text;
    for (uint64_t i = 0; i < scene.size(); ++i) {
      const vec4 &at = scene.positions[i], &v = scene.velocities[i];
      text += fmt::format("{} {} {} {} {} {} {}\n", at.x, at.y, at.z, at.w, v.x, v.y, v.z);
    }
    folder_.write("spheres.txt", text);
  }

  // The state, the set and the checkpoint at the end, which is all that a run says about it.
  std::string end_of(const std::string& arguments) const {
    const Outcome outcome = run(fmt::format("run {}{} --save {} --json {}", arguments,
                                            arguments.find("--backend") == arguments.npos ? " --backend cpu" : "",
                                            path("end"), path("end.json")));
    EXPECT_EQ(outcome.code, 0) << arguments << ": " << outcome.errors;
    return read_json("end.json").at("steps").back().dump() + read_bytes(path("end"));
  }

  std::string start(MotionOptions motion) const {
    return fmt::format("--input {} --restitution 0.75 --motion {} --precision {}", path("spheres.txt"),
                       motion_name(motion.method), precision_name(motion.precision));
  }
};

// The precisions differ only in what ResumeOf compares.
TEST_F(ResumeProgram, EveryMotionGoesOnToTheSameFile) {
  const std::string other = open_backends().back()->info().name;
  for (const MotionOptions& motion : all_motions()) {
    if (motion.precision != Precision::compensated) continue;
    const std::string to_the_end = fmt::format("--resume {} --steps {}", path("middle"), END - AFTER_SOME);
    const std::string whole = end_of(fmt::format("{} --steps {}", start(motion), END)),
                      begin = fmt::format("{} --steps {} --save {}", start(motion), AFTER_SOME, path("middle"));
    EXPECT_EQ(run("run --backend cpu " + begin).code, 0);
    EXPECT_TRUE(end_of(to_the_end) == whole) << motion_label(motion);
    EXPECT_TRUE(end_of(to_the_end + " --backend " + other) == whole) << motion_label(motion) << ", on " << other;
  }
}

TEST_F(ResumeProgram, SavingOnTheWayChangesNothing) {
  const MotionOptions motion = {MotionMethod::anchored, Precision::compensated};
  const std::string whole = end_of(start(motion) + " --steps 100");
  EXPECT_TRUE(end_of(start(motion) + " --steps 100 --save-every 7") == whole);
  EXPECT_TRUE(end_of(start(motion) + " --steps 100 --save-every 7 --per-step") == whole);
}

}  // namespace
}  // namespace spherepair
