// SPDX-License-Identifier: MIT
#include "common/scene/scene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "common/scene/contact_scenes.h"
#include "common/scene/host_buffer.h"
#include "common/scene/known_name.h"
#include "common/shared/hash.h"

namespace spherepair {
namespace {

constexpr float box_side = 20.0f;  // the paper's: gives its counts of colliding spheres

// Independent random streams, each indexed by sphere: nothing depends on the order of evaluation.
enum class Stream : uint64_t {
  x,
  y,
  z,
  speed,
  radius,
  kind,
  nudge,
  direction,
  cluster_x,
  cluster_y,
  cluster_z,
  octave
};

// With 11 the default seed is in all four ranges of colliding spheres that the paper gives, as 36 % of seeds are.
uint64_t hash(const SceneOptions& o, Stream stream, uint64_t index) {
  return splitmix64(splitmix64(o.seed + 11 + uint64_t(stream) * 0x9E3779B97F4A7C15ul) + index);
}
float unit(uint64_t hashed) { return float(hashed >> 40) * 0x1p-24f; }  // [0, 1), exact
float between(const SceneOptions& o, Stream stream, uint64_t index, float low, float high) {
  return low + (high - low) * unit(hash(o, stream, index));
}

// Returns the float32 nearest to the cube root. It compares cubes of 25-bit midpoints, so that no libm can change it.
float cube_root(double value) {
  float root = float(std::cbrt(value));
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

vec4 sphere(const SceneOptions& o, float x, float y, float z) {
  return {x + o.offset, y + o.offset, z + o.offset, o.radius};
}
void add(Scene& to, const SceneOptions& o, float x, float y, float z) { to.positions.push_back(sphere(o, x, y, z)); }

void make_random(Scene& scene, const SceneOptions& o) {
  for (uint64_t i = 0; i < o.n; ++i) {
    const float x = between(o, Stream::x, i, -box_side / 2, box_side / 2);
    const float z = between(o, Stream::z, i, -box_side / 2, box_side / 2);
    add(scene, o, x, between(o, Stream::y, i, scene.plane + o.radius, scene.plane + o.radius + box_side), z);
    scene.velocities.push_back({0, between(o, Stream::speed, i, -5, 5), 0, 0});
  }
}

// Groups of spheres that nowhere touch each other within the group: 16 to a row, 16 rows to a layer. A group starts at
// a random place in the box and moves as one.
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
    add(scene, o, x0 + float(member % 16) * gap, y0 + float(member / 256) * gap, z0 + float(member / 16 % 16) * gap);
    scene.velocities.push_back({0, between(o, Stream::speed, group, -5, 5), 0, 0});
  }
}

// Uniform centres in [0, L)^3 at the given packing fraction.
void make_uniform(Scene& scene, const SceneOptions& o) {
  const float side = packed_side(o);
  const auto coordinate = [&](uint64_t k) {
    const float value = unit(splitmix64(o.seed * 0xD1342543DE82EF95ul + k)) * side;
    return value < side ? value : 0.0f;
  };
  scene.positions.resize(o.n);
#pragma omp parallel for if (o.n > many_spheres)
  for (uint64_t i = 0; i < o.n; ++i)
    scene.positions[i] = sphere(o, coordinate(3 * i), coordinate(3 * i + 1), coordinate(3 * i + 2));
}

void make_far(Scene& scene, SceneOptions o) {
  o.offset += 1e5f;
  make_uniform(scene, o);
}

// A lattice with spacing 2r: neighbours along an axis are tangent, exactly so while the multiples of 2r are floats.
void make_lattice(Scene& scene, const SceneOptions& o) {
  const uint64_t side = lattice_side(o.n);
  const float gap = 2 * o.radius;
  for (uint64_t i = 0; i < o.n; ++i) {
    add(scene, o, float(i % side) * gap, float(i / side % side) * gap, float(i / (side * side)) * gap);
  }
}

float nudged(float x, int ulps) { return std::bit_cast<float>(std::bit_cast<uint32_t>(x) + uint32_t(ulps)); }

// Pairs of spheres about to touch, far from all other pairs. Half of the pairs are along x at exactly 2r, half in a
// random direction at 2r rounded; then half of all are moved by up to 8 ulp along x. Steps along y and z are multiples
// of 2r/256, exact far from the origin. x stays near 0, where an ulp is small enough to mislead float32.
void make_grazing(Scene& scene, const SceneOptions& o) {
  const uint64_t side = std::max<uint64_t>(uint64_t(std::ceil(std::sqrt(double(o.n) / 2))), 1);
  const float reach = 2 * o.radius;
  for (uint64_t i = 0; i < o.n; ++i) {
    const uint64_t pair = i / 2, nudge = hash(o, Stream::nudge, pair);
    float x = 0, y = float(pair % side) * 4 * reach, z = float(pair / side) * 4 * reach;
    if (i % 2 == 1) {
      const bool along_x = hash(o, Stream::kind, pair) % 2;
      const float dy = along_x ? 0 : float(hash(o, Stream::y, pair) % 181) / 256 * reach;  // 181^2 * 2 < 256^2
      const float dz = along_x ? 0 : float(hash(o, Stream::z, pair) % 181) / 256 * reach;
      x = float(std::sqrt(double(reach) * reach - double(dy) * dy - double(dz) * dz));  // IEEE: the same everywhere
      if (nudge % 2) x = nudged(x, int(nudge / 2 % 17) - 8);
      y += dy;
      z += dz;
    }
    add(scene, o, x, y, z);
  }
}

// Clusters of about 64 spheres, denser in the middle, in a box for the packing fraction.
void make_clustered(Scene& scene, const SceneOptions& o) {
  const float side = packed_side(o);
  const uint64_t clusters = std::max<uint64_t>(o.n / 64, 1);
  const auto coordinate = [&](Stream cluster, Stream own, uint64_t i) {
    float spread = -1.5f;
    for (uint64_t k = 0; k < 3; ++k) spread += unit(hash(o, own, 3 * i + k));
    return side * unit(hash(o, cluster, i % clusters)) + spread * 4 * o.radius;
  };
  for (uint64_t i = 0; i < o.n; ++i) {
    add(scene, o, coordinate(Stream::cluster_x, Stream::x, i), coordinate(Stream::cluster_y, Stream::y, i),
        coordinate(Stream::cluster_z, Stream::z, i));
  }
}

void make_coincident(Scene& scene, const SceneOptions& o) {
  for (uint64_t i = 0; i < o.n; ++i) add(scene, o, 1, 2, 3);
}

void make_one_cell(Scene& scene, const SceneOptions& o) {
  const float side = 2 * o.radius;
  for (uint64_t i = 0; i < o.n; ++i) {
    add(scene, o, side * unit(hash(o, Stream::x, i)), side * unit(hash(o, Stream::y, i)),
        side * unit(hash(o, Stream::z, i)));
  }
}

// Sets radii from radius to radius*ratio, spread evenly over the octaves between them.
void vary_radii(Scene& scene, const SceneOptions& o) {
  int octaves = 0;
  while (std::ldexp(1.0f, octaves) < o.radius_ratio) ++octaves;
#pragma omp parallel for schedule(static) if (o.n > many_spheres)
  for (uint64_t i = 0; i < o.n; ++i) {
    const int octave = int(hash(o, Stream::octave, i) % uint64_t(octaves));
    const float factor = std::ldexp(1 + unit(hash(o, Stream::radius, i)), octave);
    scene.positions[i].w = o.radius * std::min(factor, o.radius_ratio);
  }
  scene.equal_radii = o.n < 2;
}

// Sets what the paper leaves open: slow vertical motion, and a plane that no sphere touches yet.
void finish_test_scene(Scene& scene, const SceneOptions& o) {
  float lowest = 0;
  scene.velocities.resize(o.n);
#pragma omp parallel for schedule(static) reduction(min : lowest) if (o.n > many_spheres)
  for (uint64_t i = 0; i < o.n; ++i) {
    lowest = std::min(lowest, scene.positions[i].y - 2 * scene.positions[i].w);
    scene.velocities[i] = {0, between(o, Stream::speed, i, -1, 1), 0, 0};
  }
  scene.plane = std::floor(lowest) - 1;
}

std::vector<SceneMaker> all_makers() {
  std::vector<SceneMaker> all = {
      {{"random", "the paper's first animation: random places in a 20x20x20 box, random vertical velocities"},
       make_random},
      {{"aligned", "the paper's second animation: groups of spheres, each moving as one (--groups, --group-size)"},
       make_aligned},
      {{"uniform", "uniform centres at a packing fraction (--packing-fraction)"}, make_uniform},
      {{"lattice", "a cubic lattice of tangent spheres: every neighbour an exact tie, none a collision"}, make_lattice},
      {{"grazing", "pairs within 8 ulp of touching"}, make_grazing},
      {{"clustered", "dense clusters of about 64 spheres"}, make_clustered},
      {{"coincident", "all centres at one point"}, make_coincident},
      {{"far", "the uniform scene, 1e5 away from the origin"}, [](Scene& s, const SceneOptions& o) { make_far(s, o); }},
      {{"one_cell", "all centres within one cube of side 2r"}, make_one_cell}};
  all.insert(all.end(), contact_makers().begin(), contact_makers().end());
  return all;
}
const std::vector<SceneMaker>& makers() {
  static const std::vector<SceneMaker> all = all_makers();
  return all;
}

}  // namespace

const std::vector<SceneKind>& scene_kinds() {
  static const std::vector<SceneKind> kinds = [] {
    std::vector<SceneKind> all;
    for (const SceneMaker& maker : makers()) all.push_back(maker.kind);
    return all;
  }();
  return kinds;
}

Scene make_scene(const SceneOptions& options) {
  check_options(options);
  const auto maker = std::ranges::find_if(makers(), [&](const SceneMaker& m) { return options.name == m.kind.name; });
  if (maker == makers().end()) {
    std::vector<std::string> indices;
    for (const SceneKind& kind : scene_kinds()) indices.push_back(kind.name);
    throw std::invalid_argument(unknown_name("scene", options.name, indices));
  }
  Scene scene{.name = options.name, .dt = options.dt, .restitution = options.restitution, .motion = options.motion};
  for (std::vector<vec4>* values : {&scene.positions, &scene.velocities}) reserve_large(*values, options.n);
  maker->make(scene, options);
  if (options.radius_ratio > 1) vary_radii(scene, options);
  if (scene.velocities.empty()) finish_test_scene(scene, options);
  return scene;
}

}  // namespace spherepair
