// SPDX-License-Identifier: MIT
// Laws of contacts in real numbers: energy, damping, and the greatest sum of impulses in a step.
#pragma once

#include "common/scene/contact/contact_options.h"

namespace spherepair {

struct Radii {
  float smallest = 0, largest = 0;
};

double sphere_mass(double radius);  // kg, of water; see times_water for another density

// Returns the energy in joules that a contact with this overlap and reach stores.
double contact_energy(ContactLaw law, double stiffness, double overlap, double reach);

// Returns the overlap in metres at which a contact with this reach stores this energy.
double overlap_of_energy(ContactLaw law, double stiffness, double energy, double reach);

// Returns the shortest contact, in seconds, that spheres of these radii can have: for `hertz` at this closing speed,
// for the other laws at any.
double shortest_contact(ContactLaw law, double stiffness, Radii radii, double closing_speed, double restitution = 1);

// Returns the damping, relative to critical, with which a contact that never pulls leaves this share of the speed.
double damping_ratio(double restitution);

// Returns the time of a contact with this damping, relative to critical. Without damping it lasts pi.
double damped_time(double ratio);

// Returns the default number of steps in the shortest contact. A damper's force begins at once, somewhere within a
// step. So a restitution e is off by up to ln(1/e) / steps of itself: at most a 60th with this number.
double default_steps(double restitution);

// Returns an upper bound, in kg m/s, on the momentum of any sphere plus all impulses on it in a step, whatever their
// signs. It assumes that no overlap exceeds the smaller radius and no sphere moves by more than the smallest radius in
// a step. A step beyond that is a fault.
struct StepBounds {
  ContactLaw law;
  double stiffness, restitution, gravity, dt;
  Radii radii;
};
double greatest_impulse_sum(const StepBounds& step);

}  // namespace spherepair
