// SPDX-License-Identifier: MIT
#include "common/cpu/cpu_contacts.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

void add(int64_t& sum, int64_t value) { std::atomic_ref(sum).fetch_add(value, std::memory_order_relaxed); }

}  // namespace

void CpuContacts::upload(const Scene& scene) {
  params_ = contact_params(scene);
  may_sleep_ = may_sleep(scene);
  tests_all_walls_ = scene.contact.tests_all_walls;
  rest_.assign(may_sleep_ ? scene.size() : 0, REST_MOVED);
  impulses_.assign(on() ? 3 * scene.size() : 0, 0);
  failed_ = {.faults = std::vector<uint>(FAULTS, ~0u), .bodies = {}};
  left_skin_ = true;
  if (!on()) return;
  const Scene grown = grown_scene(scene);
  grown_ = grown.positions;
  search_.upload(grown);
}

// Adds the images of a periodic box to the grown spheres; returns the sphere of each.
std::vector<uint> CpuContacts::add_images(const std::vector<uint>& wide, const std::vector<vec4>& positions) {
  std::vector<uint> image_of_sphere;
  grown_.resize(positions.size());
  if (!periodic()) return image_of_sphere;
  for (uint64_t i = 0; i < positions.size(); ++i) {
    const uint faces = image_faces(grown_[i], params_);
    for (uint image = FIRST_IMAGE; image < END_OF_IMAGES && faces; ++image) {
      if (!image_is_needed(image, faces)) continue;
      grown_.push_back(sphere_of_image(load_body(wide, positions, i), image, grown_[i].w, params_));
      image_of_sphere.push_back(uint(i));
    }
  }
  return image_of_sphere;
}

const std::vector<Pair>& CpuContacts::near_pairs(const std::vector<uint>& wide, const std::vector<vec4>& positions) {
  search_.moved();
  const std::vector<uint> faults = failed_.faults;
  list_near_pairs(wide, positions);
  left_skin_ = failed_.faults != faults;  // the next step lists them again, and fails
  failed_.faults = faults;
  return near_;
}

void CpuContacts::list_near_pairs(const std::vector<uint>& wide, const std::vector<vec4>& positions) {
#pragma omp parallel for num_threads(threads_) schedule(static) if (positions.size() > many_moves)
  for (uint64_t i = 0; i < positions.size(); ++i) {
    if (is_too_far(positions[i], params_)) record(FAULT_RANGE, i);
    grown_[i] = grown_sphere(positions[i], params_);
  }
  const std::vector<uint> sphere_of = add_images(wide, positions);
  near_ = search_.list_pairs(grown_);
  const uint n = uint(positions.size());
  std::erase_if(near_, [n](const Pair& pair) { return pair.first >= n; });  // of two images
  for (Pair& pair : near_)
    if (pair.second >= n) pair = {pair.first, sphere_of[pair.second - n]};
  std::ranges::fill(rest_, REST_MOVED);
  left_skin_ = false;
}

// Keeps the lowest sphere index of each fault, so that the order of threads does not matter.
void CpuContacts::record(uint fault, uint64_t sphere) {
  if (fault == FAULTS) return;
  std::atomic_ref kept(failed_.faults[fault]);
  uint first = kept.load();
  while (uint(sphere) < first && !kept.compare_exchange_weak(first, uint(sphere))) {
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
#pragma omp parallel for num_threads(threads_) schedule(static) if (near_.size() > many_moves)
  for (const Pair& pair : near_) {
    const bool rests[2] = {is_at_rest(pair.first), is_at_rest(pair.second)};
    if (rests[0] && rests[1]) continue;
    if (is_apart(positions[pair.first], positions[pair.second], params_)) continue;
    const FloatPush push =
        float_push_of_pair(load_body(wide, positions, pair.first), load_body(wide, positions, pair.second), params_);
    record(push.fault, std::min(pair.first, pair.second));
    const float values[3] = {push.x, push.y, push.z};
    for (uint64_t axis = 0; axis < 3; ++axis) {
      const uint64_t first = axis * n + pair.first, second = axis * n + pair.second;
      if (values[axis] == 0) continue;
      const int64_t value = integer_of(values[axis]);
      if (!rests[0]) add(impulses_[first], value);
      if (!rests[1]) add(impulses_[second], -value);
    }
  }
}

void CpuContacts::step(std::vector<uint>& wide, std::vector<vec4>& positions, std::vector<vec4>& velocities) {
  if (has_faults(failed_.faults)) return;
  const uint64_t n = positions.size();
  search_.moved();
  if (left_skin_ || !keeps_) list_near_pairs(wide, positions);
  if (may_sleep_) awaken();
  push(wide, positions);
  bool left = false;
#pragma omp parallel for num_threads(threads_) schedule(static) reduction(|| : left) if (n > many_moves)
  for (uint64_t i = 0; i < n; ++i) {
    if (is_at_rest(i)) continue;
    const Body before = load_body(wide, positions, i);
    Body s = before;
    const Push walls = push_of_walls(s, tests_all_walls_, params_);
    record(walls.fault, i);
    const auto take = [&](uint64_t k) { return std::exchange(impulses_[k], 0); };  // 0 for the next step
    s = kicked_in_fluid(s, {take(i), take(n + i), take(2 * n + i), FAULTS}, walls, params_);
    const float mobility = mobility_of(s.radius, params_);
    const vec4 speeds = speeds_of(s, mobility);
    const uint wrong = fault_of(s, speeds, params_);
    record(wrong, i);
    if (wrong == FAULTS) s = drifted(s, speeds, mobility, params_);
    store_body(wide, n, i, s);
    positions[i] = centre_of(s, params_);
    velocities[i] = velocity_of(speeds, params_);
    if (may_sleep_) rest_[i] = is_same(s, before) ? REST_SAME : REST_MOVED;
    left = left || has_left_skin(positions[i], grown_[i], params_);
  }
  left_skin_ = left;
  ++failed_.number;
  if (has_faults(failed_.faults)) failed_.bodies = bodies_of(wide, positions);
}

void CpuContacts::require_sound() const {
  if (has_faults(failed_.faults)) throw_fault("cpu", failed_, params_);
}

}  // namespace spherepair
