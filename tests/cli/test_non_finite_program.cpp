// SPDX-License-Identifier: MIT
// The program where numbers leave float32: an exit code that says bad input, and a message with the sphere and the
// step.
#include <fmt/format.h>

#include "common/files/checkpoint.h"
#include "tests/support/motion_runs.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

class NonFiniteProgram : public ProgramTest {
 protected:
  void expect_refused(const std::string& arguments, const std::string& word) const {
    const Outcome outcome = run(arguments, "timeout 60");
    EXPECT_EQ(outcome.code, 2) << arguments << ": " << outcome.errors;
    EXPECT_NE(outcome.errors.find(word), std::string::npos) << arguments << ": " << outcome.errors;
  }

  // Sphere 1 leaves float32 with step 5 of a second: 3.4e38 + 5 * 6e34 m.
  std::string checkpoint_that_leaves(MotionOptions motion) const {
    Scene scene = scene_of({{0, 0, 0, 0.5f}, {3.4e38f, 100, 0, 0.5f}, {5, 0, 0, 0.25f}});
    scene.velocities[1].x = 6e34f;
    scene.motion = motion;
    scene.dt = 1;
    cpu_backend().upload(scene);
    write_checkpoint(path("huge"), {scene, cpu_backend().save(), 0});
    return "run --backend cpu --resume " + path("huge");
  }
};

TEST_F(NonFiniteProgram, RefusesTimeStepsBeyondTheBounds) {
  for (const char* dt : {"3.4e38", "1e21", "1048577", "1e-30", "inf", "nan", "0", "-1"})
    for (const char* motion : {"paper", "anchored", "impact --precision float64"})
      expect_refused(fmt::format("run --backend cpu --n 64 --steps 200 --motion {} --dt {}", motion, dt), "dt");
  EXPECT_EQ(run("run --backend cpu --n 64 --steps 20 --dt 1048576").code, 0);
}

TEST_F(NonFiniteProgram, RefusesToMoveSpheresBeyondTheBounds) {
  folder_.write("spheres.txt", "0 0 0 0.5 0 0 0\n3e38 0 0 0.5 1e38 0 0\n");
  const std::string input = "run --backend cpu --input " + path("spheres.txt");
  for (const std::string& motion :
       std::vector<std::string>{"paper", "paper --method sequential --save " + path("saved"), "anchored", "euler"})
    expect_refused(fmt::format("{} --steps 9 --motion {}", input, motion), "sphere 1");
  EXPECT_FALSE(std::filesystem::exists(path("saved")));
  EXPECT_EQ(run(input + " --precision float64 --steps 0").code, 0) << "a scene at rest may hold any finite number";
  EXPECT_EQ(run(input + " --steps 0").code, 0);
}

TEST_F(NonFiniteProgram, NamesTheSphereAndTheStepThatLeftFloat32) {
  for (const MotionMethod method : {MotionMethod::paper, MotionMethod::impact, MotionMethod::anchored})
    for (const Precision precision : PRECISIONS) {
      const std::string resume = checkpoint_that_leaves({method, precision});
      EXPECT_EQ(run(resume + " --steps 4").code, 0) << motion_label({method, precision});
      for (const char* found : {"collide_grid", "sequential", "auto"})
        expect_refused(fmt::format("{} --steps 7 --method {}", resume, found), "after step 7");
      expect_refused(resume + " --steps 7", "sphere 1");
      expect_refused(resume + " --steps 7 --per-step", "after step 5");
      expect_refused(fmt::format("render --resume {} --steps 6 --output {}", path("huge"), path("a.png")),
                     "after step 6");
    }
}

// So the file that is left is that of the last multiple before sphere 1 left float32 with step 5.
TEST_F(NonFiniteProgram, SavesNothingThatWouldBeRefusedAndElseAtTheMultiples) {
  const std::string resume = checkpoint_that_leaves({}), saved = path("saved");
  for (const auto& [every, last] : {std::pair(1, 4), std::pair(2, 4), std::pair(3, 3), std::pair(4, 4)}) {
    expect_refused(fmt::format("{} --steps 50 --save {} --save-every {}", resume, saved, every), "sphere 1");
    const std::string wanted = path("wanted");
    EXPECT_EQ(run(fmt::format("{} --steps {} --save {}", resume, last, wanted)).code, 0);
    EXPECT_TRUE(read_bytes(saved) == read_bytes(wanted)) << "every " << every;
    EXPECT_EQ(read_checkpoint(saved).step, uint64_t(last)) << "every " << every;
    std::filesystem::remove(saved);
  }
  expect_refused(fmt::format("{} --steps 50 --save {} --save-every 5", resume, saved), "after step 5");
  EXPECT_FALSE(std::filesystem::exists(saved)) << "at the start no step has been done";
}

}  // namespace
}  // namespace spherepair
