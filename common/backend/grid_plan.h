// SPDX-License-Identifier: MIT
// Which cells a scene gets: dense or hashed, how large, how many levels. The choice decides the time, never the set.
#pragma once

#include "common/scene/scene.h"

namespace spherepair {

enum class Cells { automatic, dense, hashed };

// Cells of a table are at most this many times the spheres, and at least least_slots.
constexpr uint64_t slots_per_sphere = 2;
constexpr uint64_t least_slots = 1024;

struct GridPlan {
  Cells cells = Cells::dense;
  float origin[3] = {0, 0, 0};  // metres
  float side = 1;               // of a cell of level 0, metres
  float largest_radius = 0;     // of level 0
  bool equal_radii = true;
  uint size[3] = {1, 1, 1};  // cells of level 0 along each axis; dense only
  uint slots = 1;            // of the table
  uint first_octave = 255;   // biased exponent of the radii of level 0
  uint top_level = 0;
  uint levels = 1;  // bit k is set when level k has spheres
};

// Both kinds for a scene, and which of them Cells::automatic takes, by the extent, the radii and a sample of the
// places.
struct GridPlans {
  GridPlan dense, hashed;
  GridPlan light = {};  // dense, with a table for each level where radii differ much: for draw_light, not for searches
  float smallest_radius = 0;
  std::vector<uint> octaves = {};  // of the radii, each once
  Cells chosen = Cells::dense;
  double dense_occupancy = 0, hashed_occupancy = 0;  // other spheres in a sphere's cell, on average
  std::string reason = {};                           // one sentence: what was chosen, from which figures

  const GridPlan& plan(Cells wanted) const {
    return (wanted == Cells::automatic ? chosen : wanted) == Cells::dense ? dense : hashed;
  }
  double occupancy(Cells wanted) const {
    return plan(wanted).cells == Cells::dense ? dense_occupancy : hashed_occupancy;
  }
};
GridPlans plan_grids(const std::vector<vec4>& spheres);
// The same for n spheres of the same radii that have moved, of which these are a sample from all over the scene. Those
// beyond its extent will stand in the cells along the border.
GridPlans plan_grids_anew(const GridPlans& before, const std::vector<vec4>& sample, uint64_t n);
inline GridPlan plan_grid(const Scene& scene, Cells wanted) { return plan_grids(scene.positions).plan(wanted); }

// A table's slots in buckets, ranges of 2^shift slots, and these, where one group of split_tiles cannot tell them apart
// or there are more tiles than a group of grid_sort has threads, in ranges of 2^parent_shift slots, which one group of
// grid_split can tell apart. A bucket has CELLS_PER_BUCKET slots, or fewer where that many hold more spheres on average
// than grid_sort should have, or make fewer buckets than these.
struct BucketPlan {
  uint shift, buckets, parent_shift;  // ONE_PARENT: one split, by tiles
};
BucketPlan plan_buckets(uint64_t spheres, uint slots, uint least_buckets);

GridParams grid_params(const GridPlan& plan);

}  // namespace spherepair
