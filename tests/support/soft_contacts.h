// SPDX-License-Identifier: MIT
// Scenes whose spheres push each other often within few steps, by soft contacts, and their way back.
#pragma once

#include <span>

#include "common/scene/contact/contact_options.h"
#include "tests/support/motion_runs.h"

namespace spherepair {

struct GasOptions {
  uint64_t side = 6;  // spheres along an edge of the box
  float ratio = 1, gravity = 0, restitution = 1;
  ContactLaw law = ContactLaw::quartic;
  float from = 0;  // the box begins there along every axis, in metres
  double steps_a_contact = 40;
  uint seed = 28;
};

// A closed box of spheres on a lattice, which leaves them room, with random velocities; radii up to ratio * 0.5.
Scene gas(const GasOptions& options);

// Two shells of small spheres that fall onto one eight times as large: the outer runs into the inner on its way back.
Scene shells(ContactLaw law);

// Of the wide state of a scene with contacts: six of each sphere, axis by axis, positions before momenta.
inline int64_t word(const std::vector<uint>& wide, uint64_t k) { return load_real<int64_t>(wide, k); }

// Spheres, and such a state, with sphere order[k] in place k.
std::vector<uint> shuffled(uint64_t n);
Scene in_order(const Scene& scene, std::span<const uint> order);
std::vector<uint> in_order(const std::vector<uint>& wide, std::span<const uint> order);

Scene with(Scene scene, const Backend::State& state);

// The wide state after so many steps, and as many back. One contact may be dropped once, at the turn.
std::vector<uint> there_and_back(Backend& backend, const Scene& scene, uint64_t steps, bool drops_a_contact);

}  // namespace spherepair
