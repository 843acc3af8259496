// SPDX-License-Identifier: MIT
// Steps with contacts that cannot be taken: which sphere, in which step and by how much, the same from every backend;
// and no step after them.
#include <fmt/format.h>

#include "common/scene/contact_scene.h"
#include "tests/support/motion_runs.h"

namespace spherepair {
namespace {

class ContactFaults : public KernelTest {
 protected:
  std::string text_after(Backend& on, const Scene& scene, int steps) {
    on.upload(scene);
    for (int step = 0; step < steps; ++step) on.move();
    try {
      on.evaluate_state();
    } catch (const std::invalid_argument& fault) {
      const std::string text = fault.what(), begin = on.info().name + ": contacts cannot go on from ";
      EXPECT_EQ(text.substr(0, begin.size()), begin);
      return text.substr(begin.size());
    }
    return "";
  }

  // The step before is possible, and those behind change nothing.
  void expect_fault(const Scene& scene, int step, const std::string& wanted) {
    EXPECT_EQ(text_after(backend(), scene, step - 1), "");
    for (const int more : {0, 1, 40}) {
      const std::string text = text_after(backend(), scene, step + more);
      EXPECT_EQ(text.substr(0, wanted.size()), wanted) << more;
      EXPECT_EQ(text, text_after(cpu_backend(), scene, step + more));
    }
  }
};

Scene with_contacts(const std::vector<vec4>& spheres, float dt, float gravity = 0, float stiffness = 1e-4f) {
  Scene scene = scene_of(spheres);
  scene.plane = 0, scene.gravity = gravity;
  choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = stiffness, .dt = dt});
  return scene;
}

// By the CPU, whose state is read after each.
int first_failed_step(const Scene& scene) {
  cpu_backend().upload(scene);
  for (int step = 1; step < 10'000; ++step) try {
      cpu_backend().move(), cpu_backend().evaluate_state();
    } catch (const std::invalid_argument&) {
      return step;
    }
  return 0;
}

// v = g dt (k - 1/2) in step k: more than 0.001 m a step in the seventh.
TEST_P(ContactFaults, AFallTooFast) {
  expect_fault(
      with_contacts({{0, 1, 0, 0.002f}, {0.5f, 1, 0, 0.001f}}, 0.004f, -9.81f), 7,
      "step 7 of 0.004 s: sphere 0 moves by more than the smallest radius in a step, 0.00102 m of 0.001 m along "
      "an axis, at 0.2551 m/s: give --dt 0.001 or less, which has room for 3.92 times that speed");
}

// Told as deep as when the step began, though the spheres part in it.
TEST_P(ContactFaults, ADeepContact) {
  const float r = 0.001f;
  Scene scene = with_contacts({{0, 1, 0, r}, {0.0019f, 1, 0, r}, {0, 1.0005f, 0, r}}, 0.0004f, 0, 1);
  scene.velocities = {{0, -0.3f, 0, 0}, {0, 0, 0, 0}, {0, 0.3f, 0, 0}};
  expect_fault(
      scene, 1,
      "step 1 of 0.0004 s: sphere 0 is deeper in sphere 2 than the smaller radius, 0.0015 m of 0.001 m: let no");
}

TEST_P(ContactFaults, ACentreBehindAWall) {
  Scene scene = with_contacts({{2, 1, 0, 0.001f}, {0, 1, 0, 0.001f}, {1, 1, 0, 0.001f}}, 0.004f);
  scene.contact.walls = true;
  scene.contact.low = {0.0005f, scene.plane, -1, 0}, scene.contact.high = {3, 3, 3, 0};
  expect_fault(scene, 1,
               "step 1 of 0.004 s: sphere 1 is deeper in a wall than the smaller radius, 0.0015 m of 0.001 m");
}

// Two large spheres run into a small one between them, by steps so short that many are launched ahead.
TEST_P(ContactFaults, ADeepContactOnTheWay) {
  Scene scene = with_contacts({{0, 1, 0, 0.001f}, {0.0051f, 1, 0, 0.004f}, {-0.0051f, 1, 0, 0.004f}}, 5e-6f, 0, 1);
  scene.velocities = {{0, 0, 0, 0}, {-0.17f, 0, 0, 0}, {0.17f, 0, 0, 0}};
  const int step = first_failed_step(scene);
  EXPECT_GT(step, 1000);
  expect_fault(scene, step, fmt::format("step {} of 5e-06 s: sphere 0 is deeper in sphere 1 than", step));
}

// As short ones, of a sphere in another group of threads than the first.
TEST_P(ContactFaults, ADeepWallOnTheWay) {
  std::vector<vec4> spheres(300, {0, 1, 0, 0.001f});
  for (size_t i = 0; i < spheres.size(); ++i) spheres[i].x = 0.01f * float(i);
  spheres.back().y = 0.002f;
  Scene scene = with_contacts(spheres, 2e-5f, -9.81f, 0.1f);
  scene.velocities.back().y = -0.1f;
  const int step = first_failed_step(scene);
  EXPECT_GT(step, 500);
  expect_fault(scene, step, fmt::format("step {} of 2e-05 s: sphere 299 is deeper in a wall than", step));
}

INSTANTIATE_BACKENDS(ContactFaults);

}  // namespace
}  // namespace spherepair
