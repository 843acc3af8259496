// SPDX-License-Identifier: MIT
#include "common/cpu/cpu_contacts.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

template <typename Number>
void add(Number& sum, Number value) {
  std::atomic_ref(sum).fetch_add(value, std::memory_order_relaxed);
}

}  // namespace

void CpuContacts::upload(const Scene& scene) {
  params_ = contact_params(scene);
  may_sleep_ = may_sleep(scene);
  tests_all_walls_ = scene.contact.tests_all_walls;
  rest_.assign(may_sleep_ ? scene.size() : 0, REST_MOVED);
  impulses_.assign(on() ? 3 * scene.size() : 0, 0);
  float_sums_.assign(impulses_.size(), 0);
  failed_ = {.faults = std::vector<uint>(FAULTS, ~0u), .bodies = {}};
  left_skin_ = true;
  if (!on()) return;
  const Scene grown = grown_scene(scene);
  grown_ = grown.positions;
  search_.upload(grown);
}

void CpuContacts::sum_impulses(ImpulseSums sums) {
  if (std::exchange(sums_, sums) != sums) left_skin_ = true;  // sums in order need rows
}

void CpuContacts::list_near_pairs(const std::vector<vec4>& positions) {
#pragma omp parallel for num_threads(threads_) schedule(static) if (positions.size() > many_moves)
  for (uint64_t i = 0; i < positions.size(); ++i) {
    if (is_too_far(positions[i], params_)) record(FAULT_RANGE, i);
    grown_[i] = grown_sphere(positions[i], params_);
  }
  near_ = search_.list_pairs(grown_);
  std::ranges::fill(rest_, REST_MOVED);
  if (sums_ == ImpulseSums::in_order) list_rows(positions.size());
  left_skin_ = false;
}

// Lists each sphere's near spheres in ascending order. Pairs i < j ascend by i, then by j. So a row first takes the
// near spheres below its own, then those above.
void CpuContacts::list_rows(uint64_t n) {
  row_begin_.assign(n + 1, 0);
  for (const Pair& pair : near_) ++row_begin_[pair.first + 1], ++row_begin_[pair.second + 1];
  std::partial_sum(row_begin_.begin(), row_begin_.end(), row_begin_.begin());
  row_.resize(2 * near_.size());
  std::vector<uint64_t> end(row_begin_.begin(), row_begin_.end() - 1);
  for (const Pair& pair : near_) row_[end[pair.second]++] = pair.first;
  for (const Pair& pair : near_) row_[end[pair.first]++] = pair.second;
}

// Keeps the lowest sphere index of each fault, so that the order of threads does not matter.
void CpuContacts::record(uint fault, uint64_t sphere) {
  if (fault == FAULTS) return;
  std::atomic_ref kept(failed_.faults[fault]);
  uint first = kept.load();
  while (uint(sphere) < first && !kept.compare_exchange_weak(first, uint(sphere))) {
  }
}

// Sums float32 impulses in the order of rows, as the kernel contact_gather does.
void CpuContacts::gather(const std::vector<uint>& wide, const std::vector<vec4>& positions) {
  const uint64_t n = positions.size();
#pragma omp parallel for num_threads(threads_) schedule(static) if (n > many_moves)
  for (uint64_t i = 0; i < n; ++i) {
    FloatPush sum = {0, 0, 0, FAULTS};
    const Body a = load_body(wide, positions, i);
    for (uint64_t k = row_begin_[i]; k < row_begin_[i + 1]; ++k) {
      if (is_apart(positions[i], positions[row_[k]])) continue;
      sum = sum_of_pushes(sum, float_push_of_pair(a, load_body(wide, positions, row_[k]), params_));
    }
    record(sum.fault, i);
    const Push rounded = rounded_push(sum);
    impulses_[i] = rounded.x, impulses_[n + i] = rounded.y, impulses_[2 * n + i] = rounded.z;
  }
}

