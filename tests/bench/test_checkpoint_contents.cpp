// SPDX-License-Identifier: MIT
// Checkpoints whose checksums are right and whose contents no run can have saved: each is refused by the name of the
// file, the part and the sphere.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>

#include "common/files/checkpoint.h"
#include "tests/support/motion_runs.h"
#include "tests/support/sphere_files.h"

namespace spherepair {
namespace {

constexpr float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN();
constexpr uint64_t N = 60;

// Some spheres have bounced by then, others not.
Checkpoint saved_run(MotionOptions motion) {
  Scene scene = awkward_scene({.motion = motion, .dt = 0.125f, .restitution = 0.5f, .n = N});
  const Motion::State state = run_steps(cpu_backend(), scene, 7);
  Checkpoint checkpoint{scene, cpu_backend().save(), 7};
  checkpoint.scene.positions = state.positions;
  checkpoint.scene.velocities = state.velocities;
  return checkpoint;
}

using Spoil = std::function<void(Checkpoint&)>;
class CheckpointContents : public testing::Test {
 protected:
  void expect_refused(MotionOptions motion, const std::string& part, const std::string& expected, const Spoil& spoil) {
    Checkpoint checkpoint = saved_run(motion);
    spoil(checkpoint);
    write_checkpoint(folder_.path("spoilt"), checkpoint);
    const std::string complaint = complaint_of([&] { read_checkpoint(folder_.path("spoilt")); });
    for (const std::string& word : {folder_.path("spoilt"), part, expected})
      EXPECT_NE(complaint.find(word), std::string::npos)
          << motion_label(motion) << ": no \"" << word << "\" in: " << complaint;
  }
  void expect_refused_always(const std::string& part, const std::string& expected, const Spoil& spoil) {
    for (const MotionOptions& motion : all_motions()) expect_refused(motion, part, expected, spoil);
  }
  const ScratchFolder folder_;
};

TEST_F(CheckpointContents, WhatRunsSaveIsRead) {
  for (const MotionOptions& motion : all_motions())
    for (const int steps : {0, 1, 30}) {
      const Scene scene = awkward_scene({.motion = motion, .dt = 0.7f, .restitution = 0.96f, .n = 2000});
      for (Backend* backend : open_backends()) {
        const Motion::State state = run_steps(*backend, scene, uint64_t(steps));
        Checkpoint checkpoint{scene, backend->save(), uint64_t(steps)};
        checkpoint.scene.positions = state.positions;
        checkpoint.scene.velocities = state.velocities;
        write_checkpoint(folder_.path("run"), checkpoint);
        EXPECT_EQ(complaint_of([&] { read_checkpoint(folder_.path("run")); }), "")
            << motion_label(motion) << " on " << backend->info().name << ", " << steps << " steps";
      }
    }
}

TEST_F(CheckpointContents, RadiiThatAreSaidToBeEqualAre) {
  expect_refused_always("positions, sphere 1", "equal", [](Checkpoint& c) { c.scene.equal_radii = true; });
}

TEST_F(CheckpointContents, EveryNumberIsFinite) {
  for (const float bad : {NOT_A_NUMBER, INFINITY, -INFINITY}) {
    expect_refused_always("positions, sphere 41", "finite", [=](Checkpoint& c) { c.scene.positions[41].z = bad; });
    expect_refused_always("positions, sphere 0", "finite", [=](Checkpoint& c) { c.scene.positions[0].w = bad; });
    expect_refused_always("velocities, sphere 59", "finite", [=](Checkpoint& c) { c.scene.velocities[59].x = bad; });
  }
  expect_refused_always("positions, sphere 3", "radius", [](Checkpoint& c) { c.scene.positions[3].w = -1; });
}

// Word by word, so that no part of a number is left out.
TEST_F(CheckpointContents, EveryNumberThatAMotionKeepsIsFinite) {
  for (const MotionOptions& motion : all_motions()) {
    const Checkpoint whole = saved_run(motion);
    const uint words = real_words(motion.precision),
               nan = motion.precision == Precision::float64 ? 0x7FF80000u : 0x7FC00000u;
    const uint step = motion.precision == Precision::float64 ? 2 : 1, first = step - 1;
    for (uint64_t k = first; k < whole.motion.wide.size(); k += 31 * step)
      expect_refused(motion, fmt::format("wide state, sphere {}", k / words % N), "finite",
                     [=](Checkpoint& c) { c.motion.wide[k] = nan; });
    for (uint64_t k = first; k < whole.motion.flights.size(); k += 7 * step)
      expect_refused(motion, fmt::format("flights, sphere {}", k / words % N), "finite",
                     [=](Checkpoint& c) { c.motion.flights[k] = nan; });
    if (motion.method != MotionMethod::anchored) continue;
    for (float vec4::*part : {&vec4::x, &vec4::y, &vec4::z, &vec4::w})
      expect_refused(motion, "anchors, sphere 8", "finite",
                     [=](Checkpoint& c) { c.motion.anchors[8].*part = NOT_A_NUMBER; });
  }
}

TEST_F(CheckpointContents, TheStateIsWhatTheMotionKeeps) {
  for (const MotionOptions& motion : all_motions()) {
    if (motion.method != MotionMethod::anchored && motion.precision == Precision::float32) continue;
    expect_refused(motion, "positions, sphere 5", "by the", [](Checkpoint& c) { c.scene.positions[5].x += 1; });
    expect_refused(motion, "velocities, sphere 6", "by the", [](Checkpoint& c) { c.scene.velocities[6].y += 1; });
  }
  for (const Precision precision : PRECISIONS) {
    const MotionOptions motion = {MotionMethod::anchored, precision};
    const auto refused = [&](const std::string& part, const Spoil& spoil) {
      expect_refused(motion, part, "by", spoil);
    };
    refused("positions, sphere 9", [](Checkpoint& c) { c.motion.anchors[9].x += 1; });
    refused("positions, sphere 9", [](Checkpoint& c) { c.motion.anchors[9].w += 1; });
    refused("due steps, sphere 9", [](Checkpoint& c) { c.motion.next_event[9] += 1; });
    refused("steps of the anchors, sphere 9", [](Checkpoint& c) { c.motion.since[9] = 3; });
    refused("steps of the anchors, sphere 9", [](Checkpoint& c) { c.motion.since[9] = 8 | ANCHOR_ON_PLANE; });
    if (precision != Precision::float32)
      expect_refused(motion, "wide state, sphere 9", "anchors", [](Checkpoint& c) { c.motion.wide[2 * 9] ^= 1; });
  }
}

TEST_F(CheckpointContents, StepsAreThoseThatTheMotionCounts) {
  expect_refused_always("header", "steps", [](Checkpoint& c) { c.motion.steps += 1; });
  expect_refused_always("header", "steps", [](Checkpoint& c) { c.step = uint64_t(1) << 54; });
  expect_refused({MotionMethod::anchored, {}}, "header", "steps", [](Checkpoint& c) { c.step += 1; });
}

TEST_F(CheckpointContents, TheParametersAreThoseOfAScene) {
  for (const float bad : {NOT_A_NUMBER, INFINITY, -INFINITY}) {
    expect_refused_always("header", "dt", [=](Checkpoint& c) { c.scene.dt = bad; });
    expect_refused_always("header", "restitution", [=](Checkpoint& c) { c.scene.restitution = bad; });
    expect_refused_always("header", "gravity", [=](Checkpoint& c) { c.scene.gravity = bad; });
    expect_refused_always("header", "plane", [=](Checkpoint& c) { c.scene.plane = bad; });
  }
}

}  // namespace
}  // namespace spherepair
