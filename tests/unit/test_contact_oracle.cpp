// SPDX-License-Identifier: MIT
// Contacts with the default stiffness and time step, compared with the equations of motion.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/scene/contact_scene.h"
#include "tests/oracle/world_of_scene.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

constexpr ContactLaw laws[] = {ContactLaw::spring, ContactLaw::quartic, ContactLaw::hertz};

// A sphere that comes at 1 m/s to a larger one at rest, or to the plane, `late` steps before it touches. Radii are odd,
// so that none is a short float32.
struct Approach {
  ContactLaw law = ContactLaw::spring;
  float ratio = 1, restitution = 1;
  bool plane = false;
  double late = 0.3;
  float stiffer = 1, radius = 0.517f, speed = 1;
};

Scene approaching(const Approach& a) {
  const float r = a.radius, large = r * a.ratio;
  Scene scene = {.name = "approach", .plane = a.plane ? 0.0f : -8 * large, .gravity = 0, .restitution = a.restitution};
  scene.equal_radii = a.ratio == 1;
  if (a.plane)
    scene.positions = {{0, r, 0, r}}, scene.velocities = {{0, -a.speed, 0, 0}};
  else
    scene.positions = {{0, 0, 0, large}, {large + r, 0, 0, r}}, scene.velocities = {{}, {-a.speed, 0, 0, 0}};
  choose_contacts(scene, {.law = a.law});
  if (a.stiffer != 1) choose_contacts(scene, {.law = a.law, .stiffness = a.stiffer * scene.contact.stiffness});
  const double gap = (2 + a.late) * double(scene.dt) * double(a.speed);
  (a.plane ? scene.positions[0].y : scene.positions[1].x) += float(gap);
  return scene;
}

// How fast both part, of the speed at which they met.
double rebound(const Approach& a) {
  const Scene scene = approaching(a);
  EXPECT_EQ(why_no_contacts(scene), "");
  const double reach = a.plane ? double(a.radius) : double(a.radius) * (1 + double(a.ratio));
  cpu_backend().upload(scene);
  for (int turn = 0; turn < 200; ++turn) {
    for (int step = 0; step < 40; ++step) cpu_backend().move();
    const Motion::State s = current_state(cpu_backend());
    const auto &x = s.positions, &v = s.velocities;
    const double apart = a.plane ? double(x[0].y) : double(x[1].x) - double(x[0].x);
    const double speed = a.plane ? double(v[0].y) : double(v[1].x) - double(v[0].x);
    if (apart > reach && speed > 0) return speed / double(a.speed);
  }
  ADD_FAILURE() << "they stay together";
  return 0;
}

TEST(ContactOracle, ElasticSpheresReboundWithinAThousandth) {
  for (const ContactLaw law : laws)
    for (const float ratio : {1.0f, 1.3f, 3.0f, 17.0f, 64.0f, 199.0f, 256.0f})
      for (int k = 0; k < 6; ++k)
        for (const bool plane : {false, true}) {
          const double late = (k + 0.37) / 6;
          if (!plane || ratio == 1) {
            EXPECT_NEAR(rebound({.law = law, .ratio = ratio, .plane = plane, .late = late}), 1, 1e-3)
                << contact_name(law) << " 1:" << ratio << (plane ? ", plane" : "") << ", late " << late;
          }
        }
}

// As stiff as is accepted, and where the fastest sphere is as slow as counts.
TEST(ContactOracle, StiffAndSlowSpheresReboundAsWell) {
  for (const ContactLaw law : laws)
    for (const float ratio : {1.0f, 17.0f, 256.0f}) {
      for (const float speed : {1e-4f, 3e-2f, 30.0f})
        EXPECT_NEAR(rebound({.law = law, .ratio = ratio, .speed = speed}), 1, 1e-3)
            << contact_name(law) << " 1:" << ratio << ", " << speed << " m/s";
      float stiffer = 1;
      while (why_no_contacts(approaching({.law = law, .ratio = ratio, .stiffer = 1.3f * stiffer})).empty())
        stiffer *= 1.3f;
      EXPECT_GT(stiffer, 2) << contact_name(law) << " 1:" << ratio;
      for (const float speed : {0.997f, 0.999f, 1.0f})  // float32 centres are too coarse for phases of a step
        EXPECT_NEAR(rebound({.law = law, .ratio = ratio, .stiffer = stiffer, .speed = speed}), 1, 1e-3)
            << contact_name(law) << " 1:" << ratio << ", stiffer by " << stiffer;
    }
}

TEST(ContactOracle, RestitutionIsWithinTwoPercent) {
  for (const float restitution : {0.1f, 0.113f, 0.1353f, 0.14f, 0.29f, 0.5f, 0.53f, 0.77f, 0.95f, 0.999f})
    for (const float ratio : {1.0f, 7.3f, 256.0f})
      for (const double late : {0.01, 0.3, 0.55, 0.99})
        for (const bool plane : {false, true})
          if (!plane || ratio == 1) {
            const double asked = double(restitution);
            const Approach approach = {.ratio = ratio, .restitution = restitution, .plane = plane, .late = late};
            EXPECT_NEAR(rebound(approach), asked, 0.02 * asked)
                << restitution << " 1:" << ratio << (plane ? ", plane" : "") << ", late " << late;
          }
}

}  // namespace
}  // namespace spherepair
