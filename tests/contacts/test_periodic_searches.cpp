// SPDX-License-Identifier: MIT
// Pairs in periodic boxes against rational numbers; the pressure of a gas without walls; boxes that are refused.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/check/contact_statistics.h"
#include "bench/check/gas.h"
#include "tests/contacts/periodic_gas.h"
#include "tests/oracle/list_oracle.h"
#include "tests/support/sphere_files.h"

namespace spherepair {
namespace {

class PeriodicSearches : public BackendTest {};

// The pairs of spheres i < j, whatever the image, by rational numbers.
std::vector<Pair> pairs_by_rationals(const Scene& scene, const std::vector<vec4>& positions) {
  const WallBox box = *box_of(scene);
  ListProblem problem;
  ListBox rows;
  for (uint axis = 0; axis < 3; ++axis) {
    rows.rows[axis][axis] = double(box.high[axis]) - double(box.low[axis]);
    rows.periodic[axis] = (box.periodic >> axis & 1) != 0;
  }
  problem.boxes = {rows};
  problem.half = true;
  problem.set.offsets = {0, positions.size()};
  for (const vec4& s : positions) {
    problem.set.points.push_back({double(s.x), double(s.y), double(s.z)});
    problem.set.radii.push_back(double(s.w));
  }
  std::vector<Pair> pairs;
  for (const ListedPair& pair : list_by_rationals(problem, 2))
    pairs.push_back({std::min(pair.first, pair.second), std::max(pair.first, pair.second)});
  std::ranges::sort(pairs);
  return pairs;
}

void expect_pairs_of(Backend& backend, const Scene& scene, const std::vector<Pair>& wanted, const std::string& where) {
  std::vector<uint> counts(scene.size());
  for (const Pair& pair : wanted) ++counts[pair.first], ++counts[pair.second];
  for (const Method method : {Method::automatic, Method::collide_grid}) {
    backend.collide({.method = method, .want_pairs = true});
    EXPECT_EQ(backend.pairs(), wanted) << where;
    EXPECT_EQ(backend.counts(), counts) << where;
    EXPECT_EQ(backend.collisions().pairs, wanted.size()) << where;
    EXPECT_EQ(backend.collisions().fingerprint, fingerprint(wanted)) << where;
    EXPECT_EQ(backend.collisions().colliding_spheres, std::ranges::count_if(counts, colliding)) << where;
  }
  backend.collide({.method = Method::automatic});
  EXPECT_EQ(backend.collisions().pairs, wanted.size()) << where;
}

TEST_P(PeriodicSearches, PairsAcrossFacesAreFound) {
  uint64_t found = 0, inside = 0;
  for (const uint axes : AXES) {
    const Scene scene = periodic_gas(axes, {.side = 4, .law = ContactLaw::spring, .steps_a_contact = 12});
    const Motion::State state = run_steps(cpu_backend(), scene, 900);
    backend().upload(with(scene, state));
    const std::vector<Pair> wanted = pairs_by_rationals(scene, state.positions);
    Scene open = scene;
    open.contact.periodic = 0;
    found += wanted.size(), inside += pairs_by_rationals(open, state.positions).size();
    expect_pairs_of(backend(), scene, wanted, axes_text(axes));
  }
  EXPECT_GT(found, inside + 10);
}

// Spheres on a lattice whose box is as long as whole spheres touch all six neighbours, which is no pair. Then some are
// larger by the last bit, in a box whose corners have other exponents than the centres.
TEST_P(PeriodicSearches, TiesAcrossFacesAreDecidedExactly) {
  for (const float from : {0.0f, -1.25f, 0x1p-12f}) {
    Scene scene{.name = "lattice", .plane = -100, .gravity = 0};
    for (uint k = 0; k < 64; ++k) {
      const auto along = [&](uint cell) { return from + 0.5f * float(cell); };
      scene.positions.push_back({along(k % 4), along(k / 4 % 4), along(k / 16), 0.25f});
    }
    scene.velocities.resize(64, vec4{0.125f, 0, 0, 0});
    WallBox box{{from, from, from}, {from + 2, from + 2, from + 2}, 7};
    for (const bool larger : {false, true}) {
      if (larger)
        for (uint k = 0; k < 64; k += 5) scene.positions[k].w = std::nextafter(0.25f, 1.0f);
      scene.equal_radii = !larger;
      choose_contacts(scene, {.law = ContactLaw::spring, .box = box});
      ASSERT_EQ(why_no_contacts(scene), "");
      backend().upload(scene);
      const std::vector<Pair> wanted = pairs_by_rationals(scene, scene.positions);
      EXPECT_EQ(wanted.empty(), !larger) << from;
      expect_pairs_of(backend(), scene, wanted, fmt::format("from {}", from));
    }
  }
}

TEST_P(PeriodicSearches, OtherSearchesAreRefused) {
  const Scene scene = periodic_gas(7, {.side = 3});
  backend().upload(scene);
  for (const CollideOptions& options :
       {CollideOptions{.method = Method::collide_group}, CollideOptions{.method = Method::automatic, .exact = false},
        CollideOptions{.method = Method::automatic, .swept = true}})
    EXPECT_THROW(backend().collide(options), std::invalid_argument);
}

INSTANTIATE_BACKENDS(PeriodicSearches);

// Without walls the pressure is (2 K + virial) / 3 V, and the density that of all spheres. Carnahan and Starling's
// equation is of hard spheres. Soft ones press a little less.
TEST(PeriodicGas, HasThePressureOfCarnahanAndStarling) {
  const uint64_t n = by_form(2744, 1000);
  for (const double fraction : {0.1, 0.3}) {
    Scene scene = make_scene({.name = "gas", .n = n, .packing_fraction = fraction});
    choose_contacts(scene, {.law = ContactLaw::spring, .periodic = 7});
    choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = scene.contact.stiffness / 4});
    const double length = double(scene.contact.high.x) - double(scene.contact.low.x), volume = std::pow(length, 3);
    const double radius = double(scene.positions[0].w);
    const double density = double(n) * 4 / 3 * std::numbers::pi * std::pow(radius, 3) / volume;
    Backend& cpu = cpu_backend();
    cpu.upload(scene);
    for (int step = 0; step < by_form(6000, 3000); ++step) cpu.move();
    double both = 0, kinetic = 0;
    const int samples = by_form(60, 30);
    for (int sample = 0; sample < samples; ++sample) {
      for (int step = 0; step < 60; ++step) cpu.move();
      cpu.collide({.want_pairs = true});
      const ContactStatistics now = contact_statistics(scene, current_state(cpu).wide, cpu.pairs(), 0);
      EXPECT_EQ(now.wall_contacts, 0);
      both += 2 * now.kinetic + now.virial, kinetic += now.kinetic;
    }
    const double found = both / (2 * kinetic);  // p V / N k T
    fmt::print("packing fraction {:.4f}: compressibility {:.4f}, expected {:.4f}\n", density, found,
               compressibility(density));
    EXPECT_NEAR(found / compressibility(density), 1, 0.04) << density;
  }
}

