// SPDX-License-Identifier: MIT
// The grid's loops on vectors, for one instruction set: slot numbers, and the search of a half neighbourhood.
#pragma once

#include <span>

#include "common/scene/pair_set.h"
#include "common/shared/hash.h"
#include "common/shared/layout.h"

namespace spherepair {

// Spheres in cell order, one array per component. Each array must have room for a whole vector after its last sphere,
// as Buffer provides.
struct CellOrder {
  const float *x, *y, *z;
  const float* radius;  // null when all are Params.radius
  const uint* id;       // sphere index at each place
  const uint* begin;    // first place of each slot, and the end of the last
};

// Pairs of places that are in reach of each other. UNDECIDED_BIT is set in `other` if the filter left the pair open.
constexpr uint UNDECIDED_BIT = 0x80000000u;
constexpr uint candidates_at_once = 2048;
constexpr uint spheres_at_once = 8;  // consecutive spheres that are tested against the same vector of others
constexpr uint quad = 4;             // consecutive spheres whose candidate pairs make one mask
constexpr uint widest_vector = 16;
struct Candidates {
  alignas(64) uint mine[candidates_at_once + widest_vector], other[candidates_at_once + widest_vector];
  uint size = 0;
};

class CandidateSink {
 public:
  virtual void take(Candidates& candidates) = 0;  // processes and empties them

 protected:
  ~CandidateSink() = default;
};

struct GridSimd {
  const char* name;
  // Computes slot_of for every sphere. radii: separate if w holds a sphere's index.
  void (*find_slots)(const vec4* spheres, const float* radii, uint count, const GridParams& g, uint* slots);
  // Finds the pairs of every sphere from sorted index `first` to before `last` with its half neighbourhood.
  void (*find_candidates)(const CellOrder& order, const Params& p, uint first, uint last, Candidates& found,
                          CandidateSink& sink);
  // Writes first << 32 | second for the spheres of each pair of places; returns the sum of their fingerprints.
  Fingerprint (*mix)(const Candidates& candidates, const uint* id, uint64_t* keys);
};

std::span<const GridSimd> grid_simds();  // the sets that this machine can run, the fastest first

}  // namespace spherepair
