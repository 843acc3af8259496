// SPDX-License-Identifier: MIT
// The least time that a collision step can take on a GPU: what its time is a share of.
#pragma once

#include <optional>

#include "bench/measure/session.h"
#include "bench/measure/timing.h"

namespace spherepair {

// Three fused multiply-adds and a comparison: the least for a pair in the Gram form.
constexpr int instructions_per_pair = 4;

// Bytes a sphere that the grid must move, packing fraction 0.3 (7 bytes of table a sphere, which need be written only:
// they may be read in the cache), equal radii. In cell order: the position read for the table and again for the search,
// the table, a count. In random order: the position read to split and to sort it and for the search, and written by the
// split and the sort, its number in the place of its radius; the table, a count. Where one split does not do, above 1.2
// million spheres, what is done takes 64 more.
constexpr double grid_bytes_in_cell_order = 2 * 16 + 7 + 4, grid_bytes_in_random_order = 5 * 16 + 7 + 4;

// Lane-instructions a second of the GPU as CUDA describes it: multiprocessors x 128 lanes x highest clock. NaN when
// CUDA is not open.
double issue_rate(const Session& session);

// Bytes a second, read and written, that a device copies beyond its caches. The device holds another scene after it.
double copy_rate(Backend& device, const Sampling& sampling, Progress& progress);

struct PeakRates {
  double issue = 0;                       // lane-instructions a second, NaN or 0: unknown
  std::map<const Backend*, double> copy;  // bytes a second
};

struct Floor {
  const char* what;   // bytes or instructions
  double per_second;  // at best
  double seconds;
};

// None where no ceiling is known: in software, or for a method that has none here.
std::optional<Floor> floor_of(const PeakRates& peak_rates, const Backend& backend, Method method, uint64_t n,
                              bool in_cell_order);

}  // namespace spherepair
