// SPDX-License-Identifier: MIT
// One product of tensor cores by four warps: 64 rows, whose forms the threads hold, with the 128 columns of a tile in
// shared memory.
//
// CUDA only: OpenGL has no cooperative matrices
#pragma once

#include "cuda/tensor/column_ring.cuh"

namespace spherepair {

// Thread 4g + t of warp w has the sums of rows 16w + g (s = 0) and 16w + g + 8 (s = 2) with column 8k + 2t + c, c = 0
// or 1, at index 4k + s + c.
constexpr uint PRODUCT_ROWS = 64u, SUMS = 64u;

// Forms stand in shared memory without a swizzle: 128 bytes from the first eight halves to the others, 256 from eight
// spheres to the next.
__device__ inline uint64_t matrix_descriptor(const void* tile) {
  return uint64_t(shared_address(tile) >> 4) | uint64_t(128u >> 4) << 16 | uint64_t(256u >> 4) << 32;
}

// The fragment of matrix A that holds 16 rows, from `row` on, of the forms as tensor_forms wrote them.
__device__ inline void load_rows(uint (&fragment)[4], const uint* forms, uint row, uint lane) {
  uint t = lane % 4u, low = tensor_row_source(t), high = tensor_row_source(t + 4u) - 4u;
  const uint* eight = forms + row / 8u * 64u + lane / 4u * 4u;
  fragment[0] = eight[low] ^ tensor_row_signs(t);
  fragment[1] = eight[64u + low] ^ tensor_row_signs(t);
  fragment[2] = eight[32u + high] ^ tensor_row_signs(t + 4u);
  fragment[3] = eight[96u + high] ^ tensor_row_signs(t + 4u);
}

// Issued and waited for: other warps keep the tensor cores busy in between.
__device__ inline void multiply(float (&sum)[SUMS], const uint (&rows)[4], uint64_t columns) {
  asm volatile(
      "{ .reg .pred accumulate; setp.ne.b32 accumulate, 0, 0;\n"
      "wgmma.fence.sync.aligned;\n"
      "wgmma.mma_async.sync.aligned.m64n128k16.f32.f16.f16 {"
      "%0, %1, %2, %3, %4, %5, %6, %7, %8, %9, %10, %11, %12, %13, %14, %15, "
      "%16, %17, %18, %19, %20, %21, %22, %23, %24, %25, %26, %27, %28, %29, %30, %31, "
      "%32, %33, %34, %35, %36, %37, %38, %39, %40, %41, %42, %43, %44, %45, %46, %47, "
      "%48, %49, %50, %51, %52, %53, %54, %55, %56, %57, %58, %59, %60, %61, %62, %63}, "
      "{%64, %65, %66, %67}, %68, accumulate, 1, 1, 0;\n"
      "wgmma.commit_group.sync.aligned;\n"
      "wgmma.wait_group.sync.aligned 0; }"
      : "=f"(sum[0]), "=f"(sum[1]), "=f"(sum[2]), "=f"(sum[3]), "=f"(sum[4]), "=f"(sum[5]), "=f"(sum[6]), "=f"(sum[7]),
        "=f"(sum[8]), "=f"(sum[9]), "=f"(sum[10]), "=f"(sum[11]), "=f"(sum[12]), "=f"(sum[13]), "=f"(sum[14]),
        "=f"(sum[15]), "=f"(sum[16]), "=f"(sum[17]), "=f"(sum[18]), "=f"(sum[19]), "=f"(sum[20]), "=f"(sum[21]),
        "=f"(sum[22]), "=f"(sum[23]), "=f"(sum[24]), "=f"(sum[25]), "=f"(sum[26]), "=f"(sum[27]), "=f"(sum[28]),
        "=f"(sum[29]), "=f"(sum[30]), "=f"(sum[31]), "=f"(sum[32]), "=f"(sum[33]), "=f"(sum[34]), "=f"(sum[35]),
        "=f"(sum[36]), "=f"(sum[37]), "=f"(sum[38]), "=f"(sum[39]), "=f"(sum[40]), "=f"(sum[41]), "=f"(sum[42]),
        "=f"(sum[43]), "=f"(sum[44]), "=f"(sum[45]), "=f"(sum[46]), "=f"(sum[47]), "=f"(sum[48]), "=f"(sum[49]),
        "=f"(sum[50]), "=f"(sum[51]), "=f"(sum[52]), "=f"(sum[53]), "=f"(sum[54]), "=f"(sum[55]), "=f"(sum[56]),
        "=f"(sum[57]), "=f"(sum[58]), "=f"(sum[59]), "=f"(sum[60]), "=f"(sum[61]), "=f"(sum[62]), "=f"(sum[63])
      : "r"(rows[0]), "r"(rows[1]), "r"(rows[2]), "r"(rows[3]), "l"(columns)
      : "memory");
}

}  // namespace spherepair
