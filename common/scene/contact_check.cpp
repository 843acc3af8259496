// SPDX-License-Identifier: MIT
// Says why a scene with contacts cannot be moved.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "common/scene/contact/contact_resolution.h"
#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

constexpr double fewest_steps = 2;  // in a contact
constexpr float least_restitution = 0.1f;
constexpr double most_drag = 0.4;               // a step: positions are wrong by a 24th of its square
constexpr double slowest_step = 0x1p-30;        // smallest radii in a step: slower counts as at rest, see stays()
constexpr double least_range = 128;             // ratio of the fastest speed to the one at which spheres stay
constexpr double least_factor = 0x1p-71;        // loss in half a step: scaled() multiplies by at least 2^-72
constexpr double least_loss = 256;              // units of momentum that the fastest sphere loses in half a step
constexpr double most_units = 0x1p63 - 0x1p57;  // for sums of impulses, leaving room for their roundings

// Returns an upper bound on a sphere's momentum plus impulses, in units. One contact alone is less than a hundredth of
// it, far from where integer_of saturates.
double impulse_units(const Scene& scene) {
  const ContactOptions& contact = scene.contact;
  return std::ldexp(greatest_impulse_sum({contact.law, double(contact.stiffness), double(scene.restitution),
                                          double(scene.gravity), double(scene.dt), radii_of(scene)}),
                    contact.momentum_exponent);
}

