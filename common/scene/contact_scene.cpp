// SPDX-License-Identifier: MIT
#include "common/scene/contact_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/shared/contact/skin.h"

namespace spherepair {
namespace {

constexpr double wanted_overlap = 0.01;                // of the largest radius
constexpr double slowest_start = 1e-6;                 // smallest radii a second: slower counts as at rest
constexpr int position_bits = 51, momentum_bits = 56;  // for positions at the start, and the fastest sphere's momentum

double squared(double x) { return x * x; }

int bits_above(double x) { return int(std::ceil(std::log2(x))); }

// Chooses units with which positions and walls take 51 of 63 bits and the fastest sphere's momentum 56.
void choose_units(Scene& scene) {
  const Radii r = radii_of(scene);
  scene.contact.unit_exponent = position_bits - bits_above(extent_of(scene));
  const int damped = damping_ratio(double(scene.restitution)) > 1;  // impulses need one more bit
  scene.contact.momentum_exponent =
      momentum_bits - damped - bits_above(sphere_mass(double(r.largest)) * double(r.smallest) / double(scene.dt));
  scene.contact.skin = skin_of(scene);
}

double half_step_of_drag(const Scene& scene) { return 0.5 * double(scene.contact.drag) * double(scene.dt); }

// What a periodic box adds to the rounding of centres; see centre_rounding.
double image_rounding(const Scene& scene) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) sum += period_of(scene, axis);
  return 5 * 0x1p-24 * sum;
}

}  // namespace

double highest_speed_of(const Scene& scene, uint64_t i) {
  const vec4& at = scene.positions[i];
  const double fall = std::max(0.0, double(at.y) - double(at.w) - double(scene.plane));
  return std::sqrt(squared(speed(scene.velocities[i])) - 2 * double(scene.gravity) * fall);
}

double speed(const vec4& v) { return std::hypot(double(v.x), double(v.y), double(v.z)); }

double highest_speed(const Scene& scene) {
  const Radii r = radii_of(scene);
  double highest = slowest_start * double(r.smallest);
  for (uint64_t i = 0; i < scene.size(); ++i) highest = std::max(highest, highest_speed_of(scene, i));
  const double wall = scene.contact.law == ContactLaw::quartic ? 0.25 : 1;  // relative to the force between two spheres
  const double pressed = std::sqrt(std::abs(double(scene.gravity)) * wanted_overlap * double(r.largest) / (2 * wall));
  highest = std::max(highest, pressed);
  return highest > slowest_start * double(r.smallest) ? highest : double(r.smallest);
}

double farthest_coordinate(const vec4& s) {
  return std::max({std::abs(double(s.x)), std::abs(double(s.y)), std::abs(double(s.z))});
}

Radii radii_of(const Scene& scene) {
  if (scene.positions.empty()) return {1, 1};
  Radii r{scene.positions[0].w, scene.positions[0].w};
  for (const vec4& sphere : scene.positions)
    r.smallest = std::min(r.smallest, sphere.w), r.largest = std::max(r.largest, sphere.w);
  return r;
}

void choose_contacts(Scene& scene, const ContactChoice& choice) {
  if (choice.law == ContactLaw::none) return;
  scene.motion = {MotionMethod::leapfrog, Precision::fixed};
  scene.contact.law = choice.law;
  scene.contact.drag = choice.drag, scene.contact.sleeping = choice.sleeping;
  choose_box(scene, choice);
  if (radii_of(scene).smallest <= 0) throw std::invalid_argument("contacts need radii above 0: give every sphere one");
  const double largest = double(radii_of(scene).largest), overlap = wanted_overlap * largest;
  const double needed = sphere_mass(largest) / 4 * squared(2 * highest_speed(scene));
  scene.contact.density = choice.density;
  scene.contact.stiffness = float(choice.stiffness ? double(*choice.stiffness) / times_water(scene)
                                                   : needed / contact_energy(choice.law, 1, overlap, 2 * largest));
  if (!choice.stiffness && !std::isfinite(scene.contact.stiffness)) {
    const uint64_t i = sphere_with_most(scene, [&](uint64_t k) { return highest_speed_of(scene, k); });
    const double highest = highest_speed_of(scene, i);
    if (highest < highest_speed(scene))
      throw std::invalid_argument(fmt::format(
          "no stiffness within float32 stops spheres of {:.3g} m: give --stiffness, or lengths in another unit, in "
          "which radii are nearer to 1",
          largest));
    throw std::invalid_argument(
        fmt::format("sphere {} comes to {:.4g} m/s, falls included, which no stiffness in float32 stops: give slower "
                    "spheres, or lengths in another unit",
                    i, highest));
  }
  scene.dt = choice.dt.value_or(float(contact_time(scene) / default_steps(double(scene.restitution))));
  if (!std::isnormal(scene.dt) || !std::isnormal(scene.contact.stiffness))
    throw std::invalid_argument(fmt::format(
        "spheres of {:.3g} m need a stiffness or a time step beyond float32: give lengths in another unit, in which "
        "radii are nearer to 1",
        largest));
  choose_units(scene);
}

