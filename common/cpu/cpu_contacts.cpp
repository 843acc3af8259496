// SPDX-License-Identifier: MIT
#include "common/cpu/cpu_contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "common/scene/contact_scene.h"
#include "common/shared/skin.h"

namespace spherepair {
namespace {

constexpr uint64_t few = 4096;  // spheres or pairs for which threads cost more than they save

void add(int64_t& sum, int64_t value) { std::atomic_ref(sum).fetch_add(value, std::memory_order_relaxed); }

}  // namespace

void CpuContacts::upload(const Scene& scene) {
  params_ = contact_params(scene);
  impulses_.assign(on() ? 3 * scene.size() : 0, 0);
  faults_.assign(FAULTS, ~0u);
  left_skin_ = true;
  if (!on()) return;
  const Scene grown = grown_scene(scene);
  grown_ = grown.positions;
  search_.upload(grown);
}

void CpuContacts::list_near_pairs(const std::vector<vec4>& positions) {
#pragma omp parallel for num_threads(threads_) schedule(static) if (positions.size() > few)
  for (uint64_t i = 0; i < positions.size(); ++i) {
    if (is_too_far(positions[i], params_)) record(FAULT_RANGE, i);
    grown_[i] = grown_sphere(positions[i], params_);
  }
  near_ = search_.list_pairs(grown_);
  left_skin_ = false;
}

// The lowest index is kept, whichever thread comes first.
void CpuContacts::record(uint fault, uint64_t sphere) {
  if (fault == FAULTS) return;
  std::atomic_ref kept(faults_[fault]);
  uint first = kept.load();
  while (uint(sphere) < first && !kept.compare_exchange_weak(first, uint(sphere))) {
  }
}

void CpuContacts::push(const std::vector<uint>& wide, const std::vector<vec4>& positions) {
  const uint64_t n = positions.size();
#pragma omp parallel for num_threads(threads_) schedule(static) if (near_.size() > few)
  for (const Pair& pair : near_) {
    const Push push =
        push_of_pair(load_body(wide, positions, pair.first), load_body(wide, positions, pair.second), params_);
    record(push.fault, pair.first);
    const int64_t values[3] = {push.x, push.y, push.z};
    for (uint64_t axis = 0; axis < 3; ++axis) {
      if (values[axis] == 0) continue;
      add(impulses_[axis * n + pair.first], values[axis]);
      add(impulses_[axis * n + pair.second], -values[axis]);
    }
  }
}

void CpuContacts::step(std::vector<uint>& wide, std::vector<vec4>& positions, std::vector<vec4>& velocities) {
  const uint64_t n = positions.size();
  search_.moved();
  if (left_skin_ || !keeps_) list_near_pairs(positions);
  push(wide, positions);
  bool left = false;
#pragma omp parallel for num_threads(threads_) schedule(static) reduction(|| : left) if (n > few)
  for (uint64_t i = 0; i < n; ++i) {
    Body s = load_body(wide, positions, i);
    const Push walls = push_of_walls(s, params_);
    record(walls.fault, i);
    int64_t* sums[3] = {&impulses_[i], &impulses_[n + i], &impulses_[2 * n + i]};
    s = kicked(s, {*sums[0], *sums[1], *sums[2], FAULTS}, walls, params_);
    for (int64_t* sum : sums) *sum = 0;
    const float mobility = mobility_of(s.radius, params_);
    const uint wrong = fault_of(s, mobility, params_);
    record(wrong, i);
    if (wrong != FAULTS) continue;
    s = drifted(s, mobility);
    store_body(wide, n, i, s);
    positions[i] = centre_of(s, params_);
    velocities[i] = velocity_of(s, mobility, params_);
    left = left || has_left_skin(positions[i], grown_[i]);
  }
  left_skin_ = left;
}

void CpuContacts::require_sound() const {
  const std::string faults = describe_faults(faults_);
  if (!faults.empty()) throw std::invalid_argument(fmt::format("cpu: {}", faults));
}

}  // namespace spherepair
