// SPDX-License-Identifier: MIT
// Computes one product of tensor cores by four warps: 64 rows, whose forms the threads hold, with the 256 columns of a
// tile in shared memory.
//
// CUDA only: in GLSL a subgroup multiplies matrices
#pragma once

#include "cuda/tensor/column_ring.cuh"

namespace spherepair {

// Thread 4g + t of warp w has the sums of rows 16w + g (s = 0) and 16w + g + 8 (s = 1) with columns 8k + 2t and
// 8k + 2t + 1 in the two halves of word 2k + s. Only their signs count.
constexpr uint PRODUCT_ROWS = 64u, WORDS = 64u;
constexpr uint SIGNS = 0x80008000u;

// Describes the forms in shared memory, without a swizzle: 128 bytes from the first eight halves to the others, 256
// from eight spheres to the next.
__device__ inline uint64_t matrix_descriptor(const void* tile) {
  return uint64_t(shared_address(tile) >> 4) | uint64_t(128u >> 4) << 16 | uint64_t(256u >> 4) << 32;
}

// Loads the fragment of matrix A for 16 rows, from `row` on, from the forms that tensor_forms wrote.
__device__ inline void load_rows(uint (&fragment)[4], const uint* forms, uint row, uint lane) {
  uint t = lane % 4u, low = tensor_row_source(t), high = tensor_row_source(t + 4u) - 4u;
  const uint* eight = forms + row / 8u * 64u + lane / 4u * 4u;
  fragment[0] = eight[low] ^ tensor_row_signs(t);
  fragment[1] = eight[64u + low] ^ tensor_row_signs(t);
  fragment[2] = eight[32u + high] ^ tensor_row_signs(t + 4u);
  fragment[3] = eight[96u + high] ^ tensor_row_signs(t + 4u);
}

// Issues the product and waits for it: other warps keep the tensor cores busy meanwhile.
__device__ inline void multiply(uint (&sum)[WORDS], const uint (&rows)[4], uint64_t columns) {
  asm volatile(
      "{ .reg .pred accumulate; setp.ne.b32 accumulate, 0, 0;\n"
      "wgmma.fence.sync.aligned;\n"
      "wgmma.mma_async.sync.aligned.m64n256k16.f16.f16.f16 {"
      "%0, %1, %2, %3, %4, %5, %6, %7, %8, %9, %10, %11, %12, %13, %14, %15, "
      "%16, %17, %18, %19, %20, %21, %22, %23, %24, %25, %26, %27, %28, %29, %30, %31, "
      "%32, %33, %34, %35, %36, %37, %38, %39, %40, %41, %42, %43, %44, %45, %46, %47, "
      "%48, %49, %50, %51, %52, %53, %54, %55, %56, %57, %58, %59, %60, %61, %62, %63}, "
      "{%64, %65, %66, %67}, %68, accumulate, 1, 1, 0;\n"
      "wgmma.commit_group.sync.aligned;\n"
      "wgmma.wait_group.sync.aligned 0; }"
      : "=r"(sum[0]), "=r"(sum[1]), "=r"(sum[2]), "=r"(sum[3]), "=r"(sum[4]), "=r"(sum[5]), "=r"(sum[6]), "=r"(sum[7]),
        "=r"(sum[8]), "=r"(sum[9]), "=r"(sum[10]), "=r"(sum[11]), "=r"(sum[12]), "=r"(sum[13]), "=r"(sum[14]),
        "=r"(sum[15]), "=r"(sum[16]), "=r"(sum[17]), "=r"(sum[18]), "=r"(sum[19]), "=r"(sum[20]), "=r"(sum[21]),
        "=r"(sum[22]), "=r"(sum[23]), "=r"(sum[24]), "=r"(sum[25]), "=r"(sum[26]), "=r"(sum[27]), "=r"(sum[28]),
        "=r"(sum[29]), "=r"(sum[30]), "=r"(sum[31]), "=r"(sum[32]), "=r"(sum[33]), "=r"(sum[34]), "=r"(sum[35]),
        "=r"(sum[36]), "=r"(sum[37]), "=r"(sum[38]), "=r"(sum[39]), "=r"(sum[40]), "=r"(sum[41]), "=r"(sum[42]),
        "=r"(sum[43]), "=r"(sum[44]), "=r"(sum[45]), "=r"(sum[46]), "=r"(sum[47]), "=r"(sum[48]), "=r"(sum[49]),
        "=r"(sum[50]), "=r"(sum[51]), "=r"(sum[52]), "=r"(sum[53]), "=r"(sum[54]), "=r"(sum[55]), "=r"(sum[56]),
        "=r"(sum[57]), "=r"(sum[58]), "=r"(sum[59]), "=r"(sum[60]), "=r"(sum[61]), "=r"(sum[62]), "=r"(sum[63])
      : "r"(rows[0]), "r"(rows[1]), "r"(rows[2]), "r"(rows[3]), "l"(columns)
      : "memory");
}

}  // namespace spherepair
