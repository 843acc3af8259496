// SPDX-License-Identifier: MIT
#include "common/scene/contact_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "common/shared/hash.h"

namespace spherepair {
namespace {

constexpr double densest_lattice = 0.52;  // packing fraction: pi / 6 and some room

// Returns a number from -1 to 1 that depends on the seed and `number` alone.
float any(const SceneOptions& o, uint64_t number) {
  return float(splitmix64(splitmix64(o.seed) + number) >> 40) * 0x1p-23f - 1.0f;
}

float largest_radius(const SceneOptions& o) { return o.radius * o.radius_ratio; }

// Returns the largest float whose cube, rounded to double, is not above `value`, whatever the libm.
float cube_root_below(double value) {
  const auto cube = [](float x) { return double(x) * double(x) * double(x); };
  float root = float(std::cbrt(value));
  while (cube(std::nextafter(root, INFINITY)) <= value) root = std::nextafter(root, INFINITY);
  while (cube(root) > value) root = std::nextafter(root, 0.0f);
  return root;
}

// A lattice of along_x by along_z cells, with as many layers along y as needed. Each sphere is moved at random within
// its cell.
struct Lattice {
  uint64_t along_x, along_z;
  float gap;
};

uint64_t cube_side(uint64_t n) {
  uint64_t side = 1;
  while (side * side * side < n) ++side;
  return side;
}

void fill(Scene& scene, const SceneOptions& o, const Lattice& cells, float speed) {
  const float room = 0.45f * (cells.gap - 2 * largest_radius(o));
  for (uint64_t i = 0; i < o.n; ++i) {
    const uint64_t x = i % cells.along_x, z = i / cells.along_x % cells.along_z, y = i / cells.along_x / cells.along_z;
    const auto at = [&](uint64_t cell, uint64_t axis) {
      return (float(cell) + 0.5f) * cells.gap + room * any(o, 6 * i + axis) + o.offset;
    };
    const auto velocity = [&](uint64_t axis) { return speed * any(o, 6 * i + 3 + axis); };
    scene.positions.push_back({at(x, 0), at(y, 1), at(z, 2), o.radius});
    scene.velocities.push_back({velocity(0), velocity(1), velocity(2), 0});
  }
  scene.plane = o.offset;
}

void close_box(Scene& scene, const SceneOptions& o, const Lattice& cells, uint64_t layers) {
  const auto far = [&](uint64_t count) { return float(count) * cells.gap + o.offset; };
  scene.contact.walls = true;
  scene.contact.low = {o.offset, o.offset, o.offset, 0};
  scene.contact.high = {far(cells.along_x), far(layers), far(cells.along_z), 0};
}

void make_gas(Scene& scene, const SceneOptions& o) {
  if (o.packing_fraction > densest_lattice)
    throw std::invalid_argument(
        fmt::format("the scene gas starts from a lattice: its packing fraction is {}, but can be "
                    "{} at most",
                    o.packing_fraction, densest_lattice));
  const uint64_t side = cube_side(o.n);
  const double diameter = 2 * double(largest_radius(o));
  const Lattice cells{side, side,
                      cube_root_below(diameter * diameter * diameter * (std::numbers::pi / 6) / o.packing_fraction)};
  fill(scene, o, cells, 1);
  close_box(scene, o, cells, side);
  scene.gravity = 0;
}

void make_bed(Scene& scene, const SceneOptions& o) {
  const uint64_t side = cube_side(o.n);
  const Lattice cells{side, side, 2.2f * largest_radius(o)};
  fill(scene, o, cells, 0.1f);
  close_box(scene, o, cells, side + 1);
}

void make_column(Scene& scene, const SceneOptions& o) {
  const uint64_t side = cube_side((o.n + 3) / 4);
  fill(scene, o, {side, side, 2.05f * largest_radius(o)}, 0.01f);
}

// Pairs of spheres that run into each other head-on, far from other pairs. An odd last sphere stands still.
void make_collide2(Scene& scene, const SceneOptions& o) {
  const float apart = 2.2f * largest_radius(o), alone = 8 * largest_radius(o);
  const uint64_t side = cube_side((o.n + 1) / 2);
  for (uint64_t i = 0; i < o.n; ++i) {
    const uint64_t pair = i / 2;
    const auto at = [&](uint64_t cell) { return float(cell) * alone + o.offset; };
    const float forward = i + 1 == o.n && i % 2 == 0 ? 0.0f : i % 2 == 0 ? 1.0f : -1.0f;
    scene.positions.push_back(
        {at(pair % side) + (i % 2 == 0 ? 0 : apart), at(pair / side % side), at(pair / side / side), o.radius});
    scene.velocities.push_back({forward, 0, 0, 0});
  }
  scene.gravity = 0;
  scene.plane = o.offset - alone;
}

// A row of spheres at rest, a hundredth of a radius apart, and the first one moving towards them.
void make_newton(Scene& scene, const SceneOptions& o) {
  for (uint64_t i = 0; i < o.n; ++i) {
    const float x = float(i) * 2.01f * largest_radius(o) + o.offset;
    scene.positions.push_back({x, o.offset, o.offset, o.radius});
    scene.velocities.push_back({i == 0 ? 1.0f : 0.0f, 0, 0, 0});
  }
  scene.gravity = 0;
  scene.plane = o.offset - 4 * largest_radius(o);
}

}  // namespace

Scene packed_bed(uint64_t n, uint64_t layers) {
  const SceneOptions options{.name = "bed", .n = n};
  const float radius = options.radius, gap = 1.998f * radius;  // from centre to centre
  const float rise = std::sqrt(4 * radius * radius - gap * gap / 2);
  const auto squared = [](uint64_t x) { return x * x; };
  uint64_t side = 2;
  while ((squared(side) + squared(side - 1)) * layers < 2 * n) ++side;
  const uint64_t even = squared(side), two_layers = even + squared(side - 1);
  Scene scene = make_scene(options);
  for (uint64_t i = 0; i < n; ++i) {
    const bool odd = i % two_layers >= even;
    const uint64_t k = i % two_layers - (odd ? even : 0), wide = odd ? side - 1 : side;
    const float first = gap / 2 + (odd ? gap / 2 : 0);
    scene.positions[i] = {first + gap * float(k % wide), radius + rise * float(i / two_layers * 2 + odd),
                          first + gap * float(k / wide), radius};
    scene.velocities[i] = {0, 0, 0, 0};
  }
  const float width = gap * float(side);
  scene.contact.high = {width, rise * float(layers) + 2 * radius, width, 0};
  return scene;
}

bool made_for_contacts(const std::string& name) {
  return std::ranges::any_of(contact_makers(), [&](const SceneMaker& maker) { return name == maker.kind.name; });
}

const std::vector<SceneMaker>& contact_makers() {
  static const std::vector<SceneMaker> all = {
      {{"gas", "spheres with random velocities in a closed box, without gravity (--packing-fraction)"}, make_gas},
      {{"bed", "spheres that fall into a closed box; with --contact they come to rest"}, make_bed},
      {{"column", "a column on the plane; with --contact it falls and spreads"}, make_column},
      {{"collide2", "pairs of spheres that run into each other head-on, without gravity"}, make_collide2},
      {{"newton", "a row of spheres and one that runs into it, without gravity"}, make_newton}};
  return all;
}

}  // namespace spherepair