TEST(PeriodicChecks, NameWhatIsWrong) {
  const auto why = [](const WallBox& box, float gravity, float x) {
    Scene scene{
        .name = "one", .positions = {{x, 1, 1, 0.25f}, {1, 1, 1, 0.25f}}, .velocities = {{}, {}}, .gravity = gravity};
    try {
      choose_contacts(scene, {.law = ContactLaw::spring, .box = box});
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return why_no_contacts(scene);
  };
  const auto expect = [&](const std::string& found, const std::string& words) {
    EXPECT_NE(found.find(words), std::string::npos) << found;
  };
  EXPECT_EQ(why({{0, 0, 0}, {2, 2, 2}, 7}, 0, 0), "");
  EXPECT_EQ(why({{0, 0, 0}, {2, 2, 2}, 5}, -9.81f, 0), "");
  expect(why({{0, 0, 0}, {2, 2, 2}, 7}, -9.81f, 0), "periodic along y, where gravity is -9.81");
  expect(why({{0, 0, 0}, {2, 2, 1.05f}, 7}, 0, 0), "1.05 m along z, but must be longer than 1.0625 m");
  EXPECT_EQ(why({{0, 0, 0}, {2, 2, 1.05f}, 3}, 0, 0), "");
  expect(why({{0, 0, 0}, {2, -1, 2}, 7}, 0, 0), "give the lower corner first");
  Scene empty{.name = "none", .gravity = 0};
  choose_contacts(empty, {.law = ContactLaw::spring, .walls = true, .periodic = 7});
  choose_contacts(empty, {.law = ContactLaw::spring, .box = WallBox{{0, 0, 0}, {2, 2, 2}, 7}});
  EXPECT_EQ(why_no_contacts(empty), "");
}

// Also those on the upper face, where float32 may have rounded them to, and far outside. Others stay as they are.
TEST(PeriodicChecks, CentresAreWrapped) {
  Scene scene{.name = "four", .gravity = 0};
  scene.positions = {{-2, 1, 0, 0.25f}, {2, 1, 0, 0.25f}, {-3, 100, -2.5f, 0.25f}, {0.1f, 0.5f, 2.5f, 0.25f}};
  scene.velocities.resize(4);
  const ContactChoice choice{.law = ContactLaw::spring, .box = WallBox{{-2, -1, -2}, {2, 1, 2}, 5}};
  Scene once = scene;
  EXPECT_EQ(wrap_centres(once, *choice.box), 3u);
  choose_contacts(scene, choice);
  const vec4 wanted[] = {{-2, 1, 0, 0.25f}, {-2, 1, 0, 0.25f}, {1, 100, 1.5f, 0.25f}, {0.1f, 0.5f, -1.5f, 0.25f}};
  for (size_t i = 0; i < 4; ++i)
    EXPECT_TRUE(scene.positions[i].x == wanted[i].x && scene.positions[i].y == wanted[i].y &&
                scene.positions[i].z == wanted[i].z)
        << i;
  EXPECT_EQ(wrap_centres(scene, *choice.box), 0u);
}

// A sphere flies along an open axis until float32 is too coarse for its skin. The run ends alike whether a search comes
// between the steps or not.
TEST(PeriodicChecks, ARunThatEndsEndsAlikeWithSearches) {
  Scene scene{.name = "far", .plane = -1, .gravity = 0, .dt = 0.02f};
  scene.positions = {{5, 5, 870, 0.05f}, {5, 5, 1, 0.05f}};
  scene.velocities = {{0, 0, 1.3f, 0}, {}};
  choose_contacts(
      scene, {.law = ContactLaw::spring, .stiffness = 800, .dt = 0.02f, .box = WallBox{{0, 0, 0}, {10, 10, 100}, 1}});
  ASSERT_EQ(why_no_contacts(scene), "");
  const auto end = [&](bool searches) {
    return complaint_of([&] {
      cpu_backend().upload(scene);
      for (int step = 0; step < 170'000; ++step) {
        if (searches && step > 167'000) cpu_backend().collide({});
        cpu_backend().move();
      }
      current_state(cpu_backend());
    });
  };
  const std::string without = end(false);
  EXPECT_NE(without.find("has left the range"), std::string::npos) << without;
  EXPECT_EQ(end(true), without);
}

}  // namespace
}  // namespace spherepair
