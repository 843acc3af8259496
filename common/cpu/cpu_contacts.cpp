// SPDX-License-Identifier: MIT
#include "common/cpu/cpu_contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

constexpr uint64_t few = 4096;  // spheres or pairs for which threads cost more than they save

void add(int64_t& sum, int64_t value) { std::atomic_ref(sum).fetch_add(value, std::memory_order_relaxed); }

}  // namespace

void CpuContacts::upload(const Scene& scene) {
  params_ = contact_params(scene);
  impulses_.assign(on() ? 3 * scene.size() : 0, 0);
  faults_.assign(FAULTS, ~0u);
}

// The lowest index is kept, whichever thread comes first.
void CpuContacts::record(uint fault, uint64_t sphere) {
  if (fault == FAULTS) return;
  std::atomic_ref kept(faults_[fault]);
  uint first = kept.load();
  while (uint(sphere) < first && !kept.compare_exchange_weak(first, uint(sphere))) {
  }
}

void CpuContacts::push(std::span<const Pair> pairs, const std::vector<uint>& wide, const std::vector<vec4>& positions,
                       int threads) {
  const uint64_t n = positions.size();
#pragma omp parallel for num_threads(threads) schedule(static) if (pairs.size() > few)
  for (const Pair& pair : pairs) {
    const Push push =
        push_of_pair(load_body(wide, positions, pair.first), load_body(wide, positions, pair.second), params_);
    record(push.fault, pair.first);
    const int64_t values[3] = {push.x, push.y, push.z};
    for (uint64_t axis = 0; axis < 3; ++axis) {
      add(impulses_[axis * n + pair.first], values[axis]);
      add(impulses_[axis * n + pair.second], -values[axis]);
    }
  }
}

void CpuContacts::step(std::span<const Pair> pairs, std::vector<uint>& wide, std::vector<vec4>& positions,
                       std::vector<vec4>& velocities, int threads) {
  push(pairs, wide, positions, threads);
  const uint64_t n = positions.size();
#pragma omp parallel for num_threads(threads) schedule(static) if (n > few)
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
  }
}

void CpuContacts::require_sound() const {
  const std::string faults = describe_faults(faults_);
  if (!faults.empty()) throw std::invalid_argument(fmt::format("cpu: {}", faults));
}

}  // namespace spherepair
