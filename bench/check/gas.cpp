// SPDX-License-Identifier: MIT
#include "bench/check/gas.h"

#include <cmath>
#include <numbers>

#include "bench/check/contact_statistics.h"
#include "bench/check/step_result.h"
#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

double squared(double x) { return x * x; }
double diameter(const Scene& scene) { return 2 * double(scene.positions.at(0).w); }
double length(const Scene& scene) { return double(scene.contact.high.x); }

// The packing fraction in a smooth window in the middle, farther from the walls than their layers reach.
double bulk_fraction(const Gas& gas, const std::vector<vec4>& positions) {
  const double from = 2 * gas.diameter, window = length(gas.scene) - 2 * from;
  const auto weight = [&](float x) {
    const double at = (double(x) - from) / window;
    return at > 0 && at < 1 ? squared(std::sin(std::numbers::pi * at)) : 0;
  };
  double inside = 0;
  for (const vec4& p : positions) inside += weight(p.x) * weight(p.y) * weight(p.z);
  return inside * std::numbers::pi / 6 * std::pow(2 * gas.diameter / window, 3);  // the window's mean is 1/2
}

ContactStatistics statistics_of(Backend& backend, const Gas& gas) {
  backend.collide({.want_pairs = true});
  return contact_statistics(gas.scene, current_state(backend).wide, backend.pairs(), 0);
}

void move(Motion& motion, uint64_t steps) {
  for (uint64_t step = 0; step < steps; ++step) motion.move();
}

double temperature(double kinetic, uint64_t n) { return 2 * kinetic / (3 * double(n)); }  // times Boltzmann's constant

// The surface tension of a hard wall that the centres reach, times d^2 / k T: Reiss, Frisch, Helfand, Lebowitz, J.
// Chem. Phys. 32 (1960) 119.
double surface_tension(double f) { return -9 / (2 * std::numbers::pi) * f * f * (1 + f) / std::pow(1 - f, 3); }

// The excess spheres in the layers at such a wall, as a depth of the gas away from it, in diameters: the derivative of
// the tension by Carnahan and Starling's chemical potential.
double layers(double f) {
  return 1.5 * f * (1 + 2 * f) / (1 + 4 * f + 4 * f * f - 4 * std::pow(f, 3) + std::pow(f, 4));
}

double volume(const Scene& scene) { return double(scene.size()) * std::numbers::pi / 6 * std::pow(diameter(scene), 3); }

}  // namespace

double compressibility(double f) { return (1 + f + f * f - f * f * f) / std::pow(1 - f, 3); }
double contact_value(double f) { return (1 - f / 2) / std::pow(1 - f, 3); }

double expected_pressure(double f) { return compressibility(f) * f * 6 / std::numbers::pi; }

double fraction_at_rest(const Scene& scene) {
  double fraction = 0;
  for (int round = 0; round < 60; ++round)
    fraction = volume(scene) / std::pow(length(scene) - (1 - 2 * layers(fraction)) * diameter(scene), 3);
  return fraction;
}

void squeeze(Scene& scene) {
  const double middle = length(scene) / 2, side = std::cbrt(volume(scene) / fraction_at_rest(scene));
  for (vec4& p : scene.positions)
    for (float vec4::*axis : {&vec4::x, &vec4::y, &vec4::z})
      p.*axis = float(middle + (double(p.*axis) - middle) * side / length(scene));
}

Gas equilibrated_gas(Motion& motion, const Scene& start, double seconds) {
  Gas gas{start, diameter(start), sphere_mass(diameter(start) / 2)};
  motion.upload(gas.scene);
  move(motion, uint64_t(std::ceil(seconds / double(start.dt))));
  const Motion::State state = current_state(motion);
  gas.scene.positions = state.positions, gas.scene.velocities = state.velocities;
  return gas;
}

// In a box that the centres reach over a length l, 2 K + virial = 3 (p l^3 - 4 tension l^2).
Pressure measure_pressure(Backend& backend, const Gas& gas, uint64_t samples, uint64_t steps) {
  double sum = 0, squares = 0, heat = 0, bulk = 0;
  backend.upload(gas.scene);
  for (uint64_t sample = 0; sample < samples; ++sample) {
    move(backend, steps);
    const ContactStatistics now = statistics_of(backend, gas);
    const double both = 2 * now.kinetic + now.virial;
    sum += both / double(samples), squares += both * both / double(samples);
    heat += temperature(now.kinetic, gas.scene.size()) / double(samples);
    bulk += bulk_fraction(gas, current_state(backend).positions) / double(samples);
  }
  const double reached = length(gas.scene) / gas.diameter - 1;  // in diameters
  const double pressure = sum / heat / (3 * std::pow(reached, 3)) + 4 * surface_tension(bulk) / reached;
  const double scatter = std::sqrt((squares / squared(sum) - 1) / double(samples - 1));
  return {pressure, expected_pressure(bulk), bulk, scatter};
}

double expected_tau(const Gas& gas, double bulk, double kinetic) {
  const double lost = 1 - squared(double(gas.scene.restitution));
  const double speed = std::sqrt(temperature(kinetic, gas.scene.size()) / gas.mass);
  const double density = bulk * 6 / std::numbers::pi / gas.diameter;  // times the squared diameter
  return 3 / (2 * lost * density * contact_value(bulk) * std::sqrt(std::numbers::pi) * speed);
}

double Cooling::tau() const { return seconds / (std::sqrt(first / last) - 1); }

Cooling measure_cooling(Backend& backend, const Gas& gas, uint64_t samples, uint64_t steps) {
  backend.upload(gas.scene);
  const double first = statistics_of(backend, gas).kinetic;
  double bulk = 0;
  std::vector<double> energies;
  for (uint64_t sample = 0; sample < samples; ++sample) {
    move(backend, steps);
    bulk += bulk_fraction(gas, current_state(backend).positions) / double(samples);
    energies.push_back(statistics_of(backend, gas).kinetic);
  }
  return {.seconds = double(samples * steps) * double(gas.scene.dt),
          .first = first,
          .last = energies.back(),
          .expected = expected_tau(gas, bulk, first),
          .packing_fraction = bulk,
          .energies = energies};
}

}  // namespace spherepair
