// SPDX-License-Identifier: MIT
// Contacts against what kinetic theory knows of a gas of hard spheres, its pressure and how it cools; and a bed that
// comes to rest. Short runs; with STRESS=full on a GPU as many spheres as make walls and fluctuations small.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "bench/check/contact_statistics.h"
#include "bench/check/gas.h"
#include "bench/check/step_result.h"
#include "common/scene/contact_scene.h"
#include "tests/support/motion_runs.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

class ContactPhysics : public KernelTest {
 protected:
  // The other software renderer has the CPU's bits (Contacts), at a twentieth of its speed.
  void SetUp() override {
    KernelTest::SetUp();
    if (IsSkipped()) return;
    if (backend().info().software) GTEST_SKIP() << "the same bits as the CPU's";
  }
};

bool in_full(const Backend& backend) { return is_gpu(backend) && full_stress(); }

// At rest with its walls; a full lattice. Contacts last eight times as long as by their own stiffness.
Gas gas_at_rest(Backend& backend, double packing_fraction) {
  const uint64_t n = in_full(backend) ? 47 * 47 * 47 : 1000;
  Scene scene = make_scene({.name = "gas", .n = n, .packing_fraction = packing_fraction});
  squeeze(scene);
  choose_contacts(scene, {.law = ContactLaw::spring});
  choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = scene.contact.stiffness / 64});
  return equilibrated_gas(backend, scene, in_full(backend) ? 20 : 6);
}

// Contacts last half as long.
Gas stiffer(Backend& backend, Gas gas) {
  choose_contacts(gas.scene, {.law = ContactLaw::spring, .stiffness = 4 * gas.scene.contact.stiffness});
  return equilibrated_gas(backend, gas.scene, 2);
}

// Spheres that are not hard come closer than that, and press less: the stiffer, the more like hard ones.
TEST_P(ContactPhysics, PressureIsThatOfCarnahanAndStarling) {
  const bool full = in_full(backend());
  for (const double fraction : full ? std::vector{0.1, 0.3, 0.45} : std::vector{0.3}) {
    Gas gas = gas_at_rest(backend(), fraction);
    const double rest = fraction_at_rest(gas.scene);
    std::vector<double> deviations, errors;
    for (int times = 0; times < (full ? 4 : 3); ++times) {
      if (times > 0) gas = stiffer(backend(), gas);
      const Pressure pressure = measure_pressure(backend(), gas, 120, 100);
      deviations.push_back(pressure.found / expected_pressure(rest) - 1), errors.push_back(pressure.error);
      fmt::print(
          "{}, stiffness {:.3g} N/m, packing fraction {:.4f} at rest, found {:.4f}: pressure {:+.2f} +- {:.2f} %\n",
          backend().info().name, gas.scene.contact.stiffness, rest, pressure.packing_fraction, 100 * deviations.back(),
          100 * errors.back());
    }
    EXPECT_NEAR(deviations.back(), 0, full ? 0.02 : 0.05) << "packing fraction " << rest;
    EXPECT_TRUE(std::ranges::is_sorted(deviations)) << "packing fraction " << rest;
    EXPECT_GT(std::abs(deviations.front()) - std::abs(deviations.back()), 3 * std::hypot(errors.front(), errors.back()))
        << "packing fraction " << rest;
  }
}

// By Enskog's rate at the packing fraction at rest. Two things that it leaves out about make up for each other: the
// walls take energy, too, 5 % of it in the full form, and velocities become correlated, the more, the denser the gas.
TEST_P(ContactPhysics, CoolsByHaffsLaw) {
  const bool full = in_full(backend());
  const Gas start = stiffer(backend(), gas_at_rest(backend(), full ? 0.1 : 0.25));
  const double rest = fraction_at_rest(start.scene), most = full ? 5 : 2;
  for (const float restitution : full ? std::vector{0.95f, 0.9f, 0.8f} : std::vector{0.8f}) {
    Gas gas = start;
    gas.scene.restitution = restitution;
    const double kinetic = double(gas.scene.size()) * gas.mass / 2;  // as the lattice had: a third each axis
    const double seconds = most * expected_tau(gas, rest, kinetic);
    constexpr uint64_t samples = 100;
    const Cooling cooling =
        measure_cooling(backend(), gas, samples, uint64_t(std::ceil(seconds / double(gas.scene.dt) / samples)));
    const double times = cooling.seconds / expected_tau(gas, rest, cooling.first);
    double low = 0, high = 0, last = 0;
    for (uint64_t k = 0; k < samples; ++k) {
      last = cooling.energies[k] / cooling.first * std::pow(1 + times * double(k + 1) / samples, 2) - 1;
      low = std::min(low, last), high = std::max(high, last);
    }
    fmt::print("{}, restitution {}, packing fraction {:.4f} at rest, then {:.4f}: ", backend().info().name, restitution,
               rest, cooling.packing_fraction);
    fmt::print("{:+.2f} to {:+.2f} % off Haff's law until t = {:.2f} tau, then {:+.2f} %\n", 100 * low, 100 * high,
               times, 100 * last);
    EXPECT_GE(times, most);
    EXPECT_TRUE(-0.05 < low && high < 0.05) << restitution;
  }
}

struct Bed {
  uint64_t n, layers;  // 0 layers: as high as wide
  float stiffness, restitution;
  std::vector<std::pair<double, uint64_t>> stages;  // drag a step, steps
  double moving;                                    // energy in motion that may be left, of that at the start
  double overlap = 0.025;                           // greatest, in metres
  bool bulk = false;                                // whether some of it is far from walls, and spheres overlap little
};

