// SPDX-License-Identifier: MIT
#include "common/scene/contact/contact_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spherepair {
namespace {

constexpr double density = 1000 * 4 * std::numbers::pi / 3;  // kg per cubed metre of radius: water

double squared(double x) { return x * x; }
double cubed_length(double x) { return x * x * x; }

// Returns a bound on a contact's force, without the damper's, up to this overlap and reach. For quartic, (R^2 - d^2) d
// is below 2 o R^2, and below 2 R^3 / sqrt(27) at any distance.
double greatest_force(ContactLaw law, double k, double overlap, double reach) {
  if (law == ContactLaw::spring) return k * overlap;
  if (law == ContactLaw::hertz) return k * std::pow(overlap, 1.5);
  return k * std::min(2 * overlap * squared(reach), 0.385 * cubed_length(reach));
}

// Returns a bound on the number of spheres with radii b to w b that touch a sphere of radius a b. Their centres are
// max(a, 1) b to (a + w) b from its centre and at least b apart, so balls of radius b/2 around them are disjoint.
double greatest_number(double a, double w) { return 8 * (cubed_length(a + w + 0.5) - cubed_length(a - 0.5)); }

double reduced_mass(double a, double b) { return sphere_mass(a) * sphere_mass(b) / (sphere_mass(a) + sphere_mass(b)); }

}  // namespace

double sphere_mass(double radius) { return density * radius * radius * radius; }

double contact_energy(ContactLaw law, double k, double overlap, double reach) {
  if (law == ContactLaw::spring) return k * squared(overlap) / 2;
  if (law == ContactLaw::hertz) return k * 0.4 * std::pow(overlap, 2.5);
  return k / 4 * squared(squared(reach) - squared(reach - overlap));
}

double overlap_of_energy(ContactLaw law, double k, double energy, double reach) {
  if (law == ContactLaw::spring) return std::sqrt(2 * energy / k);
  if (law == ContactLaw::hertz) return std::pow(2.5 * energy / k, 0.4);
  const double squares = std::min(std::sqrt(4 * energy / k), squared(reach));
  return squares / (reach + std::sqrt(squared(reach) - squares));
}

// Returns the time of the stiffest pair's contact, which is the shortest. For spring and hertz that pair is the two
// lightest spheres. For quartic the force rises by 2 k R^2 as spheres begin to touch, so it is the pair with the least
// reduced mass over R^2. One of the two is a smallest sphere. As the other's radius grows, this quotient rises, then
// falls, so it is least at either end.
double shortest_contact(ContactLaw law, double k, Radii radii, double closing_speed, double restitution) {
  const double smallest = double(radii.smallest), largest = double(radii.largest),
               mass = reduced_mass(smallest, smallest);
  if (law == ContactLaw::hertz)
    return 2.9432 * std::pow(5 * mass * squared(closing_speed) / (4 * k), 0.4) / closing_speed;
  if (law == ContactLaw::spring) return damped_time(damping_ratio(restitution)) * std::sqrt(mass / k);
  const double lightest =
      std::min(mass / squared(2 * smallest), reduced_mass(smallest, largest) / squared(smallest + largest));
  return std::numbers::pi * std::sqrt(lightest / (2 * k));
}

// Returns the time until the force of x'' + 2 b x' + x = 0, started at x = 0, falls to 0. ratio: b. Schwager and
// Poeschel, Granular Matter 9 (2007) 465.
double damped_time(double ratio) {
  const double root = std::sqrt(std::abs(1 - ratio * ratio));
  if (root == 0) return 2;
  return 2 * (ratio < 1 ? std::acos(ratio) : std::acosh(ratio)) / root;
}

// Solves for the ratio b: as the force falls to 0, the speed is exp(-b t) of the initial one, for any damping.
double damping_ratio(double restitution) {
  double low = 0, high = 2;
  for (int turn = 0; turn < 60; ++turn) {
    const double middle = (low + high) / 2;
    (std::exp(-middle * damped_time(middle)) > restitution ? low : high) = middle;
  }
  return restitution < 1 ? (low + high) / 2 : 0;
}

double default_steps(double restitution) { return std::max(40.0, 60 * std::log(1 / std::max(restitution, 0.1))); }

// Adds up partners by classes of radii b to 2 b. A wall pushes less than one partner of the largest radius.
double greatest_impulse_sum(const StepBounds& step) {
  const double smallest = double(step.radii.smallest), largest = double(step.radii.largest);
  const double fall = -step.gravity * step.dt;
  const double speed = smallest / step.dt + fall / 2;  // along an axis; the start subtracts half a step's fall
  const double damping = 2 * damping_ratio(step.restitution) * std::sqrt(step.stiffness);
  const auto impulse = [&](double radius) {
    const double damper = damping * std::sqrt(sphere_mass(radius)) * 2 * std::numbers::sqrt3 * speed;
    return step.dt * (greatest_force(step.law, step.stiffness, radius, largest + radius) + damper);
  };
  double sum = sphere_mass(largest) * (speed + fall) + impulse(largest);
  for (double b = smallest; b == smallest || b < largest; b *= 2) {
    const double width = std::min(2.0, largest / b);
    sum += greatest_number(largest / b, width) * impulse(width * b);
  }
  return sum;
}

}  // namespace spherepair
