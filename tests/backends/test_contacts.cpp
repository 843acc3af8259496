// SPDX-License-Identifier: MIT
// Contacts that push: one trajectory from every backend, schedule and input order, and back to the first bits.
#include <fmt/format.h>

#include "bench/check/contact_statistics.h"
#include "common/scene/contact_scene.h"
#include "tests/support/motion_runs.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

class Contacts : public BackendTest {};
class ContactsInKernels : public KernelTest {};

constexpr ContactLaw LAWS[] = {ContactLaw::spring, ContactLaw::quartic, ContactLaw::hertz};

std::vector<uint> after(Backend& backend, const Scene& scene, uint64_t steps) {
  return run_steps(backend, scene, steps).wide;
}

// Every law, unequal radii, gravity, walls (tested near them or everywhere), a damper.
TEST_P(Contacts, SameBitsAsOnTheCpu) {
  for (const ContactLaw law : LAWS)
    for (const float ratio : {1.0f, 8.0f}) {
      Scene scene = gas({.ratio = ratio, .gravity = -9.81f, .law = law});
      scene.restitution = law == ContactLaw::spring && ratio > 1 ? 0.7f : 1.0f;
      const Motion::State start = run_steps(cpu_backend(), scene, 0), wanted = run_steps(cpu_backend(), scene, 400);
      ASSERT_GT(cpu_backend().state().wide, std::vector<uint>{});
      ASSERT_NE(start.wide, wanted.wide);
      for (const bool tests_all_walls : {false, true}) {
        scene.contact.tests_all_walls = tests_all_walls;
        expect_equal_states(run_steps(backend(), scene, 400), wanted,
                            fmt::format("{} 1:{}, all walls {}", contact_name(law), ratio, tests_all_walls));
        backend().check_guards();
      }
    }
}

// All pairs by their integers, without a search: what a list of near pairs must not lose.
std::vector<uint> after_all_pairs(const Scene& scene, uint64_t steps) {
  const ContactParams c = contact_params(scene);
  const uint64_t n = scene.size();
  std::vector<uint> wide = fixed_state(scene);
  for (uint64_t step = 0; step < steps; ++step) {
    std::vector<Push> sums(n, Push{0, 0, 0, FAULTS});
    for (uint64_t i = 0; i < n; ++i)
      for (uint64_t j = 0; j < i; ++j) {
        const Push push = push_of_pair(load_body(wide, scene.positions, i), load_body(wide, scene.positions, j), c);
        sums[i].x += push.x, sums[i].y += push.y, sums[i].z += push.z;
        sums[j].x -= push.x, sums[j].y -= push.y, sums[j].z -= push.z;
      }
    for (uint64_t i = 0; i < n; ++i) {
      const Body s = load_body(wide, scene.positions, i);
      const Body faster = kicked(s, sums[i], push_of_walls(s, false, c), c);
      const float mobility = mobility_of(s.radius, c);
      store_body(wide, n, i, drifted(faster, speeds_of(faster, mobility), mobility, c));
    }
  }
  return wide;
}

