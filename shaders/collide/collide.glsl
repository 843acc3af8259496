// SPDX-License-Identifier: MIT
// Decides, records or defers a candidate pair, and sums up the totals of a group.
#include "shaders/kernels.glsl"
#include "common/shared/hash.h"
#include "common/shared/predicate.h"

shared uint total[TOTAL_ROWS * TOTAL_STRIDE];

uint pairs_found = 0u;
uint64_t mix_a = 0ul;
uint64_t mix_b = 0ul;

// Adds to a 64-bit sum by two 32-bit atomics: exactly one addition sees each wrap of the low word.
void add_to_total(uint word, uint64_t value) {
  uint at = (gl_LocalInvocationID.x % TOTAL_ROWS) * TOTAL_STRIDE + word;
  uint low = uint(value & 0xFFFFFFFFul);
  uint before = atomicAdd(total[at], low);
  atomicAdd(total[at + 1u], uint(value >> 32) + (before + low < before ? 1u : 0u));
}

void add_to_summary(uint word, uint64_t value) {
  uint low = uint(value & 0xFFFFFFFFul);
  uint before = atomicAdd(summary[word], low);
  atomicAdd(summary[word + 1u], uint(value >> 32) + (before + low < before ? 1u : 0u));
}

void start_totals() {
  for (uint k = gl_LocalInvocationID.x; k < TOTAL_ROWS * TOTAL_STRIDE; k += BLOCK) total[k] = 0u;
  barrier();
}

void finish_totals() {
  if (pairs_found != 0u) {
    add_to_total(SUM_PAIRS, uint64_t(pairs_found));
    add_to_total(SUM_MIX_A, mix_a);
    add_to_total(SUM_MIX_B, mix_b);
  }
  barrier();
  uint word = 2u * gl_LocalInvocationID.x;
  if (word >= SUM_DEFERRED) return;
  uint64_t sum = 0ul;
  for (uint k = 0u; k < TOTAL_ROWS; ++k)
    sum += uint64_t(total[k * TOTAL_STRIDE + word]) + (uint64_t(total[k * TOTAL_STRIDE + word + 1u]) << 32);
  uint row = (group_index() % SUMMARY_SLOTS) * SUMMARY_WORDS;
  if (sum != 0ul) add_to_summary(row + word, sum);
}

// Adds contacts to the sphere at index i. The atomic's result is unused, so that no thread waits for it.
void add_contact(uint i, uint contacts) { atomicAdd(count[i], contacts); }

// Records a colliding pair, given by its sphere indices in either order.
void record(uint a, uint b) {
  uint i = min(a, b);
  uint j = max(a, b);
  pairs_found += 1u;
  mix_a += pair_mix_a(i, j);
  mix_b += pair_mix_b(i, j);
  if (LISTED) {
    uint k = atomicAdd(summary[SUM_LISTED], 1u);
    if (k < p.search.pair_capacity) listed[k] = uvec2(i, j);
  }
}

void defer(uint i, uint j) {
  if (p.search.defer_undecided == 0u) return;
  uint k = atomicAdd(summary[SUM_DEFERRED], 1u);
  if (k < p.search.deferred_capacity) deferred[k] = uvec2(i, j);
}

// Whether this is a candidate pair: the only test in the hot loops.
bool in_reach(vec4 a, vec4 b) {
  if (EQUAL_RADII) return !(squared_distance(a, b) > p.search.apart_above);
  return filter_near(a, b, p.search.filter_scale, p.search.filter_offset);
}

uint filter_spheres(vec4 a, vec4 b) {
  if (EQUAL_RADII) return filter_equal(squared_distance(a, b), p.search.apart_above, p.search.collide_below);
  return filter_pair(a, b, p.search.filter_scale, p.search.filter_offset);
}

// For kernels that test every ordered pair: returns the contacts of sphere i, and records the pair if i<j.
uint test_ordered_pair(uint i, vec4 a, uint j, vec4 b) {
  if (i == j || i >= p.n) return 0u;
  uint verdict = filter_spheres(a, b);
  if (verdict == UNDECIDED && i < j) defer(i, j);
  if (verdict == COLLIDE && i < j) record(i, j);
  return verdict == COLLIDE ? 1u : 0u;
}

// For kernels that test every unordered pair once: returns the filter's verdict on the spheres at indices i and j. The
// caller counts the contacts and handles an undecided pair. Most candidates collide, so sphere indices are loaded
// early.
uint test_pair(uint i, vec4 a, uint j, vec4 b) {
  uint first = sphere_index(a, i);
  uint second = sphere_index(b, j);
  uint verdict = filter_spheres(a, b);
  if (verdict == COLLIDE) record(first, second);
  return verdict;
}

// Records, defers and counts the contact of sphere i; returns the contacts of sphere j.
uint test_row(uint i, uint j) {
  uint verdict = test_pair(i, position[i], j, position[j]);
  if (verdict == UNDECIDED) defer(i, j);
  if (verdict != COLLIDE) return 0u;
  add_contact(i, 1u);
  return 1u;
}

void test_stored_pair(uint i, uint j) {
  if (test_row(i, j) != 0u) add_contact(j, 1u);
}