// Checks what holds for every step of a run.
std::string why_no_law(const Scene& scene) {
  const ContactOptions& contact = scene.contact;
  const Radii r = radii_of(scene);
  const double k = double(contact.stiffness);
  if (!(k > 0) || !std::isfinite(k)) return fmt::format("the stiffness is {}, but must be above 0 and finite", k);
  if (!(contact.density > 0) || !std::isfinite(contact.density))
    return fmt::format("the density is {}, but must be above 0 and finite", contact.density);
  if (!(r.smallest > 0)) return "contacts need radii above 0";
  if (scene.restitution < 1 && contact.law != ContactLaw::spring)
    return fmt::format("the law {} is elastic: omit the restitution {}, or choose spring", contact_name(contact.law),
                       scene.restitution);
  if (scene.restitution < least_restitution)
    return fmt::format("the restitution of contacts is {}, but must be at least {}", scene.restitution,
                       least_restitution);
  if (!(contact.drag >= 0 && double(contact.drag) * double(scene.dt) <= most_drag))
    return fmt::format("the drag is {} 1/s, but with dt = {:.4g} s can be 0 to {:.3g}", contact.drag, scene.dt,
                       0.995 * most_drag / double(scene.dt));
  if (contact.drag > 0 && double(contact.drag) * double(scene.dt) / 2 < least_factor)
    return fmt::format("the drag of {} 1/s is too weak at dt = {:.4g} s to change any momentum: omit --drag",
                       contact.drag, scene.dt);
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

std::string why_no_images(const Scene& scene) {
  if (scene.size() == 0) return "";
  if (scene.contact.periodic & 2 && scene.gravity != 0)
    return fmt::format(
        "the box is periodic along y, where gravity is {} m/s^2: spheres would fall for ever; give --gravity 0, or a "
        "box that is not periodic along y",
        scene.gravity);
  const double least = least_period(scene);
  for (int axis = 0; axis < 3; ++axis)
    if (const double period = period_of(scene, axis); period != 0 && !(period > least))
      return fmt::format(
          "the periodic box is {:.6g} m along {}, but must be longer than {:.6g} m, two diameters and the skins of the "
          "largest spheres: give a longer box, or one that is not periodic along {}",
          period, "xyz"[axis], least, "xyz"[axis]);
  return "";
}

// Checks the start only: later in a run spheres may be faster, with shorter contacts, and farther out.
std::string why_no_start(const Scene& scene) {
  const Radii r = radii_of(scene);
  const double time = contact_time(scene);
  if (double(scene.dt) > time / fewest_steps)
    return fmt::format("dt is {} s, but a contact lasts {:.3g} s only: give --dt {:.3g} or less", scene.dt, time,
                       time / default_steps(double(scene.restitution)));
  if (scene.contact.unit_exponent < coarsest_units(r) || double(scene.contact.skin) > most_skin) {
    const uint64_t i = sphere_with_most(scene, [&](uint64_t k) { return farthest_coordinate(scene.positions[k]); });
    const double farthest = farthest_coordinate(scene.positions[i]);
    if (std::abs(double(scene.plane)) > 2 * farthest)
      return fmt::format("the radius {} is too small for the plane at y = {}: give larger spheres", r.smallest,
                         scene.plane);
    return fmt::format(
        "the radius {} is too small for spheres as far out as sphere {}, {:.4g} m along an axis: move "
        "them towards the origin",
        r.smallest, i, farthest);
  }
  return "";
}
// Checks that drag acts on the fastest sphere to within 1 %: it moves, and each step's loss of momentum is many units.
std::string why_no_drag(const Scene& scene) {
  const double drag = double(scene.contact.drag), dt = double(scene.dt), radius = double(radii_of(scene).smallest);
  double fastest = 0;
  for (uint64_t i = 0; i < scene.size(); ++i) fastest = std::max(fastest, highest_speed_of(scene, i));
  if (drag == 0 || fastest == 0) return "";
  const double shortest = least_range * slowest_step * radius / fastest;
  const double units = std::ldexp(sphere_mass(radius) * fastest, scene.contact.momentum_exponent) * drag * dt / 2;
  if (dt < shortest)
    return fmt::format(
        "with drag a sphere stays in place below {:.3g} m/s at dt = {:.4g} s, and the fastest moves at {:.3g} m/s: "
        "omit --drag, or give --dt {:.3g} or more",
        slowest_step * radius / dt, dt, fastest,
        std::max(1.006 * shortest, 1.5 * dt * std::sqrt(least_loss / units)));  // units grow with dt squared
  if (const double enough = 1.006 * drag * least_loss / units; units < least_loss)
    return fmt::format(
        "the drag of {} 1/s is too weak at dt = {:.4g} s: half a step takes {:.3g} units of the momentum of a sphere "
        "of "
        "{} m, and must take {}: omit --drag{}, or give a smaller --stiffness without --dt",
        scene.contact.drag, dt, units, radius, least_loss,
        enough * dt < most_drag ? fmt::format(", give --drag {:.3g} or more", enough) : "");
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

}  // namespace

std::string why_beyond_float32(const Scene& scene) {
  const Radii r = radii_of(scene);
  const ContactParams c = contact_params(scene);
  const auto cube = [](float radius) { return std::pow(double(radius), 3); };
  const std::pair<const char*, double> factors[] = {
      {"the cube of the smallest radius", cube(r.smallest)},
      {"the cube of the largest, twice", 2 * cube(r.largest)},
      {"the impulse of a full overlap", double(c.impulse)},
      {"units that a unit of momentum moves a sphere of 1 m", double(c.mobility)},
      {"units that it moves the smallest", double(c.mobility) / cube(r.smallest)},
      {"units that it moves the largest", double(c.mobility) / cube(r.largest)},
      {"metres a second of a unit a step", double(c.metres_per_second)}};
  for (const auto& [what, value] : factors)
    if (!std::isnormal(float(value)))
      return fmt::format(
          "with radii of {:.3g} to {:.3g} m, stiffness {:.3g} and steps of {:.3g} s a factor is beyond float32 ({}): "
          "give "
          "lengths in another unit, in which radii are nearer to 1",
          r.smallest, r.largest, scene.contact.stiffness, scene.dt, what);
  return "";
}

std::string why_no_contacts(const Scene& scene, Origin origin) {
  const bool starts = origin == Origin::start;
  std::string why = why_no_law(scene);
  if (why.empty()) why = why_beyond_float32(scene);
  if (why.empty() && starts) why = why_no_start(scene);
  if (why.empty()) why = why_no_images(scene);
  if (why.empty()) why = why_no_room(scene);
  if (why.empty() && starts) why = why_no_drag(scene);
  if (why.empty() && starts) why = why_too_fast(scene);
  if (why.empty() && starts)
    why = why_unresolved({scene.contact, radii_of(scene), highest_speed(scene), double(scene.dt)});
  return why;
}

}  // namespace spherepair