// The scene bed, in a box as wide as so many layers need.
Scene bed_of(const Bed& bed) {
  Scene scene = make_scene({.name = "bed", .n = bed.n});
  if (!bed.layers) return scene;
  const float gap = 2.2f * scene.positions[0].w;
  const uint64_t side = uint64_t(std::lround(double(scene.contact.high.x / gap)));
  const uint64_t wide = uint64_t(std::ceil(std::sqrt(double(bed.n) / double(bed.layers))));
  const auto moved = [&](uint64_t from, uint64_t to) { return gap * (float(to) - float(from)); };
  for (uint64_t i = 0; i < bed.n; ++i) {
    scene.positions[i].x += moved(i % side, i % wide);
    scene.positions[i].z += moved(i / side % side, i / wide % wide);
    scene.positions[i].y += moved(i / side / side, i / wide / wide);
  }
  scene.contact.high = {gap * float(wide), gap * float(bed.layers + 1), gap * float(wide), 0};
  return scene;
}

// Share of the points of a lattice that lie in a sphere: three diameters from walls and floor, and two from the height
// below which nine of ten centres are.
double packing_fraction_of_bulk(const Scene& scene, std::vector<vec4> spheres) {
  const auto higher = [](const vec4& a, const vec4& b) { return a.y < b.y; };
  const auto top = spheres.begin() + long(spheres.size() * 9 / 10);
  std::nth_element(spheres.begin(), top, spheres.end(), higher);
  const double diameter = 2 * double(top->w), step = diameter / 16;
  const std::array low = {double(scene.contact.low.x) + 3 * diameter, double(scene.plane) + 3 * diameter,
                          double(scene.contact.low.z) + 3 * diameter};
  const std::array high = {double(scene.contact.high.x) - 3 * diameter, double(top->y) - 2 * diameter,
                           double(scene.contact.high.z) - 3 * diameter};
  uint64_t within = 0, points = 0;
  for (double y = low[1]; y < high[1]; y += step) {
    std::vector<vec4> near;
    std::ranges::copy_if(spheres, std::back_inserter(near),
                         [&](const vec4& s) { return std::abs(double(s.y) - y) < double(s.w); });
    for (double z = low[2]; z < high[2]; z += step)
      for (double x = low[0]; x < high[0]; x += step, ++points)
        within += std::ranges::any_of(near, [&](const vec4& s) {
          return std::hypot(x - double(s.x), y - double(s.y), z - double(s.z)) < double(s.w);
        });
  }
  return double(within) / double(points);
}

// Without friction and drag single spheres roll on between walls, at which alone they lose speed, and large beds
// rearrange themselves for a long time: 2,000 spheres for 60 s. Drag makes an end of it.
TEST_P(ContactPhysics, ABedComesToRest) {
  const std::vector<Bed> beds =
      in_full(backend()) ? std::vector<Bed>{{200, 0, 3e6f, 0.3f, {{0, 300'000}}, 1e-12},
                                            {2000, 0, 1e7f, 0.3f, {{0, 200'000}}, 1e-10, 0.025, true},
                                            {100'000, 10, 1e6f, 0.3f, {{0.001, 400'000}, {0.1, 1000}}, 1e-12, 0.15}}
                         : std::vector<Bed>{{200, 0, 3e6f, 0.3f, {{0, 60'000}}, 1e-10},
                                            {200, 0, 3e6f, 0.3f, {{0.003, 30'000}, {0.1, 1000}}, 1e-12}};
  for (const Bed& bed : beds) {
    SCOPED_TRACE(bed.n);
    Scene scene = bed_of(bed);
    const float any = bed.stages.front().first > 0 ? 1.0f : 0.0f;
    scene.restitution = 1;
    choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = bed.stiffness});
    scene.restitution = bed.restitution;  // 40 steps a contact without the damper
    choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = bed.stiffness, .dt = scene.dt, .drag = any});
    backend().upload(scene);
    const auto statistics = [&] {
      backend().collide({.want_pairs = true});
      return contact_statistics(scene, current_state(backend()).wide, backend().pairs(), 0);
    };
    const ContactStatistics start = statistics();
    for (const auto& [drag, steps] : bed.stages) {
      scene = with(scene, current_state(backend()));
      const MotionState saved = backend().save();
      scene.contact.drag = float(drag / double(scene.dt));
      backend().resume(scene, saved);
      for (uint64_t step = 0; step < steps; ++step) backend().move();
    }
    const ContactStatistics end = statistics();
    double weight = 0;
    for (const vec4& p : scene.positions) weight -= sphere_mass(double(p.w)) * double(scene.gravity);
    fmt::print(
        "{}: {:.1e} J of {:.1e} J are left in motion, greatest overlap {:.4f} m, force on the floor {:.9f} of "
        "the weight\n",
        backend().info().name, end.kinetic, start.energy(), end.greatest_overlap, end.floor_force / weight);
    EXPECT_LT(end.kinetic, bed.moving * start.energy());
    EXPECT_NEAR(end.floor_force / weight, 1, 1e-6);
    EXPECT_LT(end.greatest_overlap, bed.overlap);
    if (bed.bulk) {
      const double fraction = packing_fraction_of_bulk(scene, backend().state().positions);
      fmt::print("packing fraction {:.4f} in the bulk\n", fraction);
      EXPECT_TRUE(0.63 < fraction && fraction < 0.65) << fraction << ", not that of spheres packed at random";
    }
    const vec4 low = scene.contact.low, high = scene.contact.high;
    for (const vec4& p : backend().state().positions) {
      const float within = p.w - float(bed.overlap);
      EXPECT_TRUE(p.x > low.x + within && p.x < high.x - within && p.z > low.z + within && p.z < high.z - within &&
                  p.y > scene.plane + within)
          << p.x << ' ' << p.y << ' ' << p.z;
    }
  }
}

INSTANTIATE_BACKENDS(ContactPhysics);

}  // namespace
}  // namespace spherepair
