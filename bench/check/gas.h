// SPDX-License-Identifier: MIT
// Measures a gas of spheres that push each other in a box, and predicts it by the kinetic theory of hard spheres.
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

// The packing fraction away from the walls of a gas at rest, by the theory of the layers at its walls.
double fraction_at_rest(const Scene& scene);
// Moves the spheres of a lattice towards the middle, to their density at rest. Otherwise sound waves, which last long
// in a large box, would go out from the walls.
void squeeze(Scene& scene);

// Moves the gas in the backend for so many seconds from its start. It is in equilibrium with its walls once sound, at 2
// m/s or more, has crossed the box several times; a dense gas needs more.
Gas equilibrated_gas(Motion& motion, const Scene& start, double seconds);

// The measured pressure, and the theory's for the packing fraction away from the walls.
struct Pressure {
  double found, expected;  // p d^3 / (k T)
  double packing_fraction;
  double error;  // standard error of `found`, over `found`
};
double expected_pressure(double packing_fraction);  // p d^3 / (k T)

// The mean of `samples` samples, `steps` steps apart, from the current state.
Pressure measure_pressure(Backend& backend, const Gas& gas, uint64_t samples, uint64_t steps);

// Haff, J. Fluid Mech. 134 (1983) 401: T = T0 / (1 + t / tau)^2, with Enskog's collision rate.
struct Cooling {
  double seconds, first, last;  // kinetic energies, in joules
  double expected;              // tau, in seconds
  double packing_fraction;
  std::vector<double> energies;  // after each sample, as `last`
  double tau() const;            // measured
};
// Moves samples * steps steps. The packing fraction is the mean over the samples.
Cooling measure_cooling(Backend& backend, const Gas& gas, uint64_t samples, uint64_t steps);

// tau in seconds of the gas at its start, with velocities between -1 and 1 m/s along each axis.
double expected_tau(const Gas& gas, double packing_fraction, double kinetic);

}  // namespace spherepair
