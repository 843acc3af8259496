// SPDX-License-Identifier: MIT
// Tests each unordered pair once: a group keeps SPHERES_PER_THREAD spheres a thread in registers, its rows, and tests
// them against p.search.columns_per_group later spheres, its columns, which pass through shared memory in Gram form.
// Candidates are marked in a bit mask, then queued; after each tile the whole group decides the queued pairs, a thread
// per pair. A row group near the end has few columns, one near the beginning many. Groups of one y index share a row
// group and its mirror image, so that few are idle.
#include "cuda/collide/collide.cuh"

namespace spherepair {

constexpr uint PAIRS_PER_ENTRY = SPHERES_PER_THREAD * COLUMNS_AT_ONCE;

// Tests pair number `pair` of a queue entry, which holds the rows of one thread and COLUMNS_AT_ONCE columns from j on.
template <int BLOCK, bool EQUAL_RADII, bool LISTED>
__device__ void test_queued_pair(Collider<EQUAL_RADII, LISTED>& collider, uint first_row, uint pair, uint lane, uint j,
                                 uint end) {
  uint i = first_row + (pair % SPHERES_PER_THREAD) * BLOCK + lane;
  j += pair / SPHERES_PER_THREAD;
  if (i < j && j < end) collider.test_stored_pair(i, j);
}

// CUDA only from here: contacts of a column are added together, since all threads of a warp have the same one
// All pairs of an entry for which the queue has no room.
template <int BLOCK, bool EQUAL_RADII, bool LISTED>
__device__ void test_entry(Collider<EQUAL_RADII, LISTED>& collider, uint first_row, uint lane, uint j, uint end) {
#pragma unroll 1  // unrolled, this rare path takes 91 registers and slows the loop above
  for (uint u = 0u; u < COLUMNS_AT_ONCE && j + u < end; ++u) {
    uint contacts = 0u;
#pragma unroll 1  // the same
    for (uint k = 0u; k < SPHERES_PER_THREAD; ++k) {
      uint i = first_row + k * BLOCK + lane;
      if (i < j + u) contacts += collider.test_row(i, j + u);
    }
    if (contacts != 0u) collider.add_contact(j + u, contacts);
  }
}
// until here

template <int BLOCK, bool EQUAL_RADII, bool LISTED>
__global__ void __launch_bounds__(BLOCK) collide_triangle(Params p, KernelBuffers buf) {
  constexpr uint ROWS = BLOCK * SPHERES_PER_THREAD;
  constexpr float ROW_SHARE = EQUAL_RADII ? 2.0f : 0.5f;
  constexpr float COLUMN_SHARE = EQUAL_RADII ? 0.0f : 0.5f;
  constexpr uint COLUMNS_MARKED = BLOCK < 32 * COLUMNS_AT_ONCE ? BLOCK : 32 * COLUMNS_AT_ONCE;
  __shared__ vec4 tile[BLOCK];
  __shared__ float tile_radius[EQUAL_RADII ? 1 : BLOCK];
  __shared__ uint near_queue[NEAR_PER_THREAD * BLOCK];
  __shared__ uint near_length[2];  // queue lengths of this tile and of the next
  Collider<EQUAL_RADII, LISTED> collider(p, buf);
  wait_first(p);  // CUDA only: of small steps, which get ready early
  uint lane = threadIdx.x;
  uint part = blockIdx.x;
  uint first_row = (p.first_group + blockIdx.y) * ROWS;
  uint parts = (p.n - first_row + p.search.columns_per_group - 1u) / p.search.columns_per_group;
  if (part >= parts) {
    uint mirrored = (p.n - 1u) / ROWS * ROWS - first_row;
    if (mirrored == first_row) return;  // the middle line
    first_row = mirrored;
    part -= parts;
  }
  uint first_column = first_row + part * p.search.columns_per_group;
  if (first_column >= p.n) return;
  if (lane < 2u) near_length[lane] = 0u;
  collider.start_totals();
  vec4 origin = buf.position[first_row];
  vec4 row[SPHERES_PER_THREAD];
  float row_radius[SPHERES_PER_THREAD];
  for (uint k = 0u; k < SPHERES_PER_THREAD; ++k) {
    vec4 sphere = buf.position[min(first_row + k * BLOCK + lane, p.n - 1u)];
    row[k] = gram_form(sphere, origin, ROW_SHARE);
    row[k].w = -row[k].w;
    row_radius[k] = sphere.w;
    if (first_row + k * BLOCK + lane >= p.n) row[k].w = NEVER_NEAR;
  }
  uint end = min(first_column + p.search.columns_per_group, p.n);
  uint turn = 0u;
  for (uint start = first_column; start < end; start += BLOCK) {
    vec4 sphere = buf.position[min(start + lane, p.n - 1u)];
    tile[lane] = gram_form(sphere, origin, COLUMN_SHARE);
    if constexpr (!EQUAL_RADII) tile_radius[lane] = sphere.w;
    __syncthreads();
    if (lane == 0u) near_length[turn ^ 1u] = 0u;
    uint others = min(uint(BLOCK), end - start);
    for (uint c = 0u; c < others; c += COLUMNS_MARKED) {
      uint marked = 0u;
      uint bit = 1u;  // for COLUMNS_AT_ONCE columns
      uint marked_end = min(others, c + COLUMNS_MARKED);
      for (uint first = c; first < marked_end; first += 2u * COLUMNS_AT_ONCE) {
        for (uint pass = 0u; pass < 2u; ++pass) {
          bool near = false;
          for (uint u = 0u; u < COLUMNS_AT_ONCE; ++u) {
            uint at = first + pass * COLUMNS_AT_ONCE + u;
            vec4 column = tile[at];
            int greatest = signed_bits(NEVER_NEAR);
            for (uint k = 0u; k < SPHERES_PER_THREAD; ++k) {
              float product = gram_product(row[k].x, row[k].y, row[k].z, row[k].w, column);
              if constexpr (EQUAL_RADII) {
                greatest = max(greatest, signed_bits(product));
              } else {
                product = multiply_add(row_radius[k], tile_radius[at], product);
                near = near || !(product < column.w);
              }
            }
            if constexpr (EQUAL_RADII) near = near || greatest >= signed_bits(column.w);
          }
          if (near) marked |= bit << pass;
        }
        bit <<= 2;
      }
      for (; marked != 0u; marked &= marked - 1u) {
        uint j = c + lowest_bit(marked) * COLUMNS_AT_ONCE;
        uint at = atomicAdd(&near_length[turn], 1u);
        if (at < NEAR_PER_THREAD * BLOCK) {
          near_queue[at] = j * BLOCK + lane;
        } else {
          test_entry<BLOCK>(collider, first_row, lane, start + j, end);  // CUDA only: in GLSL pair by pair
        }
      }
    }
    __syncthreads();
    uint queued = min(near_length[turn], uint(NEAR_PER_THREAD * BLOCK)) * PAIRS_PER_ENTRY;
    for (uint q = lane; q < queued; q += BLOCK) {
      uint candidate = near_queue[q / PAIRS_PER_ENTRY];
      test_queued_pair<BLOCK>(collider, first_row, q % PAIRS_PER_ENTRY, candidate % BLOCK, start + candidate / BLOCK,
                              end);
    }
    turn ^= 1u;
  }
  collider.finish_totals();
}

Entry collide_triangle_kernel(uint block, Variant variant) {
  return pick_kernel(block, variant, [](auto size, auto equal, auto listed) {
    return reinterpret_cast<Entry>(&collide_triangle<size(), equal(), listed()>);
  });
}

}  // namespace spherepair
