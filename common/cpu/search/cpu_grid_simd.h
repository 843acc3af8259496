// SPDX-License-Identifier: MIT
// The grid's loops that run on vectors, for one instruction set: cell numbers, and the search of a half neighbourhood.
#pragma once

#include <span>

#include "common/scene/pair_set.h"
#include "common/shared/hash.h"
#include "common/shared/layout.h"

namespace spherepair {

// Spheres in cell order, one array per component. Each array must have room for a whole vector behind its last sphere,
// as Buffer gives it.
struct CellOrder {
  const float *x, *y, *z;
  const float* radius;  // null when all are Params.radius
  const uint* id;       // which sphere stands at each place
  const uint* begin;    // of each slot, and of the one behind the last
};

// Pairs of places that are in reach of each other; UNDECIDED_BIT is set in `other` where the filter leaves it open.
constexpr uint UNDECIDED_BIT = 0x80000000u;
constexpr uint candidates_at_once = 2048;
constexpr uint spheres_at_once = 8;  // of a row of cells, that are tested against the same vector of others
constexpr uint quad = 4;             // of these, whose candidate pairs are one mask
constexpr uint widest_vector = 16;
struct Candidates {
  alignas(64) uint mine[candidates_at_once + widest_vector], other[candidates_at_once + widest_vector];
  uint size = 0;
};

class CandidateSink {
 public:
  virtual void take(Candidates& candidates) = 0;  // and empties them

 protected:
  ~CandidateSink() = default;
};

struct GridSimd {
  const char* name;
  // slot_of every sphere; radii of records stand apart, since w has their index.
  void (*find_slots)(const vec4* spheres, const float* radii, uint count, const GridParams& g, uint* slots);
  // Every pair that a sphere from sorted index first to last has in its half neighbourhood.
  void (*find_candidates)(const CellOrder& order, const Params& p, uint first, uint last, Candidates& found,
                          CandidateSink& sink);
  // first << 32 | second of the pairs of spheres at these places, and the sum of their fingerprints.
  Fingerprint (*mix)(const Candidates& candidates, const uint* id, uint64_t* keys);
};

std::span<const GridSimd> grid_simds();  // those that this machine can run, the fastest first

}  // namespace spherepair
