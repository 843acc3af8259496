// SPDX-License-Identifier: MIT
// Everything that `spherepair ablate` turns on and off.
#pragma once

#include <functional>
#include <optional>

#include "common/backend/backend.h"

namespace spherepair {

// The spheres of a timing: n spheres of the scene `uniform` unless stated otherwise.
enum class Spheres {
  random,         // in random order
  in_cell_order,  // sorted into cell order
  drifting,       // move sideways by about a diameter in every step, and have all left their first cells
  falling,        // n spheres of the scene `random`, which fall and bounce by the method anchored
  pushing,        // n spheres of the scene `gas`, which push each other
  at_all_walls    // the same, each tested against all walls
};

// The work of a timed step.
enum class AblationWork {
  collide,  // a collision step, after a move if the spheres drift
  bounce,   // a move of `anchored`, event-driven or testing every sphere
  push,     // a move with contacts, with the list of near pairs kept or made in every step
  walls,    // a move with contacts
  copy      // copies 16 bytes per sphere, in 16-byte or 4-byte accesses
};

// Results that the host reads after every step.
enum class Reads { nothing, totals, counts };

// One optimisation or API feature: the options of a collision step with it and without it.
struct Ablation {
  const char *name, *summary;  // summary: what it does when on
  const char* backend;         // the only backend that has it; empty: all
  CollideOptions on = {}, off = {};
  Spheres spheres = Spheres::random;
  Reads reads_off = Reads::nothing;       // read after every step when off
  bool OpenOptions::*open_off = nullptr;  // when off, another backend is opened with this option false
  AblationWork work = AblationWork::collide;
  std::optional<Spheres> spheres_off = {};  // the spheres when off
};

inline Spheres spheres_of(const Ablation& a, bool on) { return on ? a.spheres : a.spheres_off.value_or(a.spheres); }

const std::vector<Ablation>& ablation_list();

}  // namespace spherepair
