// SPDX-License-Identifier: MIT
// Chooses the cells of a scene: dense or hashed, how large, how many levels. This decides the time, never the set.
#pragma once

#include "common/scene/scene.h"

namespace spherepair {

enum class Cells { automatic, dense, hashed };

// A table has at most this many cells a sphere, but may always have least_slots.
constexpr uint64_t slots_per_sphere = 2;
constexpr uint64_t least_slots = 1024;

struct GridPlan {
  Cells cells = Cells::dense;
  float origin[3] = {0, 0, 0};  // metres
  float side = 1;               // of a cell of level 0, metres
  float largest_radius = 0;     // of level 0, metres
  bool equal_radii = true;
  uint size[3] = {1, 1, 1};  // cells of level 0 along each axis; dense only
  uint slots = 1;            // of the table
  uint first_octave = 255;   // biased exponent of the radii of level 0
  uint top_level = 0;
  uint levels = 1;  // bit k is set when level k has spheres
};

// The plans for dense and for hashed cells, and the one that Cells::automatic takes. They depend on the extent, the
// radii and a sample of the positions.
struct GridPlans {
  GridPlan dense, hashed;
  GridPlan light = {};  // dense, with one table a level if radii differ much: only for draw_light
  float smallest_radius = 0;
  std::vector<uint> octaves = {};  // of the radii, each once
  Cells chosen = Cells::dense;
  double dense_occupancy = 0, hashed_occupancy = 0;  // mean number of other spheres in a sphere's cell
  std::string reason = {};                           // one sentence: the choice and its figures

  const GridPlan& plan(Cells wanted) const {
    return (wanted == Cells::automatic ? chosen : wanted) == Cells::dense ? dense : hashed;
  }
  double occupancy(Cells wanted) const {
    return plan(wanted).cells == Cells::dense ? dense_occupancy : hashed_occupancy;
  }
};
GridPlans plan_grids(const std::vector<vec4>& spheres);
// Plans for n spheres of the same radii that have moved; `sample` holds some of them from all over the scene. Spheres
// outside the sample's extent go into the cells along the border.
GridPlans plan_grids_anew(const GridPlans& before, const std::vector<vec4>& sample, uint64_t n);
inline GridPlan plan_grid(const Scene& scene, Cells wanted) { return plan_grids(scene.positions).plan(wanted); }

// How the sort groups a table's slots. A bucket is a range of 2^shift slots: CELLS_PER_BUCKET, or fewer if a bucket
// would hold too many spheres on average for grid_sort, or if there would be fewer than least_buckets. Buckets are
// split in one pass by split_tiles if one of its groups can tell them apart and a group of grid_sort has a thread for
// each tile. Otherwise they are first split into parents, ranges of 2^parent_shift slots, whose buckets one group of
// grid_split can tell apart.
struct BucketPlan {
  uint shift, buckets, parent_shift;  // parent_shift: ONE_PARENT if split_tiles splits in one pass
};
BucketPlan plan_buckets(uint64_t spheres, uint slots, uint least_buckets);

GridParams grid_params(const GridPlan& plan);

}  // namespace spherepair
