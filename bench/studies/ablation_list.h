// SPDX-License-Identifier: MIT
// Everything that `spherepair skips` turns on and off.
#pragma once

#include <functional>

#include "common/backend/backend.h"

namespace spherepair {

// What a skip is timed with, n spheres of the scene `uniform` where nothing else is said.
enum class Spheres {
  random,         // in random order
  in_cell_order,  // in that of the cells
  windy,          // every step moves all of them sideways, by their diameter or so; all have left their first cells
  falling         // n spheres of the scene `random` instead, that fall and bounce by the method anchored
};

// What a step is.
enum class Work {
  collide,  // a collision step, after a move where spheres are windy
  bounce,   // a move of `anchored`, looking at spheres that are due or at all
  copy      // of 16 bytes a sphere, whole or a word at a time
};

// What the host reads after every step.
enum class Reads { nothing, totals, counts };

// One thing, as the options of a collision step with it and without.
struct Ablation {
  const char *name, *summary;
  const char* backend;  // the only one that has it; empty: all
  CollideOptions on = {}, off = {};
  Spheres spheres = Spheres::random;
  Reads reads_off = Reads::nothing;       // without it
  bool OpenOptions::*open_off = nullptr;  // without it, another backend is opened with this false
  Work work = Work::collide;
};

const std::vector<Ablation>& ablation_list();

}  // namespace spherepair
