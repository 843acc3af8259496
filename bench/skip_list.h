// SPDX-License-Identifier: MIT
// Everything that `spherepair skips` turns on and off.
#pragma once

#include <functional>

#include "backend.h"

namespace spherepair {

// One thing, as the options of a step with it and without.
struct Skip {
  const char *name, *summary;
  const char* backend;  // the only one that has it; empty: all
  CollideOptions on, off;
  bool ordered = false;                   // the spheres stand in cell order
  bool reads_off = false;                 // without it, the host reads the totals after every step
  bool OpenOptions::*open_off = nullptr;  // without it, another backend is opened with this false
  bool wind = false;                      // every step moves all spheres sideways, by their diameter or so
};

const std::vector<Skip>& skip_list();

}  // namespace spherepair
