// SPDX-License-Identifier: MIT
// The options of a search for colliding pairs, and its results.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/plan/grid_plan.h"
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
  collide_tensor,    // the same through tensor cores: CUDA (compute capability 9.0), Vulkan
  collide_grid,      // only the spheres of neighbouring cells
  automatic,         // collide_grid or the fastest of all pairs, whichever crossover.h expects to be faster
};

const char* method_name(Method method);
Method method_from_name(const std::string& name);  // throws std::invalid_argument with the known names
std::vector<Method> device_methods();              // the methods that GLSL and CUDA share
std::span<const uint> block_sizes();               // 32, 64 ... 1024
std::span<const uint> small_block_sizes();         // 8, 16: only collide_tiled, for the paper's arrangements

// How spheres are sorted into cell order: by a counting sort over the cells, by splitting them into buckets of cells
// first, or by a library's radix sort (CUDA: Thrust).
enum class Sort { automatic, counting, buckets, radix };

// What the grid may skip or do in another way; each can be switched off to be measured.
struct GridOptions {
  Cells cells = Cells::automatic;
  bool keep_order = true;  // do not sort spheres again that are in cell order already
  bool keep_cells = true;  // spheres that have not moved keep their cells
  Sort sort = Sort::automatic;
  bool replan = true;  // plan new cells when spheres may have left the planned ones
  auto operator<=>(const GridOptions&) const = default;
};

constexpr std::array<uint, 4> graph_sizes = {1, 4, 16, 64};  // steps that a recorded graph may hold

// Features of an API that can be switched off to measure them. Absent: the faster choice, as measured. A backend that
// lacks a feature which is asked for throws std::invalid_argument, which names the feature.
struct ApiOptions {
  // CUDA and Vulkan: a step's launches are recorded once and replayed while they stay the same. Absent: on
  std::optional<bool> graph = {};
  // CUDA and Vulkan: equal steps that nobody waits for are replayed together, at most this many, one of graph_sizes.
  // Absent: the largest
  std::optional<uint> graph_steps = {};
  // OpenGL and Vulkan: collide_grid reads the table of cells through a texture buffer; OpenGL splits it over several if
  // one is too small. Absent: on if it fits
  std::optional<bool> texture_table = {};
  // All GPU APIs: the API's own function clears the table instead of a kernel. Absent: off
  std::optional<bool> library_clear = {};
  // All GPU APIs: a step's launches are submitted together, and OpenGL sets only the barriers that they need. Off: the
  // host waits for each launch; OpenGL sets GL_ALL_BARRIER_BITS, CUDA and Vulkan replay nothing. Absent: on
  std::optional<bool> batch = {};
  // All GPU APIs; CUDA from 12.3 on, with kernels compiled for compute capability 9.0 or later. The start of a step
  // runs beside the search of the previous step if neither writes what the other uses, also between replayed steps. In
  // CUDA later launches of a step also start early and wait inside the kernel. Absent: on
  std::optional<bool> overlap = {};
  auto operator<=>(const ApiOptions&) const = default;
};

struct CollideOptions {
  Method method = Method::collide_triangle;
  uint block = 128;         // group size; changes only collide_group's set. `automatic` with 128: crossover.h chooses
  bool exact = true;        // false: the naive float32 predicate, to measure what exactness costs
  bool want_pairs = false;  // keep the pairs for pairs()
  uint columns = 0;         // collide_triangle: columns that one group tests; 0: chosen by n. Never changes the set
  GridOptions grid = {};    // collide_grid. Never changes the set
  // Finds the pairs that touch at any time within the next step, bounces included (swept.h). Paths are those of the
  // motion, from the state rounded to float32. `method` finds the spheres whose paths are near each other;
  // collide_group throws std::invalid_argument.
  bool swept = false;
  bool load_radii = false;  // uses the kernel for unequal radii even if all are equal. Never changes the set
  bool filter = true;       // false: collide_grid leaves every candidate pair to the exact stages
  ApiOptions api = {};      // never changes the set
};

// Counts of work done and skipped since the scene was uploaded.
struct WorkCounts {
  uint64_t steps = 0;     // calls of collide(), and repetitions after a list was too short
  uint64_t launches = 0;  // kernel launches; a replayed graph counts as one
  uint64_t sorts = 0, orders_kept = 0, cells_kept = 0;  // steps through the grid: how they got the cell order
  uint64_t plans = 0;                                   // of cells, the one at the upload included
  uint64_t graphs_replayed = 0;
  uint64_t kernels_replayed = 0;          // kernels in those graphs
  uint64_t waits = 0;                     // single launches that the host waited for, within steps
  uint64_t overlapped = 0;                // launches that need not wait for the previous one
  uint64_t early = 0;                     // CUDA: launches, replayed too, that start before the previous one ends
  uint64_t without_radii = 0, lists = 0;  // steps that loaded no radius; that kept a list of pairs
};

// The method that runs on the uploaded scene; for `automatic`, the one that it chose.
struct MethodChoice {
  Method method;
  uint block;             // group size; 0 on the CPU
  Cells cells;            // of collide_grid
  double others_in_cell;  // mean number of other spheres in a sphere's cell of that grid
  std::string reason;     // one clause
};
std::string describe(const MethodChoice& choice);

// Totals of one collide(): numbers of pairs (i < j) or spheres.
struct Collisions {
  uint64_t pairs = 0;
  uint64_t colliding_spheres = 0;  // spheres with at least one contact
  Fingerprint fingerprint;
  uint64_t deferred = 0;                      // pairs that the float32 filter left undecided
  std::array<uint64_t, STAGES> decided_by{};  // how many of these each stage (STAGE_*) decided
};

}  // namespace spherepair
