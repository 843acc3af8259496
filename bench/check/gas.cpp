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

// A smooth window, longer than the layers at the walls are thick.
double bulk_fraction(const Gas& gas, const std::vector<vec4>& positions) {
  const double from = 2 * gas.diameter, length = double(gas.scene.contact.high.x) - 2 * from;
  const auto weight = [&](float x) {
    const double at = (double(x) - from) / length;
    return at > 0 && at < 1 ? squared(std::sin(std::numbers::pi * at)) : 0;
  };
  double inside = 0;
  for (const vec4& p : positions) inside += weight(p.x) * weight(p.y) * weight(p.z);
  return inside * std::numbers::pi / 6 * std::pow(2 * gas.diameter / length, 3);  // the window's mean is 1/2
}

ContactStatistics statistics_of(Backend& backend, const Gas& gas) {
  backend.collide({.want_pairs = true});
  return contact_statistics(gas.scene, current_state(backend).wide, backend.pairs(), 0);
}

void move(Backend& backend, uint64_t steps) {
  for (uint64_t step = 0; step < steps; ++step) backend.move();
}

double temperature(double kinetic, uint64_t n) { return 2 * kinetic / (3 * double(n)); }  // times Boltzmann's constant

// Of a hard wall that the centres reach, times d^2 / k T: Reiss, Frisch, Helfand, Lebowitz, J. Chem. Phys. 32 (1960)
// 119.
double surface_tension(double f) { return -9 / (2 * std::numbers::pi) * f * f * (1 + f) / std::pow(1 - f, 3); }

}  // namespace

double compressibility(double f) { return (1 + f + f * f - f * f * f) / std::pow(1 - f, 3); }
double contact_value(double f) { return (1 - f / 2) / std::pow(1 - f, 3); }

Gas equilibrated_gas(Backend& backend, const Scene& start, double seconds, float restitution) {
  Gas gas{start, 2 * double(start.positions.at(0).w), sphere_mass(double(start.positions.at(0).w))};
  backend.upload(gas.scene);
  move(backend, uint64_t(std::ceil(seconds / double(start.dt))));
  const Backend::State state = current_state(backend);
  gas.scene.positions = state.positions, gas.scene.velocities = state.velocities;
  gas.scene.restitution = restitution;
  return gas;
}

// In a box that the centres reach over a length l, 2 K + virial = 3 (p l^3 - 4 tension l^2).
Pressure measure_pressure(Backend& backend, const Gas& gas, uint64_t samples, uint64_t steps) {
  double sum = 0, heat = 0, bulk = 0;
  backend.upload(gas.scene);
  for (uint64_t sample = 0; sample < samples; ++sample) {
    move(backend, steps);
    const ContactStatistics now = statistics_of(backend, gas);
    sum += (2 * now.kinetic + now.virial) / double(samples);
    heat += temperature(now.kinetic, gas.scene.size()) / double(samples);
    bulk += bulk_fraction(gas, current_state(backend).positions) / double(samples);
  }
  const double length = double(gas.scene.contact.high.x) / gas.diameter - 1;  // in diameters
  const double pressure = sum / heat / (3 * std::pow(length, 3)) + 4 * surface_tension(bulk) / length;
  return {pressure, compressibility(bulk) * bulk * 6 / std::numbers::pi, bulk};
}

double expected_tau(const Gas& gas, double bulk, double kinetic) {
  const double lost = 1 - squared(double(gas.scene.restitution));
  const double speed = std::sqrt(temperature(kinetic, gas.scene.size()) / gas.mass);
  const double density = bulk * 6 / std::numbers::pi / gas.diameter;  // times the squared diameter
  return 3 / (2 * lost * density * contact_value(bulk) * std::sqrt(std::numbers::pi) * speed);
}

double Cooling::tau() const { return seconds / (std::sqrt(first / last) - 1); }
double Cooling::expected_last() const { return first / squared(1 + seconds / expected); }

Cooling measure_cooling(Backend& backend, const Gas& gas, uint64_t samples, uint64_t steps) {
  backend.upload(gas.scene);
  const double first = statistics_of(backend, gas).kinetic;
  double bulk = 0;
  for (uint64_t sample = 0; sample < samples; ++sample) {
    move(backend, steps);
    bulk += bulk_fraction(gas, current_state(backend).positions) / double(samples);
  }
  return {.seconds = double(samples * steps) * double(gas.scene.dt),
          .first = first,
          .last = statistics_of(backend, gas).kinetic,
          .expected = expected_tau(gas, bulk, first),
          .packing_fraction = bulk};
}

}  // namespace spherepair
