// SPDX-License-Identifier: MIT
// Rows of a list of pairs: for each of a few points the keys of all targets within its reach. On vectors of float32.
#pragma once

#include <span>

#include "common/scene/host_buffer.h"
#include "common/shared/portable.h"

namespace spherepair {

// One array per component. Each must have room for a whole vector after its last target, as Buffer provides.
struct RowTargets {
  const float *x, *y, *z;
  const float* radius;  // null when all reaches are equal
  const uint* key;
};

struct TargetRange {
  uint first, last;  // to before last
};

// Targets one behind another. Vectors after the last hold none that is in reach.
struct RowBlock {
  Buffer<float> x, y, z, radius;
  Buffer<uint> key;
  uint count = 0, room = 0;
  // Makes room for so many targets; more than before lose the contents.
  void make_room(uint targets) {
    if (targets >= room) grow(targets);
  }
  void end(uint targets);  // sets count and what is behind

 private:
  void grow(uint targets);
};

// With s the squared distance in float32: targets with s <= near are in the row, of which those with s >= sure are
// open. Where there are radii, s is less the square of their sum.
struct RowLimits {
  float near, sure;
  bool sized;
};

struct RowPoint {
  float x, y, z, radius;
  uint least, skipped;  // only keys from `least` on and other than `skipped` count
};

struct FoundRow {
  uint count;
  bool open;  // whether some of the keys are of open targets
};

constexpr uint row_slack = 32;  // keys, or targets: two of the widest vectors

struct RowSimd {
  const char* name;
  // Copies the targets of all ranges.
  void (*collect)(const RowTargets& from, std::span<const TargetRange> ranges, bool sized, RowBlock& to);
  // Writes the keys of all rows, one row behind another, each in ascending order. Targets before `first` are in no row.
  // in_order: the block's keys ascend. `keys` has room for points x targets + row_slack.
  void (*find)(const RowBlock& block, uint first, bool in_order, std::span<const RowPoint> points, RowLimits limits,
               uint* keys, FoundRow* rows);
};

std::span<const RowSimd> row_simds();  // the sets that this machine can run, the fastest first

}  // namespace spherepair
