// SPDX-License-Identifier: MIT
// How a collision step is done, and what it answers.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/backend/grid_plan.h"
#include "common/scene/pair_set.h"
#include "common/shared/exact.h"

namespace spherepair {

enum class Method {
  sequential,        // CPU only: the paper's code 2, one thread, double loop
  parallel,          // CPU only: all cores, SIMD
  collide_group,     // the paper's code 4: pairs within a group of `block` consecutive spheres only
  collide_tiled,     // the paper's code 5: every group through shared memory, each ordered pair tested
  collide_square,    // two-dimensional arrangement, a single loop
  collide_triangle,  // each unordered pair once, several spheres per thread: the fastest of all pairs
  collide_tensor,    // the same through tensor cores: CUDA on GPUs of compute capability 9.0 only
  collide_grid,      // only the spheres of neighbouring cells
  automatic,         // collide_grid or the fastest of all pairs, whichever crossover.h expects to be faster
};

const char* method_name(Method method);
Method method_from_name(const std::string& name);  // throws std::invalid_argument with the known names
std::vector<Method> device_methods();              // those that GLSL and CUDA mirror
std::span<const uint> block_sizes();               // 32, 64 ... 1024
std::span<const uint> small_block_sizes();         // 8, 16: of collide_tiled only, for the paper's arrangements

// How spheres are put into cell order: by counting them by cell, by splitting them into buckets of cells first, or by
// the radix sort of a library (CUDA: Thrust).
enum class Sort { automatic, counting, buckets, radix };

// What the grid may skip or do in another way, each to be measured against its opposite.
struct GridOptions {
  Cells cells = Cells::automatic;
  bool keep_order = true;  // spheres that stand in cell order already are not sorted again
  bool keep_cells = true;  // spheres that have not moved keep the cells of the last step
  Sort sort = Sort::automatic;
  bool replan = true;  // cells are planned anew when spheres may have left those of the last plan
  auto operator<=>(const GridOptions&) const = default;
};

constexpr std::array<uint, 4> graph_sizes = {1, 4, 16, 64};  // steps that a graph may hold

// What not every backend offers, each to be measured against going without. Absent: what was measured to be faster. A
// backend that lacks what is asked for throws std::invalid_argument, which names it.
struct ApiOptions {
  // CUDA and Vulkan: a step's launches are recorded once, and replayed while none changes. Absent: on
  std::optional<bool> graph = {};
  // CUDA and Vulkan: equal steps that nobody waits for are replayed together, at most so many, one of graph_sizes.
  // Absent: the last
  std::optional<uint> graph_steps = {};
  // OpenGL and Vulkan: collide_grid reads the table of cells through a texture buffer, in OpenGL in parts where one is
  // too small. Absent: on where it fits
  std::optional<bool> texture_table = {};
  // All: the API's function clears the table, in place of a kernel. Absent: off
  std::optional<bool> library_clear = {};
  // All GPU APIs: a step's launches go out together; OpenGL sets only the barriers that they need. Off: the host waits
  // for each launch; OpenGL sets GL_ALL_BARRIER_BITS, CUDA and Vulkan replay nothing. Absent: on
  std::optional<bool> batch = {};
  // All GPU APIs; CUDA from 12.3 on, with kernels compiled for compute capability 9.0 or later. The start of a step
  // runs beside the search of the step before where neither writes what the other uses, also between replayed steps. In
  // CUDA later launches of a step also start early and wait in the kernel. Absent: on
  std::optional<bool> overlap = {};
  auto operator<=>(const ApiOptions&) const = default;
};

struct CollideOptions {
  Method method = Method::collide_triangle;
  uint block = 128;         // group size of the kernel; decides the set only for collide_group. With `automatic`, 128
                            // leaves it to crossover.h
  bool exact = true;        // false: the naive float32 predicate, to measure what exactness costs
  bool want_pairs = false;  // keep the pairs for pairs()
  uint columns = 0;         // of collide_triangle: columns that one group tests; 0: chosen by n. Never changes the set
  GridOptions grid = {};    // of collide_grid. Never changes the set
  // Pairs that touch at any time within the next step, on the paths that the motion takes from the float32 numbers
  // nearest to the state, bounces included (swept.h). `method` finds the spheres whose paths are near each other;
  // collide_group throws std::invalid_argument.
  bool swept = false;
  bool load_radii = false;  // takes the variant for unequal radii even where all are equal. Never changes the set
  bool filter = true;       // false: collide_grid leaves every candidate pair to the exact stages
  ApiOptions api = {};      // never change the set
};

// What was done and what was left out since the scene was uploaded.
struct WorkCounts {
  uint64_t steps = 0;     // calls of collide(), and repetitions because a list was too short
  uint64_t launches = 0;  // of kernels; a replayed graph counts as one
  uint64_t sorts = 0, orders_kept = 0, cells_kept = 0;  // of steps through the grid, what became of the cell order
  uint64_t plans = 0;                                   // of cells, with that of the upload
  uint64_t graphs_replayed = 0;
  uint64_t kernels_replayed = 0;          // kernels of these
  uint64_t waits = 0;                     // for a launch alone, within steps
  uint64_t overlapped = 0;                // launches that need not wait for the one before
  uint64_t early = 0;                     // that get ready while the one before is under way, of replays too
  uint64_t without_radii = 0, lists = 0;  // steps that loaded no radius; that kept a list of pairs
};

// What a method stands for with the scene that was uploaded: `automatic` names another one, others themselves.
struct MethodChoice {
  Method method;
  uint block;             // group size; 0 on the CPU
  Cells cells;            // of collide_grid
  double others_in_cell;  // of that grid, on average over the spheres
  std::string reason;     // one clause
};
std::string describe(const MethodChoice& choice);

// Totals of one collide(). Sizes are numbers of pairs (i<j) or spheres.
struct Collisions {
  uint64_t pairs = 0;
  uint64_t colliding_spheres = 0;  // spheres with at least one contact
  Fingerprint fingerprint;
  uint64_t deferred = 0;                      // pairs that the float32 filter left undecided
  std::array<uint64_t, STAGES> decided_by{};  // of those, by STAGE_*
};

}  // namespace spherepair
