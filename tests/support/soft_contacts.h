// SPDX-License-Identifier: MIT
// Scenes with soft contacts, whose spheres push each other often within a few steps; and runs there and back.
#pragma once

#include <span>

#include "common/scene/contact/contact_options.h"
#include "tests/support/motion_runs.h"

namespace spherepair {

struct GasOptions {
  uint64_t side = 6;  // spheres along an edge of the box
  float ratio = 1, gravity = 0, restitution = 1;
  ContactLaw law = ContactLaw::quartic;
  float from = 0;  // the lower corner of the box along every axis, in metres
  double steps_a_contact = 40;
  uint seed = 28;
};

// A closed box of spheres on a lattice that leaves gaps, with random velocities; radii up to ratio * 0.5.
Scene gas(const GasOptions& options);

// Two shells of small spheres that fall onto one eight times as large: the outer runs into the inner on its way back.
Scene shells(ContactLaw law);

// Number k of the wide state of a scene with contacts. It has six numbers for each sphere, axis by axis, positions
// before momenta.
inline int64_t word(const std::vector<uint>& wide, uint64_t k) { return load_real<int64_t>(wide, k); }

// Reorders spheres, and such a state, so that sphere order[k] is in place k.
std::vector<uint> shuffled(uint64_t n);
Scene in_order(const Scene& scene, std::span<const uint> order);
std::vector<uint> in_order(const std::vector<uint>& wide, std::span<const uint> order);

Scene with(Scene scene, const Motion::State& state);

// That a list of near pairs serves many steps and changes no bit; where it is not kept, each step lists its pairs.
void expect_near_pairs_listed_seldom(Backend& backend, const Scene& scene);

// The wide state after `steps` steps and as many back. With drops_a_contact, one contact is dropped once, at the turn.
std::vector<uint> there_and_back(Backend& backend, const Scene& scene, uint64_t steps, bool drops_a_contact);

}  // namespace spherepair