// Far from the origin, too, where the search's float32 centres are coarser than the overlaps.
TEST_P(ContactsInKernels, NoPairOfTheIntegersIsLost) {
  for (const ContactLaw law : LAWS)
    for (const float far : {0.0f, 3000.0f, 100'000.0f}) {
      const float ratio = law == ContactLaw::hertz || far == 3000 ? 4 : 1;
      const Scene scene = gas({.side = 4, .ratio = ratio, .law = law, .from = far, .steps_a_contact = 12});
      EXPECT_EQ(after(backend(), scene, 500), after_all_pairs(scene, 500))
          << contact_name(law) << " 1:" << ratio << ", " << far << " m from the origin";
    }
}

// A list serves many steps and changes no bit; where it is not kept, each step lists its pairs.
TEST_P(Contacts, NearPairsAreListedSeldom) {
  const Scene scene = gas({.side = 4, .ratio = 4, .law = ContactLaw::spring, .steps_a_contact = 12});
  expect_near_pairs_listed_seldom(backend(), scene);
}

// What happens in between changes nothing: searches by any method and group size, questions. The kernels of contacts
// and the search of near pairs have one group size.
TEST_P(ContactsInKernels, UndisturbedBySearches) {
  const Scene scene = gas({.side = 5});
  const int steps = by_form(backend(), 120, 45);
  const Motion::State wanted = run_steps(cpu_backend(), scene, uint64_t(steps));
  constexpr uint ENDS[] = {32, 1024};
  const std::span<const uint> blocks = full_stress() ? block_sizes() : std::span(ENDS).first(by_form(backend(), 2, 1));
  for (CollideOptions options : every_method(backend(), blocks)) {
    for (const bool listed : {true, false}) {
      options.want_pairs = listed;
      backend().upload(scene);
      for (int step = 0; step < steps; ++step) {
        if (step % 3 != 0) backend().collide(options);
        backend().move();
      }
      expect_equal_states(current_state(backend()), wanted, describe(options));
    }
  }
}

TEST_P(ContactsInKernels, PermutedInputGivesThePermutedState) {
  const Scene scene = gas({.ratio = 4, .gravity = -9.81f, .law = ContactLaw::spring});
  const std::vector<uint> order = shuffled(scene.size());
  EXPECT_EQ(after(backend(), in_order(scene, order), 200), in_order(after(backend(), scene, 200), order));
}

// An elastic gas goes back to its first positions; where one contact is lost once, it does not.
TEST_P(ContactsInKernels, ReversesToTheFirstBits) {
  for (const ContactLaw law : LAWS) {
    const Scene scene = gas({.side = 5, .ratio = 2, .law = law});
    const uint64_t steps = is_gpu(backend()) ? 20'000 : 800, n = scene.size();
    const std::vector<uint> start = after(backend(), scene, 0), back = there_and_back(backend(), scene, steps, false);
    const std::vector<uint> first(start.begin(), start.begin() + 6 * n);
    EXPECT_EQ(std::vector<uint>(back.begin(), back.begin() + 6 * n), first) << contact_name(law);
    const std::vector<uint> other = there_and_back(backend(), scene, steps, true);
    EXPECT_NE(std::vector<uint>(other.begin(), other.begin() + 6 * n), first) << contact_name(law);
  }
}

TEST_P(ContactsInKernels, EnergyStaysWithinATenthOfAPercent) {
  const Scene scene = gas({.side = 5, .ratio = 2});
  double first = 0;
  uint64_t contacts = 0;
  backend().upload(scene);
  for (int round = 0; round < 12; ++round) {
    for (int step = 0; step < 100; ++step) backend().move();
    backend().collide({.want_pairs = true});
    const ContactStatistics now = contact_statistics(scene, current_state(backend()).wide, backend().pairs(), 0);
    contacts += now.contacts + now.wall_contacts;
    if (round == 0) first = now.energy();
    EXPECT_NEAR(now.energy() / first, 1, 1e-3) << "round " << round;
  }
  EXPECT_GT(contacts, 100u);
}

// Without walls and gravity the integer sum of all momenta is that of the start, with radii 1:8.
TEST_P(ContactsInKernels, MomentumIsConservedToTheLastUnit) {
  for (const ContactLaw law : LAWS) {
    const Scene scene = shells(law);
    const uint64_t n = scene.size();
    const auto sum = [&](const std::vector<uint>& wide, uint64_t part) {
      int64_t total = 0;
      for (uint64_t i = 0; i < n; ++i) total += word(wide, part * n + i);
      return total;
    };
    const std::vector<uint> start = after(backend(), scene, 0), end = after(backend(), scene, 2000);
    uint64_t changed = 0;
    for (uint64_t k = 3 * n; k < 6 * n; ++k) changed += word(start, k) != word(end, k);
    EXPECT_GT(changed, n) << contact_name(law);
    for (uint64_t part = 3; part < 6; ++part) EXPECT_EQ(sum(end, part), sum(start, part)) << contact_name(law);
  }
}

TEST_P(Contacts, SavedAndResumedHereAndOnTheCpu) {
  const Scene scene = gas({.ratio = 2, .gravity = -9.81f, .law = ContactLaw::hertz});
  const Motion::State wanted = run_steps(cpu_backend(), scene, 300), middle = run_steps(backend(), scene, 150);
  const MotionState saved = backend().save();
  for (Backend* other : {&backend(), &cpu_backend()}) {
    other->resume(with(scene, middle), saved);
    for (int step = 150; step < 300; ++step) other->move();
    expect_equal_states(current_state(*other), wanted, other->info().name);
  }
}

INSTANTIATE_BACKENDS(Contacts);
INSTANTIATE_BACKENDS(ContactsInKernels);

}  // namespace
}  // namespace spherepair