void CpuContacts::awaken() {
  for (const Pair& pair : near_) {
    uint &first = rest_[pair.first], &second = rest_[pair.second];
    if (first == REST_MOVED && second == REST_SAME) second = REST_AWAKENED;
    if (second == REST_MOVED && first == REST_SAME) first = REST_AWAKENED;
  }
}

void CpuContacts::push(const std::vector<uint>& wide, const std::vector<vec4>& positions) {
  const uint64_t n = positions.size();
  const bool floats = sums_ == ImpulseSums::atomics;
#pragma omp parallel for num_threads(threads_) schedule(static) if (near_.size() > many_moves)
  for (const Pair& pair : near_) {
    const bool rests[2] = {is_at_rest(pair.first), is_at_rest(pair.second)};
    if (rests[0] && rests[1]) continue;
    if (is_apart(positions[pair.first], positions[pair.second])) continue;
    const FloatPush push =
        float_push_of_pair(load_body(wide, positions, pair.first), load_body(wide, positions, pair.second), params_);
    record(push.fault, pair.first);
    const float values[3] = {push.x, push.y, push.z};
    for (uint64_t axis = 0; axis < 3; ++axis) {
      const uint64_t first = axis * n + pair.first, second = axis * n + pair.second;
      if (values[axis] == 0) continue;
      if (floats) {
        add(float_sums_[first], values[axis]);
        add(float_sums_[second], -values[axis]);
      } else {
        const int64_t value = integer_of(values[axis]);
        if (!rests[0]) add(impulses_[first], value);
        if (!rests[1]) add(impulses_[second], -value);
      }
    }
  }
}

// Returns a sphere's sum along an axis and sets it to 0 for the next step.
int64_t CpuContacts::take_impulse(uint64_t k) {
  if (sums_ == ImpulseSums::atomics) return integer_of(std::exchange(float_sums_[k], 0.0f));
  return std::exchange(impulses_[k], 0);
}

void CpuContacts::step(std::vector<uint>& wide, std::vector<vec4>& positions, std::vector<vec4>& velocities) {
  if (has_faults(failed_.faults)) return;
  const uint64_t n = positions.size();
  search_.moved();
  if (left_skin_ || !keeps_) list_near_pairs(positions);
  if (sums_ == ImpulseSums::in_order)
    gather(wide, positions);
  else {
    if (sleeps()) awaken();
    push(wide, positions);
  }
  bool left = false;
#pragma omp parallel for num_threads(threads_) schedule(static) reduction(|| : left) if (n > many_moves)
  for (uint64_t i = 0; i < n; ++i) {
    if (is_at_rest(i)) continue;
    const Body before = load_body(wide, positions, i);
    Body s = before;
    const Push walls = push_of_walls(s, tests_all_walls_, params_);
    record(walls.fault, i);
    s = kicked_in_fluid(s, {take_impulse(i), take_impulse(n + i), take_impulse(2 * n + i), FAULTS}, walls, params_);
    const float mobility = mobility_of(s.radius, params_);
    const vec4 speeds = speeds_of(s, mobility);
    const uint wrong = fault_of(s, speeds, params_);
    record(wrong, i);
    if (wrong == FAULTS) s = drifted(s, speeds, mobility, params_);
    store_body(wide, n, i, s);
    positions[i] = centre_of(s, params_);
    velocities[i] = velocity_of(speeds, params_);
    if (sleeps()) rest_[i] = is_same(s, before) ? REST_SAME : REST_MOVED;
    left = left || has_left_skin(positions[i], grown_[i]);
  }
  left_skin_ = left;
  ++failed_.number;
  if (has_faults(failed_.faults)) failed_.bodies = bodies_of(wide, positions);
}

void CpuContacts::require_sound() const {
  if (has_faults(failed_.faults)) throw_fault("cpu", failed_, params_);
}

}  // namespace spherepair
