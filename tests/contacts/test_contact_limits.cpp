// SPDX-License-Identifier: MIT
// A sphere too fast or out of range along any axis, in either direction, ends a run by its name.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "common/scene/contact_scene.h"
#include "tests/support/motion_runs.h"

namespace spherepair {
namespace {

class ContactLimits : public KernelTest {
 protected:
  void SetUp() override {
    BackendTest::SetUp();
    scene_ = scene_of({{0, 0, 0, 0.5f}, {3, 0, 0, 0.5f}, {6, 0, 0, 0.5f}});
    scene_.gravity = 0;
    choose_contacts(scene_, {.law = ContactLaw::spring});
    cpu_backend().upload(scene_);
    saved_ = cpu_backend().save();
    const ContactParams c = contact_params(scene_);
    fastest_ = double(c.fastest) / double(mobility_of(0.5f, c));
  }
  // Of sphere 1: `part` 0 to 2 is a position, 3 to 5 a momentum. What one step from there says.
  std::string fault_of_word(Backend& on, uint64_t part, int64_t value) const {
    MotionState saved = saved_;
    store_real(saved.wide, part * scene_.size() + 1, value);
    on.resume(scene_, saved);
    try {
      on.move();
      on.evaluate_state();
    } catch (const std::invalid_argument& fault) {
      return std::string(fault.what()).substr(on.info().name.size());
    }
    return "";
  }
  void expect_fault(uint64_t part, int64_t value, const std::string& wanted) {
    const std::string found = fault_of_word(backend(), part, value);
    EXPECT_NE(found.find(wanted), std::string::npos) << "part " << part << ", " << value << ": '" << found << "'";
    EXPECT_EQ(found, fault_of_word(cpu_backend(), part, value));
  }

  Scene scene_;
  MotionState saved_;
  double fastest_ = 0;  // units of momentum, of these spheres
};

TEST_P(ContactLimits, OfSpeedHoldInEachDirection) {
  for (uint64_t part = 3; part < 6; ++part)
    for (const double sign : {1.0, -1.0}) {
      expect_fault(part, int64_t(sign * 1.01 * fastest_), "step 1 of ");
      expect_fault(part, int64_t(sign * 1.01 * fastest_), "sphere 1 moves by more than the smallest radius in a step");
      EXPECT_EQ(fault_of_word(backend(), part, int64_t(sign * 0.99 * fastest_)), "") << part << " " << sign;
    }
}

TEST_P(ContactLimits, OfPlaceHoldInEachDirection) {
  for (uint64_t part = 0; part < 3; ++part)
    for (const int64_t sign : {1, -1}) {
      if (part == 1 && sign < 0) continue;  // behind the plane: too deep in it
      expect_fault(part, sign * MOST_UNITS, "sphere 1 has left the range of float32 centres and 64-bit positions");
      EXPECT_EQ(fault_of_word(backend(), part, sign * (MOST_UNITS - 1)), "") << part << " " << sign;
    }
}

// Of the three faults the first in this order is told, whichever sphere has it.
TEST(ContactLimitsOfASphere, HoldInEachDirection) {
  ContactParams c = {};
  c.fastest = 1000;
  const auto fault = [&](int64_t x, int64_t y, int64_t z, const vec4& speeds) {
    return fault_of({x, y, z, 0, 0, 0, 0.5f}, speeds, c);
  };
  EXPECT_EQ(fault(MOST_UNITS - 1, 1 - MOST_UNITS, 0, {1000, -1000, 1000, 0}), uint(FAULTS));
  for (const int64_t far : {MOST_UNITS, -MOST_UNITS}) {
    EXPECT_EQ(fault(far, 0, 0, {}), uint(FAULT_RANGE));
    EXPECT_EQ(fault(0, far, 0, {}), uint(FAULT_RANGE));
    EXPECT_EQ(fault(0, 0, far, {2000, 0, 0, 0}), uint(FAULT_RANGE));
  }
  for (const float fast : {1001.0f, -1001.0f}) {
    EXPECT_EQ(fault(0, 0, 0, {fast, 0, 0, 0}), uint(FAULT_FAST));
    EXPECT_EQ(fault(0, 0, 0, {0, fast, 0, 0}), uint(FAULT_FAST));
    EXPECT_EQ(fault(0, 0, 0, {0, 0, fast, 0}), uint(FAULT_FAST));
  }
}

// Two spheres, the second so far out that rounding takes half of its skin within some 200 steps.
struct FarOut {
  Scene scene;
  MotionState saved;
};
FarOut far_out() {
  FarOut far{scene_of({{0, 0, 0, 0.5f}, {3, 0, 0, 0.5f}}), {}};
  far.scene.plane = -1000, far.scene.gravity = 0;
  choose_contacts(far.scene, {.law = ContactLaw::spring});
  far.scene.velocities[1].x = 1e-4f / far.scene.dt;
  cpu_backend().upload(far.scene);
  far.saved = cpu_backend().save();
  far.scene.positions[1].x = 52428.78f;
  const double units = std::ldexp(double(far.scene.positions[1].x), far.scene.contact.unit_exponent);
  store_real(far.saved.wide, 1, int64_t(units));
  return far;
}

// What so many steps say, the first of them ahead of a cut.
std::string text_of_cut_run(Backend& on, const FarOut& far, uint64_t cut, uint64_t steps) {
  on.resume(far.scene, far.saved);
  try {
    for (uint64_t step = 0; step < cut; ++step) on.move();
    if (cut) {
      Scene scene = far.scene;
      const Motion::State state = current_state(on);
      scene.positions = state.positions, scene.velocities = state.velocities;
      on.resume(scene, on.save());
    }
    for (uint64_t step = cut; step < steps; ++step) on.move();
    on.evaluate_state();
  } catch (const std::invalid_argument& fault) {
    return std::string(fault.what()).substr(on.info().name.size());
  }
  return "";
}

TEST_P(ContactLimits, OfDistanceEndARunInTheSameStepWhereverItIsCut) {
  const FarOut far = far_out();
  const std::string wanted = text_of_cut_run(cpu_backend(), far, 0, 600);
  EXPECT_NE(wanted.find("sphere 1 has left the range"), std::string::npos) << wanted;
  uint64_t failed = 0;
  std::sscanf(wanted.c_str(), ": contacts cannot go on from step %lu", &failed);
  EXPECT_GT(failed, 100u);
  for (uint64_t cut = 0; cut < failed; cut += 7) EXPECT_EQ(text_of_cut_run(backend(), far, cut, 600), wanted) << cut;
}

INSTANTIATE_BACKENDS(ContactLimits);

}  // namespace
}  // namespace spherepair
