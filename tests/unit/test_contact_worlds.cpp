// SPDX-License-Identifier: MIT
// Several spheres that touch at once, with gravity and walls, moved by the program and by the equations of motion.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/check/contact_statistics.h"
#include "common/scene/contact_scene.h"
#include "tests/oracle/world_of_scene.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

constexpr ContactLaw laws[] = {ContactLaw::spring, ContactLaw::quartic, ContactLaw::hertz};

Scene of(std::vector<vec4> positions, std::vector<vec4> velocities, float plane = -40, float gravity = 0) {
  return {.name = "world",
          .positions = std::move(positions),
          .velocities = std::move(velocities),
          .plane = plane,
          .gravity = gravity,
          .equal_radii = false};
}

struct World {
  const char* name;
  Scene scene;
  double contacts;  // that the run lasts
  bool walls = false;
};

std::vector<World> worlds() {
  const float r = 0.517f;
  return {
      {"oblique", of({{0, 0, 0, r}, {0.9f, 0.8f, 0.31f, 0.71f}}, {{1.3f, 0.4f, 0, 0}, {-0.7f, 0, -0.3f, 0}}), 12},
      {"chain",
       of({{0, 0, 0, r}, {1.05f, 0, 0.01f, r}, {2.3f, 0.02f, 0, 0.71f}, {3.4f, 0, 0, 0.37f}},
          {{1, 0, 0, 0}, {}, {}, {}}),
       80},
      {"cradle",
       of({{-0.01f, 0, 0, r}, {2 * r, 0, 0, r}, {4 * r, 0, 0, r}, {6 * r, 0, 0, r}}, {{1, 0, 0, 0}, {}, {}, {}}), 12},
      {"triangle",
       of({{0.62f, 0, 0, r}, {-0.31f, 0.53f, 0.01f, 0.5f}, {-0.33f, -0.54f, 0, 0.55f}},
          {{-1, 0.1f, 0, 0}, {0.5f, -0.9f, 0, 0}, {0.5f, 0.8f, 0.1f, 0}}),
       12},
      {"corner",
       of({{1.02f, 1.03f, 1.01f, r}, {2.15f, 1.3f, 1.6f, 0.61f}}, {{-1, -1.3f, -0.9f, 0}, {-1.2f, 0.2f, 0, 0}}, 0.45f,
          -9.81f),
       60, true},
      {"pile",
       of({{0, 0.53f, 0, r}, {0.02f, 1.75f, 0.01f, 0.7f}, {-0.4f, 2.8f, 0, 0.4f}},
          {{}, {0, -3, 0, 0}, {0.1f, -4, 0, 0}}, 0, -9.81f),
       15},
  };
}

// drag: over one contact.
Scene chosen(World world, ContactLaw law, double finer, double drag = 0) {
  choose_contacts(world.scene, {.law = law, .walls = world.walls});
  choose_contacts(world.scene, {.law = law,
                                .stiffness = world.scene.contact.stiffness,
                                .dt = float(double(world.scene.dt) / finer),
                                .drag = float(drag / contact_time(world.scene)),
                                .walls = world.walls});
  return world.scene;
}

// Greatest difference of two positions, in the way of the fastest sphere.
double error_of(const World& world, ContactLaw law, double finer, double drag = 0) {
  const Scene scene = chosen(world, law, finer, drag);
  const auto steps = uint64_t(world.contacts * contact_time(scene) / double(scene.dt));
  OracleWorld moved = world_of(scene);
  advance(moved, seconds_of(scene, steps), static_cast<Real>(scene.dt));
  const Motion::State found = run_steps(cpu_backend(), scene, steps);
  double error = 0, fastest = 0;
  for (size_t i = 0; i < scene.positions.size(); ++i) {
    const Body body = load_body(found.wide, found.positions, i);
    const int64_t at[3] = {body.x, body.y, body.z};
    for (size_t k = 0; k < 3; ++k)
      error = std::max(
          error, std::abs(std::ldexp(double(at[k]), -scene.contact.unit_exponent) - double(moved.spheres[i].at[k])));
    const vec4& v = scene.velocities[i];
    fastest = std::max(fastest, std::hypot(double(v.x), double(v.y), double(v.z)));
  }
  return error / (fastest * double(seconds_of(scene, steps)));
}

