// SPDX-License-Identifier: MIT
#include "common/scene/contact/contact_resolution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace spherepair {
namespace {

constexpr double least_depth = 512;  // of a contact, in units of gaps (gap.h), which resolve overlaps
constexpr double least_impulse = 8;  // in a step, in units of momentum: mean over a contact
constexpr double least_way = 512;    // travelled in a step, in units of length

// Returns how deep the lightest sphere enters the largest, in metres.
double depth_of(const FastestContact& f) {
  const double lightest = sphere_mass(double(f.radii.smallest)), heaviest = sphere_mass(double(f.radii.largest));
  const double energy = lightest / (1 + lightest / heaviest) * f.speed * f.speed / 2;
  return overlap_of_energy(f.contact.law, double(f.contact.stiffness), energy,
                           double(f.radii.smallest) + double(f.radii.largest));
}

// Rounds to three digits, as messages print.
double rounded(double x, double (*round)(double)) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 2);
  return round(x / unit) * unit;
}

}  // namespace

std::string why_unresolved(const FastestContact& f) {
  const double reach = double(f.radii.smallest) + double(f.radii.largest);
  const double depth = depth_of(f), unit = std::exp2(std::floor(std::log2(reach)) - 29),
               k = double(f.contact.stiffness);
  if (depth < least_depth * unit) {
    const double power = f.contact.law == ContactLaw::hertz ? 2.5 : 2;
    return fmt::format(
        "a sphere of radius {:.4g} m at {:.4g} m/s comes {:.3g} m deep into one of {:.4g} m, and overlaps are "
        "resolved to {:.2g} m: give --stiffness {:.3g} or less without --dt",
        f.radii.smallest, f.speed, depth, f.radii.largest, unit,
        rounded(0.99 * k * std::pow(depth / (least_depth * unit), power), std::floor));
  }
  const double momentum = std::ldexp(sphere_mass(double(f.radii.smallest)) * f.speed, f.contact.momentum_exponent);
  const double impulse = 2 * momentum * f.dt * f.speed / (4 * depth);
  const double way = std::ldexp(f.speed * f.dt, f.contact.unit_exponent);
  const double share = std::min(std::sqrt(impulse / least_impulse), way / least_way);
  if (share < 1)
    return fmt::format(
        "dt is {:.4g} s: a step of a contact changes the momentum of a sphere of radius {:.4g} m at {:.4g} m/s by too "
        "few units: give --dt {:.3g} or more",
        f.dt, f.radii.smallest, f.speed, rounded(1.5 * f.dt / share, std::ceil));
  return "";
}

}  // namespace spherepair
