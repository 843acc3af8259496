// SPDX-License-Identifier: MIT
// What a thread does with the pairs that reach it: decide, record, defer; and the totals of its group.
#pragma once

#include "common/shared/hash.h"
#include "common/shared/predicate.h"
#include "cuda/kernels.cuh"

namespace spherepair {

// 64-bit sums by two 32-bit atomics: each wrap of the low word is seen by exactly one addition.
__device__ inline void add_to_words(uint* words, uint low, uint high) {
  uint before = atomicAdd(&words[0], low);
  atomicAdd(&words[1], high + (before + low < before ? 1u : 0u));
}

template <bool EQUAL_RADII, bool LISTED>
struct Collider {
  const Params& p;
  const KernelBuffers& w;
  uint* total;  // shared, TOTAL_ROWS * TOTAL_STRIDE words
  uint pairs_found = 0u;
  uint64_t mix_a = 0ul;
  uint64_t mix_b = 0ul;

  __device__ Collider(const Params& params, const KernelBuffers& world, uint* shared_total)
      : p(params), w(world), total(shared_total) {}

  __device__ void start_totals() {
    for (uint k = threadIdx.x; k < TOTAL_ROWS * TOTAL_STRIDE; k += blockDim.x) total[k] = 0u;
    __syncthreads();
  }

  __device__ void add_to_total(uint word, uint64_t value) {
    uint row = (threadIdx.x % TOTAL_ROWS) * TOTAL_STRIDE;
    add_to_words(&total[row + word], uint(value & 0xFFFFFFFFul), uint(value >> 32));
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
    if (sum != 0ul) add_to_words(&w.summary[row + word], uint(sum & 0xFFFFFFFFul), uint(sum >> 32));
  }

  // More contacts for sphere i; what was counted before is not asked for, so nothing waits for it.
  __device__ void add_contact(uint i, uint contacts) { atomicAdd(&w.count[i], contacts); }

  // Of whoever was found at a place: the number, which is in the radius's place wherever radii are equal.
  __device__ uint sphere_index(vec4 found, uint sorted_index) const {
    if constexpr (EQUAL_RADII) return p.in_cells != 0u ? float_bits(found.w) : sorted_index;
    return p.in_cells != 0u ? w.id[sorted_index] : sorted_index;
  }

  __device__ bool totals_later() const { return p.totals_later != 0u; }

  // Numbers of spheres, in any order.
  __device__ void record(uint a, uint b) {
    uint i = min(a, b);
    uint j = max(a, b);
    pairs_found += 1u;
    mix_a += pair_mix_a(i, j);
    mix_b += pair_mix_b(i, j);
    if constexpr (LISTED) {
      uint k = atomicAdd(&w.summary[SUM_LISTED], 1u);
      if (k < p.pair_capacity) w.listed[k] = uvec2{i, j};
    }
  }

  __device__ void defer(uint i, uint j) {
    if (p.defer_undecided == 0u) return;
    uint k = atomicAdd(&w.summary[SUM_DEFERRED], 1u);
    if (k < p.deferred_capacity) w.deferred[k] = uvec2{i, j};
  }

  // Whether the filter must look closer at this pair: the one test of the hot loops.
  __device__ bool in_reach(vec4 a, vec4 b) const {
    if constexpr (EQUAL_RADII) return !(squared_distance(a, b) > p.apart_above);
    return filter_pair(a, b, p.filter_scale, p.filter_offset) != APART;
  }

  __device__ uint filter_spheres(vec4 a, vec4 b) {
    if constexpr (EQUAL_RADII) return filter_equal(squared_distance(a, b), p.apart_above, p.collide_below);
    return filter_pair(a, b, p.filter_scale, p.filter_offset);
  }

  // For kernels that meet every ordered pair: sphere i counts its own contacts, and i<j records the pair.
  __device__ uint test_ordered_pair(uint i, vec4 a, uint j, vec4 b) {
    if (i == j || i >= p.n) return 0u;
    uint verdict = filter_spheres(a, b);
    if (verdict == UNDECIDED && i < j) defer(i, j);
    if (verdict == COLLIDE && i < j) record(i, j);
    return verdict == COLLIDE ? 1u : 0u;
  }

  // For kernels that meet every unordered pair once, at places i and j: what the filter says of it. The caller counts
  // the contact, or has an undecided pair decided. Most that come here collide, so numbers are loaded beside the
  // spheres.
  __device__ uint test_pair(uint i, vec4 a, uint j, vec4 b) {
    uint first = totals_later() ? i : sphere_index(a, i);
    uint second = totals_later() ? j : sphere_index(b, j);
    uint verdict = filter_spheres(a, b);
    if (verdict == COLLIDE && !totals_later()) record(first, second);
    return verdict;
  }

  __device__ void test_stored_pair(uint i, uint j) {
    uint verdict = test_pair(i, w.position[i], j, w.position[j]);
    if (verdict == UNDECIDED) defer(i, j);
    if (verdict != COLLIDE) return;
    add_contact(i, 1u);
    add_contact(j, 1u);
  }
};

}  // namespace spherepair
