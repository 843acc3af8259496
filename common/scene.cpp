// SPDX-License-Identifier: MIT
#include "scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "hash.h"

namespace spherepair {
namespace {

constexpr float box_side = 20.0f;  // the paper's, which reproduces its counts of colliding spheres

// A stream of numbers for each purpose, each indexed by sphere: nothing depends on the order of evaluation.
enum class Stream : uint64_t { x, y, z, speed, radius, kind, nudge, direction, cluster_x, cluster_y, cluster_z, octave };

// With 11 the default seed falls inside all four ranges of colliding spheres that the paper gives, as 36 % of seeds do.
uint64_t hash(const SceneOptions& o, Stream stream, uint64_t index) {
  return splitmix64(splitmix64(o.seed + 11 + uint64_t(stream) * 0x9E3779B97F4A7C15ul) + index);
}
float unit(uint64_t hashed) { return float(hashed >> 40) * 0x1p-24f; }  // [0, 1), exact
float between(const SceneOptions& o, Stream stream, uint64_t index, float low, float high) {
  return low + (high - low) * unit(hash(o, stream, index));
}

// The float32 nearest to the cube root, found by comparing cubes of 25-bit midpoints: no libm can change it.
float cube_root(double value) {
  float root = std::cbrt(float(value));
  const auto cube_of_midpoint = [](float a, float b) {
    const double middle = (double(a) + double(b)) / 2;
    return middle * middle * middle;
  };
  while (cube_of_midpoint(root, std::nextafter(root, INFINITY)) <= value) root = std::nextafter(root, INFINITY);
  while (cube_of_midpoint(std::nextafter(root, 0.0f), root) > value) root = std::nextafter(root, 0.0f);
  return root;
}

float packed_side(const SceneOptions& o) {
  return cube_root(double(o.n) * std::numbers::pi / 6 / o.packing_fraction) * (2 * o.radius);
}

uint64_t lattice_side(uint64_t n) {
  uint64_t side = 0;
  while (side * side * side < n) ++side;
  return side;
}

void place(Scene& scene, const SceneOptions& o, float x, float y, float z) {
  scene.positions.push_back({x + o.offset, y + o.offset, z + o.offset, o.radius});
}

void make_random(Scene& scene, const SceneOptions& o) {
  for (uint64_t i = 0; i < o.n; ++i) {
    const float x = between(o, Stream::x, i, -box_side / 2, box_side / 2);
    const float z = between(o, Stream::z, i, -box_side / 2, box_side / 2);
    place(scene, o, x, between(o, Stream::y, i, scene.plane + o.radius, scene.plane + o.radius + box_side), z);
    scene.velocities.push_back({0, between(o, Stream::speed, i, -5, 5), 0, 0});
  }
}

// A group is a block of spheres, 16 to a row, 16 rows to a layer, which nowhere touch each other; it stands at a hashed
// place in the box and moves as one.
void make_aligned(Scene& scene, const SceneOptions& o) {
  const uint64_t size = o.group_size ? o.group_size : 128;
  const float gap = 2.5f * o.radius;
  const auto room = [&](uint64_t spheres) { return std::max(0.0f, box_side - float(spheres) * gap); };
  const uint64_t rows = std::min<uint64_t>((size + 15) / 16, 16), layers = (size + 255) / 256;
  for (uint64_t i = 0; i < o.n; ++i) {
    const uint64_t group = i / size, member = i % size;
    const float x0 = -box_side / 2 + room(std::min<uint64_t>(size, 16)) * unit(hash(o, Stream::x, group));
    const float y0 = scene.plane + o.radius + room(layers) * unit(hash(o, Stream::y, group));
    const float z0 = -box_side / 2 + room(rows) * unit(hash(o, Stream::z, group));
    place(scene, o, x0 + float(member % 16) * gap, y0 + float(member / 256) * gap, z0 + float(member / 16 % 16) * gap);
    scene.velocities.push_back({0, between(o, Stream::speed, group, -5, 5), 0, 0});
  }
}

// Uniform centres in [0, L)^3 at the packing fraction asked for.
void make_uniform(Scene& scene, const SceneOptions& o) {
  const float side = packed_side(o);
  const auto coordinate = [&](uint64_t k) {
    const float value = unit(splitmix64(o.seed * 0xD1342543DE82EF95ul + k)) * side;
    return value < side ? value : 0.0f;
  };
  for (uint64_t i = 0; i < o.n; ++i) place(scene, o, coordinate(3 * i), coordinate(3 * i + 1), coordinate(3 * i + 2));
}

void make_far(Scene& scene, SceneOptions o) {
  o.offset += 1e5f;
  make_uniform(scene, o);
}

// Spacing 2r: every neighbour along an axis is tangent, an exact tie while the multiples of 2r are floats.
void make_lattice(Scene& scene, const SceneOptions& o) {
  const uint64_t side = lattice_side(o.n);
  const float gap = 2 * o.radius;
  for (uint64_t i = 0; i < o.n; ++i) {
    place(scene, o, float(i % side) * gap, float(i / side % side) * gap, float(i / (side * side)) * gap);
  }
}

float nudged(float x, int ulps) { return std::bit_cast<float>(std::bit_cast<uint32_t>(x) + uint32_t(ulps)); }

// Pairs of spheres about to touch, far from each other pair. Half of them stand along an axis at exactly 2r, the others
// along a Pythagorean direction (a, b, c)/d with a^2 + b^2 + c^2 = d^2; half of all are then moved by up to 8 ulp.
void make_grazing(Scene& scene, const SceneOptions& o) {
  constexpr int directions[][4] = {{1, 2, 2, 3}, {2, 3, 6, 7}, {4, 4, 7, 9}, {2, 6, 9, 11}, {3, 4, 12, 13}, {2, 10, 11, 15}};
  const uint64_t side = lattice_side((o.n + 1) / 2);
  const float cell = 8 * o.radius, reach = 2 * o.radius;
  for (uint64_t i = 0; i < o.n; ++i) {
    const uint64_t pair = i / 2;
    float at[3] = {float(pair % side + 1) * cell, float(pair / side % side + 1) * cell, float(pair / (side * side) + 1) * cell};
    if (i % 2 == 1) {
      const uint64_t kind = hash(o, Stream::kind, pair), nudge = hash(o, Stream::nudge, pair);
      const int* direction = directions[hash(o, Stream::direction, pair) % 6];
      for (uint64_t axis = 0; axis < 3; ++axis) {
        const float away = float(direction[axis]) * reach / float(direction[3]);
        at[axis] += kind % 2 ? away : (kind / 2 % 3 == axis ? reach : 0.0f);
      }
      if (nudge % 2) at[nudge / 2 % 3] = nudged(at[nudge / 2 % 3], int(nudge / 8 % 17) - 8);
    }
    place(scene, o, at[0], at[1], at[2]);
  }
}

// Clusters of about 64 spheres, denser in the middle, in the box of the packing fraction.
void make_clustered(Scene& scene, const SceneOptions& o) {
  const float side = packed_side(o);
  const uint64_t clusters = std::max<uint64_t>(o.n / 64, 1);
  const auto coordinate = [&](Stream cluster, Stream own, uint64_t i) {
    float spread = -1.5f;
    for (uint64_t k = 0; k < 3; ++k) spread += unit(hash(o, own, 3 * i + k));
    return side * unit(hash(o, cluster, i % clusters)) + spread * 4 * o.radius;
  };
  for (uint64_t i = 0; i < o.n; ++i) {
    place(scene, o, coordinate(Stream::cluster_x, Stream::x, i), coordinate(Stream::cluster_y, Stream::y, i),
          coordinate(Stream::cluster_z, Stream::z, i));
  }
}

void make_coincident(Scene& scene, const SceneOptions& o) {
  for (uint64_t i = 0; i < o.n; ++i) place(scene, o, 1, 2, 3);
}

void make_one_cell(Scene& scene, const SceneOptions& o) {
  const float side = 2 * o.radius;
  for (uint64_t i = 0; i < o.n; ++i) {
    place(scene, o, side * unit(hash(o, Stream::x, i)), side * unit(hash(o, Stream::y, i)), side * unit(hash(o, Stream::z, i)));
  }
}

// Radii from radius to radius*ratio, evenly spread over the octaves between them.
void vary_radii(Scene& scene, const SceneOptions& o) {
  int octaves = 0;
  while (std::ldexp(1.0f, octaves) < o.radius_ratio) ++octaves;
  for (uint64_t i = 0; i < o.n; ++i) {
    const int octave = int(hash(o, Stream::octave, i) % uint64_t(octaves));
    const float factor = std::ldexp(1 + unit(hash(o, Stream::radius, i)), octave);
    scene.positions[i].w = o.radius * std::min(factor, o.radius_ratio);
  }
  scene.equal_radii = o.n < 2;
}

// What the paper does not fix: slow vertical motion, and a plane that no sphere touches yet.
void finish_test_scene(Scene& scene, const SceneOptions& o) {
  float lowest = 0;
  for (const vec4& p : scene.positions) lowest = std::min(lowest, p.y - 2 * p.w);
  scene.plane = std::floor(lowest) - 1;
  for (uint64_t i = 0; i < o.n; ++i) scene.velocities.push_back({0, between(o, Stream::speed, i, -1, 1), 0, 0});
}

struct Maker {
  SceneKind kind;
  void (*make)(Scene&, const SceneOptions&);
};
const std::vector<Maker>& makers() {
  static const std::vector<Maker> all = {
      {{"random", "the paper's first animation: random places in a 20x20x20 box, random vertical velocities"}, make_random},
      {{"aligned", "the paper's second animation: groups of spheres, each moving as one (--groups, --group-size)"}, make_aligned},
      {{"uniform", "uniform centres at a packing fraction (--packing-fraction)"}, make_uniform},
      {{"lattice", "a cubic lattice of tangent spheres: every neighbour an exact tie, none a collision"}, make_lattice},
      {{"grazing", "pairs within 8 ulp of touching"}, make_grazing},
      {{"clustered", "dense clusters of about 64 spheres"}, make_clustered},
      {{"coincident", "all centres at one point"}, make_coincident},
      {{"far", "the uniform scene, 1e5 away from the origin"}, [](Scene& s, const SceneOptions& o) { make_far(s, o); }},
      {{"one_cell", "all centres within one cube of side 2r"}, make_one_cell}};
  return all;
}

void check_options(const SceneOptions& o) {
  const auto refuse = [](const std::string& why) { throw std::invalid_argument(why); };
  if (o.n > 0x7FFFFFFF) refuse(fmt::format("n is {}, but sphere indices allow 2147483647 at most", o.n));
  if (!(o.radius > 0) || !std::isfinite(o.radius)) refuse(fmt::format("radius is {}, but must be positive and finite", o.radius));
  if (!(o.radius_ratio >= 1) || !std::isfinite(o.radius_ratio)) {
    refuse(fmt::format("radius ratio is {}, but must be at least 1 (largest over smallest radius)", o.radius_ratio));
  }
  if (!(o.packing_fraction > 0 && o.packing_fraction <= 0.74)) {
    refuse(fmt::format("packing fraction is {}, but must be above 0 and at most 0.74", o.packing_fraction));
  }
  if (!std::isfinite(o.offset)) refuse(fmt::format("offset is {}, but must be finite", o.offset));
  if ((o.groups == 0) != (o.group_size == 0)) refuse("groups and group size go together: give both or neither");
  if (o.groups && uint64_t(o.groups) * o.group_size != o.n) {
    refuse(fmt::format("{} groups of {} are {} spheres, but n is {}", o.groups, o.group_size, uint64_t(o.groups) * o.group_size, o.n));
  }
}

}  // namespace

const std::vector<SceneKind>& scene_kinds() {
  static const std::vector<SceneKind> kinds = [] {
    std::vector<SceneKind> all;
    for (const Maker& maker : makers()) all.push_back(maker.kind);
    return all;
  }();
  return kinds;
}

Scene make_scene(const SceneOptions& options) {
  check_options(options);
  const auto maker = std::ranges::find_if(makers(), [&](const Maker& m) { return options.name == m.kind.name; });
  if (maker == makers().end()) {
    std::vector<std::string> names;
    for (const SceneKind& kind : scene_kinds()) names.push_back(kind.name);
    throw std::invalid_argument(fmt::format("unknown scene '{}'; known are {}", options.name, fmt::join(names, ", ")));
  }
  Scene scene;
  scene.name = options.name;
  scene.positions.reserve(options.n);
  scene.velocities.reserve(options.n);
  maker->make(scene, options);
  if (options.radius_ratio > 1) vary_radii(scene, options);
  if (scene.velocities.empty()) finish_test_scene(scene, options);
  return scene;
}

void check_scene(const Scene& scene) {
  uint64_t bad = 0, first = 0;
  const auto wrong = [&](uint64_t i) {
    const vec4 &p = scene.positions[i], &v = scene.velocities[i];
    const bool finite = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w) &&
                        std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    return !finite || p.w < 0;
  };
  if (scene.positions.size() != scene.velocities.size()) {
    throw std::invalid_argument(fmt::format("scene '{}' has {} positions but {} velocities", scene.name, scene.positions.size(), scene.velocities.size()));
  }
  for (uint64_t i = 0; i < scene.size(); ++i) {
    if (wrong(i) && bad++ == 0) first = i;
  }
  if (bad == 0) return;
  const vec4 &p = scene.positions[first], &v = scene.velocities[first];
  throw std::invalid_argument(fmt::format("scene '{}': {} of {} spheres have a NaN, an infinity or a negative radius; the first is sphere {}: "
                                          "centre ({}, {}, {}), radius {}, velocity ({}, {}, {}); remove or mend them",
                                          scene.name, bad, scene.size(), first, p.x, p.y, p.z, p.w, v.x, v.y, v.z));
}

uint64_t state_hash(const std::vector<vec4>& positions, const std::vector<vec4>& velocities) {
  uint64_t sum = positions.size();
  const auto add = [&](const std::vector<vec4>& values) {
    for (const vec4& v : values) {
      sum = splitmix64(sum ^ (uint64_t(float_bits(v.x)) << 32 | float_bits(v.y)));
      sum = murmur64(sum ^ (uint64_t(float_bits(v.z)) << 32 | float_bits(v.w)));
    }
  };
  add(positions);
  add(velocities);
  return sum;
}

}  // namespace spherepair
