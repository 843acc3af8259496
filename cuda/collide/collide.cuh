// SPDX-License-Identifier: MIT
// Decides, records or defers a candidate pair, and sums up the totals of a group.
#pragma once

#include "common/shared/hash.h"
#include "common/shared/predicate.h"
#include "cuda/kernels.cuh"

namespace spherepair {

__shared__ uint total[TOTAL_ROWS * TOTAL_STRIDE];

// CUDA only from here: in GLSL these are variables and constants of the program
template <bool EQUAL_RADII, bool LISTED, bool IN_CELLS = false>  // IN_CELLS: may find spheres in cell order
struct Collider {
  const Params& p;
  const KernelBuffers& buf;
  __device__ Collider(const Params& params, const KernelBuffers& buffers) : p(params), buf(buffers) {}
  // until here

  uint pairs_found = 0u;
  uint64_t mix_a = 0ul;
  uint64_t mix_b = 0ul;

  // Adds to a 64-bit sum by two 32-bit atomics: exactly one addition sees each wrap of the low word.
  __device__ void add_to_total(uint word, uint64_t value) {
    uint at = (threadIdx.x % TOTAL_ROWS) * TOTAL_STRIDE + word;
    uint low = uint(value & 0xFFFFFFFFul);
    uint before = atomicAdd(&total[at], low);
    atomicAdd(&total[at + 1u], uint(value >> 32) + (before + low < before ? 1u : 0u));
  }

  __device__ void add_to_summary(uint word, uint64_t value) {
    uint low = uint(value & 0xFFFFFFFFul);
    uint before = atomicAdd(&buf.summary[word], low);
    atomicAdd(&buf.summary[word + 1u], uint(value >> 32) + (before + low < before ? 1u : 0u));
  }

  __device__ void start_totals() {
    for (uint k = threadIdx.x; k < TOTAL_ROWS * TOTAL_STRIDE; k += blockDim.x) total[k] = 0u;
    __syncthreads();
  }

  __device__ void finish_totals() {
    if (pairs_found != 0u) {
      add_to_total(SUM_PAIRS, uint64_t(pairs_found));
      add_to_total(SUM_MIX_A, mix_a);
      add_to_total(SUM_MIX_B, mix_b);
    }
    __syncthreads();
    uint word = 2u * threadIdx.x;
    if (word >= SUM_DEFERRED) return;
    uint64_t sum = 0ul;
    for (uint k = 0u; k < TOTAL_ROWS; ++k)
      sum += uint64_t(total[k * TOTAL_STRIDE + word]) + (uint64_t(total[k * TOTAL_STRIDE + word + 1u]) << 32);
    uint row = (group_index(p) % SUMMARY_SLOTS) * SUMMARY_WORDS;
    if (sum != 0ul) add_to_summary(row + word, sum);
  }

  // Adds contacts to the sphere at index i. The atomic's result is unused, so that no thread waits for it.
  __device__ void add_contact(uint i, uint contacts) { atomicAdd(&buf.count[i], contacts); }

  // Records a colliding pair, given by its sphere indices in either order.
  __device__ void record(uint a, uint b) {
    uint i = min(a, b);
    uint j = max(a, b);
    pairs_found += 1u;
    mix_a += pair_mix_a(i, j);
    mix_b += pair_mix_b(i, j);
    if constexpr (LISTED) {
      uint k = atomicAdd(&buf.summary[SUM_LISTED], 1u);
      if (k < p.search.pair_capacity) buf.listed[k] = uvec2{i, j};
    }
  }

  __device__ void defer(uint i, uint j) {
    if (p.search.defer_undecided == 0u) return;
    uint k = atomicAdd(&buf.summary[SUM_DEFERRED], 1u);
    if (k < p.search.deferred_capacity) buf.deferred[k] = uvec2{i, j};
  }

  // Whether this is a candidate pair: the only test in the hot loops.
  __device__ bool in_reach(vec4 a, vec4 b) const {
    if constexpr (EQUAL_RADII) return !(squared_distance(a, b) > p.search.apart_above);
    return filter_near(a, b, p.search.filter_scale, p.search.filter_offset);
  }

  __device__ uint filter_spheres(vec4 a, vec4 b) {
    if constexpr (EQUAL_RADII)
      return filter_equal(squared_distance(a, b), p.search.apart_above, p.search.collide_below);
    return filter_pair(a, b, p.search.filter_scale, p.search.filter_offset);
  }

  // For kernels that test every ordered pair: returns the contacts of sphere i, and records the pair if i<j.
  __device__ uint test_ordered_pair(uint i, vec4 a, uint j, vec4 b) {
    if (i == j || i >= p.n) return 0u;
    uint verdict = filter_spheres(a, b);
    if (verdict == UNDECIDED && i < j) defer(i, j);
    if (verdict == COLLIDE && i < j) record(i, j);
    return verdict == COLLIDE ? 1u : 0u;
  }

  // CUDA only from here: all pairs are searched in the scene's order, which GLSL knows from INDICES
  __device__ uint sphere_index(vec4 found, uint k) const {
    if constexpr (!IN_CELLS) return k;
    return spherepair::sphere_index(p, buf, found, k);
  }
  // until here

  // For kernels that test every unordered pair once: returns the filter's verdict on the spheres at indices i and j.
  // The caller counts the contacts and handles an undecided pair. Most candidates collide, so sphere indices are loaded
  // early.
  __device__ uint test_pair(uint i, vec4 a, uint j, vec4 b) {
    uint first = sphere_index(a, i);
    uint second = sphere_index(b, j);
    uint verdict = filter_spheres(a, b);
    if (verdict == COLLIDE) record(first, second);
    return verdict;
  }

  // Records, defers and counts the contact of sphere i; returns the contacts of sphere j.
  __device__ uint test_row(uint i, uint j) {
    uint verdict = test_pair(i, buf.position[i], j, buf.position[j]);
    if (verdict == UNDECIDED) defer(i, j);
    if (verdict != COLLIDE) return 0u;
    add_contact(i, 1u);
    return 1u;
  }

  __device__ void test_stored_pair(uint i, uint j) {
    if (test_row(i, j) != 0u) add_contact(j, 1u);
  }
};  // CUDA only: ends Collider

}  // namespace spherepair
