// SPDX-License-Identifier: MIT
// Lower bounds of a collision step's time on a GPU, from its peak rates (roofline).
#pragma once

#include <optional>

#include "bench/measure/session.h"
#include "bench/measure/timing.h"

namespace spherepair {

// The minimum for a pair in Gram form: three fused multiply-adds and a comparison.
constexpr int instructions_per_pair = 4;

// Minimum memory traffic of the grid in bytes per sphere, packing fraction 0.3, equal radii. The cell table takes 7
// bytes per sphere and counts as written only, since it may be read from the cache. In cell order: the position, read
// for the table and for the search; the table; the count. In random order: the position, read by the split, the sort
// and the search and written by the split and the sort, with the sphere's index in place of its radius; the table; the
// count. Above 1.2 million spheres, which need a second split, the actual traffic is 64 bytes more.
constexpr double grid_bytes_in_cell_order = 2 * 16 + 7 + 4, grid_bytes_in_random_order = 5 * 16 + 7 + 4;

// Lane-instructions per second of the GPU, from CUDA's device properties: multiprocessors x 128 lanes x highest clock.
// NaN if CUDA is not open.
double issue_rate(const Session& session);

// Returns the kernels that measure this device. Throws BackendError for the CPU: it has none.
PeakRateKernels& peak_rates_of(Backend& backend);

// Bytes per second, read and written, that a device copies beyond its caches. Replaces the uploaded scene.
double copy_rate(Session& session, Backend& device, const Sampling& sampling, Progress& progress);

// Bytes that a step touches at least once with equal radii: its working set. A search touches positions and counts, the
// grid also the table, and in random order the copies of the split and the sort with their indices.
uint64_t motion_set_bytes(uint64_t n, MotionOptions motion);
uint64_t search_set_bytes(uint64_t n, Method method, bool in_cell_order);
constexpr uint64_t shared_set_bytes = 16 + 4;  // a sphere, in all searches: position and count
constexpr uint64_t copy_set_bytes = 2 * 16;    // a sphere, when the peak rate of copying is measured

struct PeakRates {
  double issue = 0;                       // lane-instructions per second; NaN or 0: unknown
  std::map<const Backend*, double> copy;  // bytes per second
};

struct Floor {
  const char* what;   // bytes or instructions
  double per_second;  // peak rate
  double seconds;
};

// None if no peak rate is known, in software, and for other methods.
std::optional<Floor> floor_of(const PeakRates& peak_rates, const Backend& backend, Method method, uint64_t n,
                              bool in_cell_order);

}  // namespace spherepair
