// SPDX-License-Identifier: MIT
// What a law of contacts gives two spheres, in real numbers: energy, damping, and the most that a step can add up to.
#pragma once

#include "common/scene/contact/contact_options.h"

namespace spherepair {

struct Radii {
  float smallest = 0, largest = 0;
};

double sphere_mass(double radius);  // in kg: all spheres are of water

// What a contact of this overlap and reach stores, in joules.
double contact_energy(ContactLaw law, double stiffness, double overlap, double reach);

// The overlap at which a contact of this reach stores so many joules.
double overlap_of_energy(ContactLaw law, double stiffness, double energy, double reach);

// The shortest contact that spheres of these radii can have, in seconds: of `hertz` at this closing speed, of the
// others at any.
double shortest_contact(ContactLaw law, double stiffness, Radii radii, double closing_speed, double restitution = 1);

// Damping over its critical value for which a contact that never pulls leaves this share of the speed.
double damping_ratio(double restitution);

// How long a contact with this damping over its critical value lasts, in units in which one without lasts pi.
double damped_time(double ratio);

// Steps that the shortest contact lasts by default. A damper's force begins at once, somewhere in a step, so that up to
// ln(1/e) / steps of a restitution e is wrong: with these steps at most a 60th.
double default_steps(double restitution);

// In kg m/s: more than the sum of the momentum of any sphere and all impulses on it in a step, whatever their signs,
// where no overlap is greater than the smaller radius and no sphere moves by more than the smallest in a step. Any step
// beyond that is a fault.
struct StepBounds {
  ContactLaw law;
  double stiffness, restitution, gravity, dt;
  Radii radii;
};
double greatest_impulse_sum(const StepBounds& step);

}  // namespace spherepair