TEST(ContactOracle, ManyContactsAtOnceFollowTheEquationsOfMotion) {
  for (const ContactLaw law : laws)
    for (World world : worlds())
      for (const float restitution : {1.0f, 0.6f, 0.1f}) {
        if (restitution < 1 && law != ContactLaw::spring) continue;
        world.scene.restitution = restitution;
        const double bound = restitution < 1 ? 4e-3 : 6e-4;
        SCOPED_TRACE(fmt::format("{}, {}, restitution {}", contact_name(law), world.name, restitution));
        EXPECT_LT(error_of(world, law, 1), bound);
        EXPECT_LT(error_of(world, law, 4), bound / (restitution < 1 ? 2.5 : 10));
      }
}

// A drag that takes 1/e in ten contacts to 1/e^3 in one, at most 0.1 a step.
TEST(ContactOracle, DragFollowsTheEquationsOfMotion) {
  for (const ContactLaw law : laws)
    for (const World& world : worlds())
      for (const double drag : {0.1, 0.7, 3.0}) {
        SCOPED_TRACE(fmt::format("{}, {}, drag {}", contact_name(law), world.name, drag));
        EXPECT_LT(error_of(world, law, 1, drag), 1e-3);
        EXPECT_LT(error_of(world, law, 4, drag), 1e-4);
      }
}

std::vector<double> columns(const ContactStatistics& s) {
  return {s.kinetic,     s.contact,     s.potential,   s.virial,           s.floor_force,          s.greatest_overlap,
          s.momentum[0], s.momentum[1], s.momentum[2], double(s.contacts), double(s.wall_contacts)};
}
std::vector<double> columns(const OracleStatistics& s) {
  return {double(s.kinetic),     double(s.contact),          double(s.potential),    double(s.virial),
          double(s.floor_force), double(s.greatest_overlap), double(s.momentum[0]),  double(s.momentum[1]),
          double(s.momentum[2]), double(s.contacts),         double(s.wall_contacts)};
}
constexpr const char* names[] = {"kinetic",    "contact",    "potential",  "virial",   "floor force",  "overlap",
                                 "momentum x", "momentum y", "momentum z", "contacts", "wall contacts"};

TEST(ContactOracle, EachColumnOfStatisticsIsThatOfTheEquationsOfMotion) {
  for (const ContactLaw law : laws)
    for (World world : worlds())
      for (const float restitution : {1.0f, 0.6f}) {
        if (restitution < 1 && law != ContactLaw::spring) continue;
        world.scene.restitution = restitution;
        const Scene scene = chosen(world, law, restitution < 1 ? 16 : 4);
        const auto steps = uint64_t(world.contacts * contact_time(scene) / double(scene.dt) / 60);
        OracleWorld moved = world_of(scene);
        cpu_backend().upload(scene);
        std::vector<std::vector<double>> found, wanted;
        for (int row = 0; row < 60; ++row) {
          for (uint64_t step = 0; step < steps; ++step) cpu_backend().move();
          advance(moved, seconds_of(scene, steps), static_cast<Real>(scene.dt));
          cpu_backend().collide({.method = Method::parallel, .want_pairs = true});
          found.push_back(
              columns(contact_statistics(scene, current_state(cpu_backend()).wide, cpu_backend().pairs(), 0)));
          wanted.push_back(columns(statistics_of(moved)));
        }
        SCOPED_TRACE(fmt::format("{}, {}, restitution {}", contact_name(law), world.name, restitution));
        for (size_t c = 0; c < std::size(names); ++c) {
          double greatest = 1e-9, error = 0;
          int differ = 0;
          for (size_t row = 0; row < found.size(); ++row) {
            greatest = std::max(greatest, std::abs(wanted[row][c]));
            error = std::max(error, std::abs(found[row][c] - wanted[row][c]));
            differ += found[row][c] != wanted[row][c];
          }
          const bool counts = c >= 9;  // a contact may begin or end between a row of the one and of the other
          if (counts) {
            EXPECT_LE(differ, 2) << names[c];
          } else {
            EXPECT_LT(error, (restitution < 1 ? 0.04 : 0.002) * greatest) << names[c];
          }
        }
      }
}

}  // namespace
}  // namespace spherepair
