// SPDX-License-Identifier: MIT
// A gas of spheres that push each other, in its box: what kinetic theory knows of hard spheres, and its measurement.
#pragma once

#include "common/backend/backend.h"

namespace spherepair {

// p / (n k T) of Carnahan and Starling, J. Chem. Phys. 51 (1969) 635, by packing fraction, and their contact value.
double compressibility(double packing_fraction);
double contact_value(double packing_fraction);

struct Gas {
  Scene scene;  // with walls and equal radii, without gravity
  double diameter, mass;
};

// The packing fraction away from the walls of a gas at rest, by what theory says that the layers at its walls hold.
double fraction_at_rest(const Scene& scene);
// Moves the spheres of a lattice towards the middle, so that they fill it as densely as at rest: no waves of sound go
// out from the walls, which last long in a large box.
void squeeze(Scene& scene);

// Moves the gas so many seconds from its start in the backend. It is in equilibrium with its walls once sound, at 2 m/s
// or more, has crossed the box several times; a dense gas needs more.
Gas equilibrated_gas(Backend& backend, const Scene& start, double seconds);

// Found, and what theory expects of the packing fraction away from the walls, where centres stand in layers.
struct Pressure {
  double found, expected;  // p d^3 / (k T)
  double packing_fraction;
  double error;  // standard error of what is found, over it
};
double expected_pressure(double packing_fraction);  // p d^3 / (k T)

// The mean of so many samples, that many steps apart, from where the spheres stand.
Pressure measure_pressure(Backend& backend, const Gas& gas, uint64_t samples, uint64_t steps);

// Haff, J. Fluid Mech. 134 (1983) 401: T = T0 / (1 + t / tau)^2, with Enskog's collision rate.
struct Cooling {
  double seconds, first, last;  // kinetic energies, in joules
  double expected;              // tau, in seconds
  double packing_fraction;
  std::vector<double> energies;  // after each sample, as `last`
  double tau() const;            // found
};
// Of samples * steps steps; the packing fraction is the mean of those after each `steps`.
Cooling measure_cooling(Backend& backend, const Gas& gas, uint64_t samples, uint64_t steps);

// Seconds, of the gas as it starts, with velocities between -1 and 1 m/s along each axis.
double expected_tau(const Gas& gas, double packing_fraction, double kinetic);

}  // namespace spherepair
