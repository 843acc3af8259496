#version 450
// SPDX-License-Identifier: MIT
// Tests each unordered pair once, through tensor cores: a group holds TENSOR_ROWS spheres, its rows, as fragments of
// matrix A, and tests them against later spheres, its columns, which pass through shared memory in tiles. A sum of
// products is negative where a pair may collide (tensor_form.h). The tiles of all blocks of rows form one line, of
// which each group takes p.search.tiles_per_group. Only Vulkan runs it: OpenGL has no cooperative matrices.
#extension GL_NV_cooperative_matrix : require
#extension GL_KHR_memory_scope_semantics : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_vote : require
#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require
#include "shaders/collide/collide.glsl"
#include "common/shared/tensor_form.h"

layout(std430, binding = SLOT_SORTED) restrict readonly buffer FormBuffer { uvec4 forms[]; };
layout(local_size_x = BLOCK) in;
// GLSL only from here: a subgroup computes a product, and GLSL does not say which thread has which sum. If a sum is
// negative, the subgroup decides all pairs of the product.
const uint SIDE = 16u;  // rows and columns of a product
const uint WARPS = BLOCK / 32u;
const uint PRODUCTS = TENSOR_ROWS / WARPS / SIDE;  // products of a subgroup with SIDE columns
const uint WORDS = TENSOR_COLUMNS * 2u;            // words of a tile
const uint EACH = WORDS / BLOCK;                   // words that a thread copies
shared uvec4 columns[2][WORDS];

// Turns half `part` of a form into the same half of a row of matrix A.
uvec4 row_of(uvec4 form, uint part) {
  uvec4 row;
  for (uint k = 0u; k < 4u; ++k) {
    uint word = 4u * part + k;
    row[k] = form[tensor_row_source(word) - 4u * part] ^ tensor_row_signs(word);
  }
  return row;
}

// Decides all pairs of SIDE rows and SIDE columns. A thread takes one row and half of the columns.
void decide(uint first_row, uint first_column) {
  uint lane = gl_SubgroupInvocationID;
  uint i = first_row + lane % SIDE;
  uint j = first_column + lane / SIDE * (SIDE / 2u);
  vec4 row = position[min(i, p.n - 1u)];
  uint candidates = 0u;
  for (uint c = 0u; c < SIDE / 2u; ++c) {
    vec4 column = position[min(j + c, p.n - 1u)];
    if (i < j + c && j + c < p.n && in_reach(row, column)) candidates |= 1u << c;
  }
  for (; candidates != 0u; candidates &= candidates - 1u) test_stored_pair(i, j + lowest_bit(candidates));
}

uint first_tile(uint block) { return block * (TENSOR_ROWS / TENSOR_COLUMNS); }

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint64_t all = tensor_tiles(uint64_t(p.n));
  uint64_t skipped = uint64_t(group_index()) * uint64_t(p.search.tiles_per_group);
  if (skipped >= all) return;
  uint count = uint(min(uint64_t(p.search.tiles_per_group), all - skipped));
  uint tiles = (p.n + TENSOR_COLUMNS - 1u) / TENSOR_COLUMNS;
  uint block = 0u;
  for (; skipped >= uint64_t(tiles - first_tile(block)); ++block) skipped -= uint64_t(tiles - first_tile(block));
  uint tile = first_tile(block) + uint(skipped);
  start_totals();
  fcoopmatNV<32, gl_ScopeSubgroup, SIDE, SIDE> zero = fcoopmatNV<32, gl_ScopeSubgroup, SIDE, SIDE>(0.0f);
  for (; count > 0u; ++block, tile = first_tile(block)) {
    uint first_row = block * TENSOR_ROWS + gl_SubgroupID * (PRODUCTS * SIDE);
    fcoopmatNV<16, gl_ScopeSubgroup, SIDE, SIDE> a[PRODUCTS];
    for (uint k = 0u; k < PRODUCTS; ++k) {  // rows pass through the columns' memory
      barrier();
      uint own = gl_SubgroupInvocationID;
      columns[0][lane] = row_of(forms[2u * (first_row + k * SIDE) + own], own % 2u);
      barrier();
      coopMatLoadNV(a[k], columns[0], gl_SubgroupID * 32u, 2u, false);
    }
    barrier();
    uint end = min(tiles, tile + count);
    count -= end - tile;
    uvec4 next[EACH];
    for (uint q = 0u; q < EACH; ++q) next[q] = forms[tile * WORDS + q * BLOCK + lane];
    for (; tile < end; ++tile) {
      uint stage = tile % 2u;
      for (uint q = 0u; q < EACH; ++q) columns[stage][q * BLOCK + lane] = next[q];
      barrier();
      for (uint q = 0u; q < EACH; ++q)
        if (tile + 1u < end) next[q] = forms[(tile + 1u) * WORDS + q * BLOCK + lane];
      for (uint c = 0u; c < TENSOR_COLUMNS; c += SIDE) {
        fcoopmatNV<16, gl_ScopeSubgroup, SIDE, SIDE> b;
        coopMatLoadNV(b, columns[stage], c * 2u, 2u, true);
        uint signs[PRODUCTS];
        uint any = 0u;
        for (uint k = 0u; k < PRODUCTS; ++k) {
          fcoopmatNV<32, gl_ScopeSubgroup, SIDE, SIDE> sum = coopMatMulAddNV(a[k], b, zero);
          signs[k] = 0u;
          for (int e = 0; e < sum.length(); ++e) signs[k] |= float_bits(sum[e]);
          any |= signs[k];
        }
        if (!subgroupAny(int(any) < 0)) continue;
        for (uint k = 0u; k < PRODUCTS; ++k)
          if (subgroupAny(int(signs[k]) < 0)) decide(first_row + k * SIDE, tile * TENSOR_COLUMNS + c);
      }
    }
  }
  finish_totals();
}
// until here
