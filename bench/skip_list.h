// SPDX-License-Identifier: MIT
// Everything that `spherepair skips` turns on and off.
#pragma once

#include <functional>

#include "backend.h"

namespace spherepair {

// What a skip is timed with, n spheres of the scene `uniform`.
enum class Spheres {
  random,         // in random order
  in_cell_order,  // in that of the cells
  windy           // every step moves all of them sideways, by their diameter or so; all have left their first cells
};

// One thing, as the options of a step with it and without.
struct Skip {
  const char *name, *summary;
  const char* backend;  // the only one that has it; empty: all
  CollideOptions on, off;
  Spheres spheres = Spheres::random;
  bool reads_off = false;                 // without it, the host reads the totals after every step
  bool OpenOptions::*open_off = nullptr;  // without it, another backend is opened with this false
};

const std::vector<Skip>& skip_list();

}  // namespace spherepair
