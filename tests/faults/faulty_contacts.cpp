// SPDX-License-Identifier: MIT
#include "tests/faults/faulty_contacts.h"

#include "common/scene/contact_scene.h"
#include "common/shared/contact/contact_rest.h"

namespace spherepair {
namespace {

class Step {
 public:
  Step(const Scene& scene, const Motion::State& before, Motion::State after)
      : params_(contact_params(scene)), before_(before), after_(std::move(after)), n_(before.positions.size()) {}

  Motion::State state() { return std::move(after_); }
  bool is_same_as(const Motion::State& earlier, uint64_t i) const {
    return !earlier.positions.empty() && is_same(load_body(earlier.wide, earlier.positions, i), body(before_, i));
  }

  void lose_a_pair() {
    for (uint64_t i = 0; i < n_; ++i)
      for (uint64_t j = 0; j < i; ++j) {
        const Push push = push_of_pair(body(before_, i), body(before_, j), params_);
        if (push.x == 0 && push.y == 0 && push.z == 0) continue;
        take(i, push.x, push.y, push.z);
        return take(j, -push.x, -push.y, -push.z);
      }
  }
  void move_what_rests(const Motion::State& earlier) {
    for (uint64_t i = 0; i < n_; ++i)
      if (is_same_as(earlier, i) && is_same(body(before_, i), body(after_, i)))
        return take(i, -integer_of(2 / mobility_of(before_.positions[i].w, params_)), 0, 0);
  }
  void keep_what_rests(const Motion::State& earlier) {
    for (uint64_t i = 0; i < n_; ++i)
      if (is_same_as(earlier, i)) store(i, body(before_, i));
  }
  void slow() {
    for (uint64_t i = 0; i < n_; ++i) go_on(i, slowed(body(after_, i), params_));
  }

 private:
  static Body body(const Motion::State& state, uint64_t i) { return load_body(state.wide, state.positions, i); }

  // The sphere without this part of its momentum.
  void take(uint64_t i, int64_t x, int64_t y, int64_t z) {
    Body s = body(after_, i);
    s.px -= x, s.py -= y, s.pz -= z;
    go_on(i, s);
  }
  // From where it was, by these momenta.
  void go_on(uint64_t i, Body s) {
    const Body start = body(before_, i);
    s.x = start.x, s.y = start.y, s.z = start.z;
    const float mobility = mobility_of(s.radius, params_);
    store(i, drifted(s, speeds_of(s, mobility), mobility, params_));
  }
  void store(uint64_t i, const Body& s) {
    store_body(after_.wide, n_, i, s);
    after_.positions[i] = centre_of(s, params_);
    after_.velocities[i] = velocity_of(speeds_of(s, mobility_of(s.radius, params_)), params_);
  }

  const ContactParams params_;
  const Motion::State& before_;
  Motion::State after_;
  uint64_t n_;
};

}  // namespace

bool spoils_steps(Fault fault) {
  return fault == Fault::lost_near_pair || fault == Fault::moves_at_rest || fault == Fault::stays_at_rest ||
         fault == Fault::drag_once_more;
}

Motion::State spoiled_step(Fault fault, const Scene& scene, const Motion::State& earlier, const Motion::State& before,
                           const Motion::State& after, bool first_list) {
  Step step(scene, before, after);
  if (fault == Fault::lost_near_pair && !first_list) step.lose_a_pair();
  if (fault == Fault::moves_at_rest) step.move_what_rests(earlier);
  if (fault == Fault::stays_at_rest) step.keep_what_rests(earlier);
  if (fault == Fault::drag_once_more) step.slow();
  return step.state();
}

MotionState spoiled_start(Fault fault, const Scene& scene, MotionState saved) {
  if (fault != Fault::old_momenta) return saved;
  const std::vector<uint> made = fixed_state(scene);
  for (uint64_t k = 3 * scene.size(); k < 6 * scene.size(); ++k) store_real(saved.wide, k, load_real<int64_t>(made, k));
  return saved;
}

}  // namespace spherepair
