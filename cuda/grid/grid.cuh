// SPDX-License-Identifier: MIT
// The table of cells: the sorted index at which the spheres of each cell begin.
#pragma once

#include "common/shared/cell.h"
#include "cuda/kernels.cuh"

namespace spherepair {

// For kernels that only read the table: returns where the spheres of the cell at slot table_begin() + k begin.
__device__ inline uint begin_at(const KernelBuffers& buf, uint k) { return buf.cell[k]; }

// This launch handles the spheres from sorted_begin to before sorted_end.
__device__ inline uint table_begin() { return 0u; }
__device__ inline uint sorted_begin() { return 0u; }
__device__ inline uint sorted_end(const Params& p) { return p.n; }

}  // namespace spherepair
