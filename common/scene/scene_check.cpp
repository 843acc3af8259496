// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "common/scene/contact_scene.h"
#include "common/scene/counted.h"
#include "common/shared/hash.h"

namespace spherepair {
namespace {

constexpr uint64_t hash_block = 1 << 20;  // hashes of smaller states keep their recorded value: one chain

constexpr const char* dt_bounds = "dt is {} s, but must be from 2^-60 to 2^20";
bool is_time_step(float dt) { return dt >= shortest_step && dt <= longest_step; }

}  // namespace

void check_options(const SceneOptions& o) {
  const auto refuse = [](const std::string& why) { throw std::invalid_argument(why); };
  if (o.n > 0x7FFFFFFF) refuse(fmt::format("n is {}, but sphere indices allow 2147483647 at most", o.n));
  if (!(o.radius > 0) || !std::isfinite(o.radius))
    refuse(fmt::format("radius is {}, but must be positive and finite", o.radius));
  if (!(o.radius_ratio >= 1) || !std::isfinite(o.radius_ratio)) {
    refuse(fmt::format("radius ratio is {}, but must be at least 1 (largest over smallest radius)", o.radius_ratio));
  }
  if (!std::isfinite(o.radius * o.radius_ratio))
    refuse(fmt::format("radius {} times radius ratio {} must be finite", o.radius, o.radius_ratio));
  if (!(o.packing_fraction >= 1e-15 && o.packing_fraction <= 0.74))
    refuse(fmt::format("packing fraction is {}, but must be from 1e-15 to 0.74", o.packing_fraction));
  if (!is_time_step(o.dt)) refuse(fmt::format(dt_bounds, o.dt));
  if (!(o.restitution >= 0 && o.restitution <= 1))
    refuse(fmt::format("restitution is {}, but must be from 0 to 1", o.restitution));
  if (!std::isfinite(o.offset)) refuse(fmt::format("offset is {}, but must be finite", o.offset));
  if ((o.groups == 0) != (o.group_size == 0)) refuse("groups and group size go together: give both or neither");
  if (o.groups && uint64_t(o.groups) * o.group_size != o.n) {
    const uint64_t spheres = uint64_t(o.groups) * o.group_size;
    refuse(fmt::format("{} of {} make {}, but n is {}: give --n {}", counted(o.groups, "group"), o.group_size,
                       counted(spheres, "sphere"), o.n, spheres));
  }
}

namespace {

std::string describe(const vec4& p, const vec4& v) {
  return fmt::format("centre ({}, {}, {}), radius {}, velocity ({}, {}, {})", p.x, p.y, p.z, p.w, v.x, v.y, v.z);
}

}  // namespace

std::string unsound_spheres(const std::vector<vec4>& positions, const std::vector<vec4>& velocities) {
  const uint64_t n = positions.size();
  const auto finite = [](const vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
  };
  uint64_t bad = 0, first = n;
#pragma omp parallel for schedule(static) reduction(+ : bad) reduction(min : first) if (n > many_spheres)
  for (uint64_t i = 0; i < n; ++i)
    if (!finite(positions[i]) || !finite(velocities[i]) || positions[i].w < 0) ++bad, first = std::min(first, i);
  if (bad == 0) return "";
  return fmt::format("{} of {} {} a NaN, an infinity or a negative radius; the first is sphere {}: {}", bad,
                     counted(n, "sphere"), bad == 1 ? "has" : "have", first,
                     describe(positions[first], velocities[first]));
}

void check_scene(const Scene& scene) {
  if (scene.positions.size() != scene.velocities.size())
    throw std::invalid_argument(fmt::format("scene '{}' has {} positions but {} velocities", scene.name,
                                            scene.positions.size(), scene.velocities.size()));
  const std::string unsound = unsound_spheres(scene.positions, scene.velocities);
  if (!unsound.empty())
    throw std::invalid_argument(fmt::format("scene '{}': {}; remove or mend them", scene.name, unsound));
}

std::string why_unmovable(const Scene& scene, Origin origin) {
  const auto why = [&](const std::string& text) {
    return fmt::format("scene '{}' cannot be moved: {}", scene.name, text);
  };
  if (!is_time_step(scene.dt)) return why(fmt::format(dt_bounds, scene.dt));
  if (!(scene.restitution >= 0 && scene.restitution <= 1))
    return why(fmt::format("the restitution is {}, but must be from 0 to 1", scene.restitution));
  if (!(scene.gravity <= 0 && scene.gravity >= -largest_number))
    return why(fmt::format("gravity is {}, but must be from -2^60 to 0, not upwards", scene.gravity));
  if (!(std::abs(scene.plane) <= largest_number))
    return why(fmt::format("the plane is at {}, but must be from -2^60 to 2^60", scene.plane));
  if (scene.contact.law != ContactLaw::none)
    if (const std::string no_contacts = why_no_contacts(scene, origin); !no_contacts.empty()) return why(no_contacts);
  if (origin == Origin::resumed) return "";
  const auto large = [](const vec4& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z), std::abs(v.w)}) > largest_number;
  };
  uint64_t first = scene.size();
