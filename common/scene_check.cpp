// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "hash.h"
#include "scene.h"

namespace spherepair {
namespace {

constexpr uint64_t many = 1 << 16;        // spheres from which on several threads share the work
constexpr uint64_t hash_block = 1 << 20;  // recorded hashes of smaller states are those of a single chain

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
  if (!(o.dt > 0) || !std::isfinite(o.dt)) refuse(fmt::format("dt is {} s, but must be positive and finite", o.dt));
  if (!(o.restitution >= 0 && o.restitution <= 1))
    refuse(fmt::format("restitution is {}, but must be from 0 to 1", o.restitution));
  if (!std::isfinite(o.offset)) refuse(fmt::format("offset is {}, but must be finite", o.offset));
  if ((o.groups == 0) != (o.group_size == 0)) refuse("groups and group size go together: give both or neither");
  if (o.groups && uint64_t(o.groups) * o.group_size != o.n) {
    refuse(fmt::format("{} groups of {} are {} spheres, but n is {}", o.groups, o.group_size,
                       uint64_t(o.groups) * o.group_size, o.n));
  }
}

namespace {

// Squares of speeds must stay within the floats, and a time of impact needs gravity that pulls towards the plane.
void check_motion(const Scene& scene) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(
        fmt::format("scene '{}': the motion method {} {}", scene.name, motion_name(scene.motion.method), why));
  };
  if (!(scene.dt > 0) || !std::isfinite(scene.dt)) refuse(fmt::format("needs a time step above 0, not {}", scene.dt));
  if (!(scene.restitution >= 0 && scene.restitution <= 1))
    refuse(fmt::format("needs a restitution from 0 to 1, not {}", scene.restitution));
  if (!(scene.gravity <= 0)) refuse(fmt::format("needs gravity that is not upwards, not {}", scene.gravity));
  const auto large = [](const vec4& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) > 0x1p60f || std::abs(v.w) > 0x1p60f;
  };
  for (uint64_t i = 0; i < scene.size(); ++i)
    if (large(scene.positions[i]) || large(scene.velocities[i]))
      refuse(fmt::format("takes numbers up to 2^60, but sphere {} has a larger one", i));
}

}  // namespace

void check_scene(const Scene& scene) {
  uint64_t bad = 0, first = scene.size();
  const auto wrong = [&](uint64_t i) {
    const vec4 &p = scene.positions[i], &v = scene.velocities[i];
    const bool finite = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w) &&
                        std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    return !finite || p.w < 0;
  };
  if (scene.positions.size() != scene.velocities.size()) {
    throw std::invalid_argument(fmt::format("scene '{}' has {} positions but {} velocities", scene.name,
                                            scene.positions.size(), scene.velocities.size()));
  }
#pragma omp parallel for schedule(static) reduction(+ : bad) reduction(min : first) if (scene.size() > many)
  for (uint64_t i = 0; i < scene.size(); ++i) {
    if (wrong(i)) ++bad, first = std::min(first, i);
  }
  if (bad == 0) {
    if (scene.motion.method != MotionMethod::paper || scene.motion.precision != Precision::float32) check_motion(scene);
    return;
  }
  const vec4 &p = scene.positions[first], &v = scene.velocities[first];
  throw std::invalid_argument(
      fmt::format("scene '{}': {} of {} spheres have a NaN, an infinity or a negative radius; the first is sphere {}: "
                  "centre ({}, {}, {}), radius {}, velocity ({}, {}, {}); remove or mend them",
                  scene.name, bad, scene.size(), first, p.x, p.y, p.z, p.w, v.x, v.y, v.z));
}

uint64_t stalled_spheres(const Scene& scene) {
  if (scene.motion.precision != Precision::float32 || scene.motion.method == MotionMethod::anchored) return 0;
  uint64_t stalled = 0;
  const auto lost = [&](float x, float v) { return v != 0 && x + v * scene.dt == x; };
  for (uint64_t i = 0; i < scene.size(); ++i) {
    const vec4 &at = scene.positions[i], &v = scene.velocities[i];
    stalled += lost(at.x, v.x) || lost(at.y, v.y) || lost(at.z, v.z);
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

// A chain from value to value cannot be shared out, so blocks have chains of their own and a further one joins them.
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
