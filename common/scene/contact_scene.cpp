// SPDX-License-Identifier: MIT
#include "common/scene/contact_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ranges>
#include <stdexcept>

namespace spherepair {
namespace {

constexpr double wanted_overlap = 0.01;  // of the largest radius
constexpr double steps_a_contact = 40, coarse_steps = 10, fewest_steps = 2;
constexpr float least_restitution = 0.1f;
constexpr double most_drag = 0.5;                       // a step
constexpr double least_skin = 1.0 / 32, most_skin = 1;  // of a radius
constexpr double most_units = 0x1p63 - 0x1p57;          // of sums of impulses: room for the roundings of all of them
constexpr int position_bits = 51, momentum_bits = 56;   // used at the start, and of the fastest sphere

double squared(double x) { return x * x; }

double speed(const vec4& v) { return std::hypot(double(v.x), double(v.y), double(v.z)); }

double farthest_coordinate(const vec4& s) {
  return std::max({std::abs(double(s.x)), std::abs(double(s.y)), std::abs(double(s.z))});
}

template <typename Of>
uint64_t sphere_with_most(const Scene& scene, Of of) {
  return std::ranges::max(std::views::iota(uint64_t(0), scene.size()), {}, of);
}

// So that a gap of the smallest radius is not cut off, see gap_of.
int coarsest_units(const Radii& radii) { return 29 - int(std::floor(std::log2(radii.smallest))); }

// A sphere's speed at the start, or after a fall onto the plane.
double highest_speed_of(const Scene& scene, uint64_t i) {
  const vec4& at = scene.positions[i];
  const double fall = std::max(0.0, double(at.y) - double(at.w) - double(scene.plane));
  return std::sqrt(squared(speed(scene.velocities[i])) - 2 * double(scene.gravity) * fall);
}

// At least the largest radius a second.
double highest_speed(const Scene& scene) {
  double highest = double(radii_of(scene).largest);
  for (uint64_t i = 0; i < scene.size(); ++i) highest = std::max(highest, highest_speed_of(scene, i));
  return highest;
}

int bits_above(double x) { return int(std::ceil(std::log2(x))); }

void choose_box(Scene& scene, bool walls) {
  ContactOptions& contact = scene.contact;
  if (contact.walls || !walls || scene.positions.empty()) return;
  contact.walls = true;
  contact.low = {INFINITY, scene.plane, INFINITY, 0}, contact.high = {-INFINITY, -INFINITY, -INFINITY, 0};
  for (const vec4& s : scene.positions) {
    contact.low.x = std::min(contact.low.x, s.x - s.w), contact.high.x = std::max(contact.high.x, s.x + s.w);
    contact.low.z = std::min(contact.low.z, s.z - s.w), contact.high.z = std::max(contact.high.z, s.z + s.w);
    contact.high.y = std::max(contact.high.y, s.y + s.w);
  }
}

// The largest coordinate of spheres and walls.
double extent_of(const Scene& scene) {
  double extent = std::max(std::abs(double(scene.plane)), double(radii_of(scene).largest));
  for (const vec4& s : scene.positions) extent = std::max(extent, farthest_coordinate(s));
  if (scene.contact.walls)
    for (const vec4& s : {scene.contact.low, scene.contact.high}) extent = std::max(extent, farthest_coordinate(s));
  return extent;
}

// Positions and walls then take 51 of 63 bits, and the fastest sphere's momentum 56. With drag a unit of length is no
// finer than gaps of the smallest radius are: each unit then changes impulses, and what is left of their sum when none
// fits better is small enough for drag to hold it below half a unit a step.
void choose_units(Scene& scene) {
  const Radii r = radii_of(scene);
  int& exponent = scene.contact.unit_exponent = position_bits - bits_above(extent_of(scene));
  if (scene.contact.drag > 0) exponent = std::min(exponent, coarsest_units(r));
  const int damped = damping_ratio(double(scene.restitution)) > 1;  // one bit more for impulses
  scene.contact.momentum_exponent =
      momentum_bits - damped - bits_above(sphere_mass(double(r.largest)) * double(r.smallest) / double(scene.dt));
  scene.contact.skin = skin_of(scene);
}

// What momentum and impulses of a sphere can add up to. A contact's alone is less than a hundredth of it, far from
// where integer_of saturates.
double impulse_units(const Scene& scene) {
  const ContactOptions& contact = scene.contact;
  return std::ldexp(greatest_impulse_sum({contact.law, double(contact.stiffness), double(scene.restitution),
                                          double(scene.gravity), double(scene.dt), radii_of(scene)}),
                    contact.momentum_exponent);
}

// What holds for every step of a run.
std::string why_no_law(const Scene& scene) {
  const ContactOptions& contact = scene.contact;
  const Radii r = radii_of(scene);
  const double k = double(contact.stiffness);
  if (!(k > 0) || !std::isfinite(k)) return fmt::format("the stiffness is {}, but must be above 0 and finite", k);
  if (!(r.smallest > 0)) return "contacts need radii above 0";
  if (scene.restitution < 1 && contact.law != ContactLaw::spring)
    return fmt::format("the law {} is elastic: omit the restitution {}, or choose spring", contact_name(contact.law),
                       scene.restitution);
  if (scene.restitution < least_restitution)
    return fmt::format("the restitution of contacts is {}, but must be at least {}", scene.restitution,
                       least_restitution);
  if (!(contact.drag >= 0 && double(contact.drag) * double(scene.dt) <= most_drag))
    return fmt::format("the drag is {} 1/s, but with dt = {:.4g} s can be 0 to {:.3g}", contact.drag, scene.dt,
                       most_drag / double(scene.dt));
  if (r.largest > 256 * r.smallest)
    return fmt::format("radii are {} to {}, but contacts allow 1:256", r.smallest, r.largest);
  return "";
}
std::string why_no_room(const Scene& scene) {
  const double skin = double(scene.contact.skin), sum = impulse_units(scene);
  if (!(skin >= least_skin && skin <= most_skin))
    return fmt::format("the skin of near spheres is {} radii, but must be {} to {}", skin, least_skin, most_skin);
  if (!(sum < most_units))
    return fmt::format(
        "impulses of {:.3g} units could add up, but 64-bit integers hold {:.3g}: give --dt {:.3g} or less, "
        "or a smaller --stiffness",
        sum, most_units, 0.45 * double(scene.dt) * most_units / sum);
  return "";
}

// What holds for a start: a run may get to shorter contacts of faster spheres, and farther out.
std::string why_no_start(const Scene& scene) {
  const Radii r = radii_of(scene);
  const double time = contact_time(scene);
  if (double(scene.dt) > time / fewest_steps)
    return fmt::format("dt is {} s, but a contact lasts {:.3g} s only: give --dt {:.3g} or less", scene.dt, time,
                       time / steps_a_contact);
  if (std::abs(double(scene.plane)) >= extent_of(scene) && !units_are_fine(scene))
    return fmt::format("the radius {} is too small for the plane at y = {}: give larger spheres", r.smallest,
                       scene.plane);
  if (scene.contact.unit_exponent < coarsest_units(r) || double(scene.contact.skin) > most_skin) {
    const uint64_t i = sphere_with_most(scene, [&](uint64_t k) { return farthest_coordinate(scene.positions[k]); });
    return fmt::format(
        "the radius {} is too small for spheres as far out as sphere {}, {:.4g} m along an axis: move "
        "them towards the origin",
        r.smallest, i, farthest_coordinate(scene.positions[i]));
  }
  return "";
}
std::string why_too_fast(const Scene& scene) {
  const float smallest = radii_of(scene).smallest;
  for (uint64_t i = 0; i < scene.size(); ++i) {
    const double radius = double(scene.positions[i].w), v = speed(scene.velocities[i]);
    const double energy = contact_energy(scene.contact.law, double(scene.contact.stiffness), radius, 2 * radius);
    const double fastest = std::min(std::sqrt(energy / sphere_mass(radius)), double(smallest) / double(scene.dt));
    if (v > fastest)
      return fmt::format(
          "sphere {} moves at {:.4g} m/s, but its contacts can stop {:.4g} m/s: give a larger "
          "--stiffness or a smaller --dt",
          i, v, fastest);
  }
  return "";
}

std::string text_of_drag(const Scene& scene) {
  return scene.contact.drag > 0 ? fmt::format(", drag {:.4g} 1/s", scene.contact.drag) : "";
}

}  // namespace

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
  if (radii_of(scene).smallest <= 0) throw std::invalid_argument("contacts need radii above 0: give every sphere one");
  const double largest = double(radii_of(scene).largest), overlap = wanted_overlap * largest;
  const double needed = sphere_mass(largest) / 4 * squared(2 * highest_speed(scene));
  scene.contact.stiffness =
      choice.stiffness.value_or(float(needed / contact_energy(choice.law, 1, overlap, 2 * largest)));
  if (!choice.stiffness && !std::isfinite(scene.contact.stiffness)) {
    const uint64_t i = sphere_with_most(scene, [&](uint64_t k) { return highest_speed_of(scene, k); });
    const double highest = highest_speed_of(scene, i);
    if (highest < largest)
      throw std::invalid_argument(fmt::format(
          "spheres of {:.3g} m, at a radius a second, are stopped by no stiffness in float32: give --stiffness, or "
          "lengths in another unit, in which radii are nearer to 1",
          largest));
    throw std::invalid_argument(
        fmt::format("sphere {} comes to {:.4g} m/s, falls included, which no stiffness in float32 stops: give slower "
                    "spheres, or lengths in another unit",
                    i, highest));
  }
  scene.dt = choice.dt.value_or(float(contact_time(scene) / steps_a_contact));
  if (!std::isnormal(scene.dt) || !std::isnormal(scene.contact.stiffness))
    throw std::invalid_argument(fmt::format(
        "spheres of {:.3g} m need a stiffness or a time step beyond float32: give lengths in another unit, in which "
        "radii are nearer to 1",
        largest));
  choose_box(scene, choice.walls);
  choose_units(scene);
}