#pragma omp parallel for schedule(static) reduction(min : first) if (scene.size() > many_spheres)
  for (uint64_t i = 0; i < scene.size(); ++i)
    if (large(scene.positions[i]) || large(scene.velocities[i])) first = std::min(first, i);
  if (first == scene.size()) return "";
  return why(fmt::format("numbers up to 2^60 can be, but sphere {} has a larger one: {}", first,
                         describe(scene.positions[first], scene.velocities[first])));
}

uint64_t stalled_spheres(const Scene& scene) {
  if (scene.motion.precision != Precision::float32 || scene.motion.method == MotionMethod::anchored) return 0;
  uint64_t stalled = 0;
  const auto lost = [&](float x, float v) { return v != 0 && x + v * scene.dt == x; };
  const float gained = scene.gravity * scene.dt;  // moves a sphere that is about to turn
  for (uint64_t i = 0; i < scene.size(); ++i) {
    const vec4 &at = scene.positions[i], &v = scene.velocities[i];
    stalled += lost(at.x, v.x) || (lost(at.y, v.y) && lost(at.y, v.y + gained)) || lost(at.z, v.z);
  }
  return stalled;
}

namespace {

uint64_t hash_of(std::span<const vec4> values, uint64_t sum) {
  for (const vec4& v : values) {
    sum = splitmix64(sum ^ (uint64_t(float_bits(v.x)) << 32 | float_bits(v.y)));
    sum = murmur64(sum ^ (uint64_t(float_bits(v.z)) << 32 | float_bits(v.w)));
  }
  return sum;
}

// Hashes blocks in chains of their own, which another chain joins: one long chain could not be shared by threads.
uint64_t hash_by_blocks(std::span<const vec4> values, uint64_t sum) {
  if (values.size() <= hash_block) return hash_of(values, sum);
  std::vector<uint64_t> sums((values.size() + hash_block - 1) / hash_block);
#pragma omp parallel for schedule(dynamic, 1)
  for (uint64_t b = 0; b < sums.size(); ++b)
    sums[b] = hash_of(values.subspan(b * hash_block, std::min(hash_block, values.size() - b * hash_block)), b);
  for (uint64_t block : sums) sum = splitmix64(sum ^ block);
  return sum;
}

}  // namespace

uint64_t state_hash(const std::vector<vec4>& positions, const std::vector<vec4>& velocities,
                    const std::vector<uint>& wide) {
  uint64_t sum = hash_by_blocks(velocities, hash_by_blocks(positions, positions.size()));
  for (uint word : wide) sum = splitmix64(sum ^ word);
  return sum;
}

}  // namespace spherepair