double extent_of(const Scene& scene) {
  double extent = std::max(std::abs(double(scene.plane)), double(radii_of(scene).largest));
  for (const vec4& s : scene.positions) extent = std::max(extent, farthest_coordinate(s));
  const std::optional<WallBox> box = box_of(scene);
  for (int axis = 0; axis < 3 && box; ++axis)
    if (scene.contact.walls || box->periodic >> axis & 1)
      extent = std::max({extent, std::abs(double(box->low[axis])), std::abs(double(box->high[axis]))});
  return extent;
}

int coarsest_units(const Radii& radii) { return 29 - int(std::floor(std::log2(radii.smallest))); }

bool units_are_fine(const Scene& scene) {
  if (!(radii_of(scene).smallest > 0)) return true;  // rejected elsewhere
  const int finest = position_bits - bits_above(extent_of(scene));
  return finest >= coarsest_units(radii_of(scene)) && double(skin_of(scene)) <= most_skin;
}

float skin_of(const Scene& scene) {
  const double rounding = 3 * 1.25 * 0x1p-23 * extent_of(scene) + image_rounding(scene);
  return float(std::max(least_skin, 4 * rounding / double(radii_of(scene).smallest)));
}

double contact_time(const Scene& scene) {
  const bool by_speed = scene.contact.law == ContactLaw::hertz;
  return shortest_contact(scene.contact.law, double(scene.contact.stiffness), radii_of(scene),
                          by_speed ? 2 * highest_speed(scene) : 0, double(scene.restitution));
}

Scene grown_scene(const Scene& scene) {
  const ContactParams c = contact_params(scene);
  Scene grown = scene;
  grown.contact.periodic = 0;  // its images are spheres of their own
  for (vec4& sphere : grown.positions) sphere = grown_sphere(sphere, c);
  return grown;
}

std::vector<uint> fixed_state(const Scene& scene) {
  const ContactParams c = contact_params(scene);
  const uint64_t n = scene.size();
  std::vector<uint> words(12 * n);
  const double undo_drag = std::exp(half_step_of_drag(scene));
#pragma omp parallel for schedule(static)
  for (uint64_t i = 0; i < n; ++i) {
    const vec4 &at = scene.positions[i], &v = scene.velocities[i];
    const double per_speed = 1 / (double(mobility_of(at.w, c)) * double(c.metres_per_second));
    const auto earlier = [&](double now) { return int64_t(std::llrint(now * undo_drag)); };
    const auto momentum = [&](float along) { return earlier(double(along) * per_speed); };
    const auto units = [&](float along) { return integer_of(std::ldexp(along, c.unit_exponent)); };
    const int64_t half_weight = earlier(double(integer_of(c.gravity * cubed(at.w)) / 2));
    store_body(
        words, n, i,
        {units(at.x), units(at.y), units(at.z), momentum(v.x), momentum(v.y) - half_weight, momentum(v.z), at.w});
  }
  return words;
}

ContactParams contact_params(const Scene& scene) {
  const ContactOptions& contact = scene.contact;
  if (contact.law == ContactLaw::none) return {};
  const int s = contact.unit_exponent, q = contact.momentum_exponent;
  const double k = double(contact.stiffness), dt = double(scene.dt);
  const double density = sphere_mass(1);
  const Radii r = radii_of(scene);
  const int reach = int(exponent_field(r.largest + r.largest)) - 127;
  const double order = contact.law == ContactLaw::quartic ? 3 : contact.law == ContactLaw::hertz ? 1.5 : 1;
  const auto wall = [&](float at) { return integer_of(std::ldexp(at, s)); };
  constexpr int64_t none = 2 * MOST_UNITS;
  const auto repeats = [&](int axis) { return (contact.periodic >> axis & 1) != 0; };
  const auto low = [&](int axis, float at) { return contact.walls || repeats(axis) ? wall(at) : -none; };
  const auto high = [&](int axis, float at) { return contact.walls || repeats(axis) ? wall(at) : none; };
  const auto corner = [&](int axis, float at) { return repeats(axis) ? at : 0.0f; };
  return {.low_x = low(0, contact.low.x),
          .low_y = wall(scene.plane),
          .low_z = low(2, contact.low.z),
          .high_x = high(0, contact.high.x),
          .high_y = high(1, contact.high.y),
          .high_z = high(2, contact.high.z),
          .law = uint(contact.law),
          .unit_exponent = s,
          .reach_exponent = reach,
          .impulse = float(k * dt * std::exp2(q + order * reach)),
          .damping = float(2 * damping_ratio(double(scene.restitution)) * std::sqrt(k * density) * std::exp2(q - s)),
          .gravity = float(double(scene.gravity) * density * dt * std::exp2(q)),
          .mobility = float(dt / density * std::exp2(s - q)),
          .metres_per_second = float(std::exp2(-s) / dt),
          .fastest = std::ldexp(r.smallest, s),
          .skin = contact.skin,
          .drag_loss = float(-std::expm1(-half_step_of_drag(scene))),
          .sleeping = 0,
          .box_low = {corner(0, contact.low.x), corner(1, scene.plane), corner(2, contact.low.z),
                      float(image_rounding(scene))},
          .box_high = {corner(0, contact.high.x), corner(1, contact.high.y), corner(2, contact.high.z),
                       r.largest * (1 + 2 * contact.skin)}};
}

}  // namespace spherepair