bool units_are_fine(const Scene& scene) {
  if (!(radii_of(scene).smallest > 0)) return true;  // refused as such
  const int finest = position_bits - bits_above(extent_of(scene));
  return finest >= coarsest_units(radii_of(scene)) && double(skin_of(scene)) <= most_skin;
}

float skin_of(const Scene& scene) {
  const double rounding = 3 * 1.25 * 0x1p-23 * extent_of(scene);
  return float(std::max(least_skin, 4 * rounding / double(radii_of(scene).smallest)));
}

double contact_time(const Scene& scene) {
  const bool by_speed = scene.contact.law == ContactLaw::hertz;
  return shortest_contact(scene.contact.law, double(scene.contact.stiffness), radii_of(scene),
                          by_speed ? 2 * highest_speed(scene) : 0);
}

std::string describe_contacts(const Scene& scene) {
  if (scene.contact.law == ContactLaw::none) return "";
  const double time = contact_time(scene), steps = time / double(scene.dt);
  std::string text = fmt::format("contacts: {}, stiffness {:.4g}{}; dt = {:.4g} s, a contact lasts {:.3g} steps\n",
                                 contact_name(scene.contact.law), scene.contact.stiffness,
                                 text_of_drag(scene) + (scene.contact.walls ? ", walls" : ""), scene.dt, steps);
  if (steps < coarse_steps)
    text += fmt::format("* dt is coarse: give --dt {:.3g} or less for {} steps a contact\n", time / coarse_steps,
                        coarse_steps);
  return text;
}

std::string why_no_contacts(const Scene& scene, Origin origin) {
  const bool starts = origin == Origin::start;
  std::string why = why_no_law(scene);
  if (why.empty()) why = why_beyond_float32(scene);
  if (why.empty() && starts) why = why_no_start(scene);
  if (why.empty()) why = why_no_room(scene);
  if (why.empty() && starts) why = why_too_fast(scene);
  return why;
}

}  // namespace spherepair
