// SPDX-License-Identifier: MIT
#include "cuda/host/list_arrays.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "common/lists/exact_sum.h"
#include "common/shared/list.h"
#include "cuda/host/check.h"
#include "cuda/kernels.h"

namespace spherepair {
namespace {

constexpr uint block = 256, most_blocks = 1 << 16;

uint blocks_for(uint64_t rows) { return uint(std::clamp<uint64_t>((rows + block - 1) / block, 1, most_blocks)); }

__device__ uint64_t first_row() { return uint64_t(blockIdx.x) * block + threadIdx.x; }
__device__ uint64_t row_step() { return uint64_t(gridDim.x) * block; }

__device__ double number_at(const DeviceArray& array, uint64_t row, int column) {
  const int64_t at = int64_t(row) * array.row_stride + column * array.column_stride;
  return array.type == ElementType::float32 ? double(static_cast<const float*>(array.data)[at])
                                            : static_cast<const double*>(array.data)[at];
}

__global__ void __launch_bounds__(block) gather(DeviceArray points, DeviceArray radii, dvec4* to, uint64_t rows) {
  for (uint64_t i = first_row(); i < rows; i += row_step())
    to[i] = {number_at(points, i, 0), number_at(points, i, 1), number_at(points, i, 2),
             radii.data ? number_at(radii, i, 0) : 0.0};
}

__device__ void put(const DeviceArray& array, uint64_t row, int column, int64_t number) {
  if (!array.data) return;
  const int64_t at = int64_t(row) * array.row_stride + column * array.column_stride;
  if (array.type == ElementType::int32)
    static_cast<int32_t*>(array.data)[at] = int32_t(number);
  else
    static_cast<int64_t*>(array.data)[at] = number;
}
__device__ void put(const DeviceArray& array, uint64_t row, int column, double number) {
  if (array.data)
    static_cast<double*>(array.data)[int64_t(row) * array.row_stride + column * array.column_stride] = number;
}

// Returns a component of a vector, by the terms and in the order of displacement() in common/lists/displacement.cpp.
__device__ double component(const ListSystem& system, double from, double to, const int* shift, int axis) {
  ExactSum<8> sum;
  sum.add(to);
  sum.add(-from);
  for (int k = 0; k < 3; ++k)
    if (shift[k] != 0) sum.add_product(shift[k], system.row.of[3 * k + axis]);
  return sum.rounded();
}

__device__ void write_vector(const KernelBuffers& list, uint64_t k, uint i, uint j, const DeviceColumns& to) {
  const uint element = list.list_state[0].flags & LIST_ASKS ? list.list_state[0].points + i : i;
  const ListSystem& system = list.list_system[list.list_place[element].w];
  const dvec4 a = list.list_given[element], b = list.list_given[j];
  const int* shift = list.list_shift + 3 * k;
  const double x = component(system, a.x, b.x, shift, 0), y = component(system, a.y, b.y, shift, 1),
               z = component(system, a.z, b.z, shift, 2);
  put(to.vectors, k, 0, x);
  put(to.vectors, k, 1, y);
  put(to.vectors, k, 2, z);
  put(to.distances, k, 0, sqrt(x * x + y * y + z * z));
}

__device__ int64_t found_number(const KernelBuffers& list, int64_t pairs) {
  const ListState& state = list.list_state[0];
  if (state.wrong != 0 || state.far != 0) return -1 - int64_t(~max(state.wrong, state.far));
  return state.wide != 0 ? INT64_MIN : pairs;
}

__global__ void __launch_bounds__(block)
    write_columns(KernelBuffers list, uint64_t looking, int64_t room, DeviceColumns to) {
  const int64_t pairs = found_number(list, list.list_begin[looking]);
  if (first_row() == 0) put(to.found, 0, 0, pairs);
  if (to.offsets.data)
    for (uint64_t i = first_row(); i <= looking; i += row_step()) put(to.offsets, i, 0, list.list_begin[i]);
  if (pairs < 0 || pairs > room) return;
  for (uint64_t k = first_row(); k < uint64_t(pairs); k += row_step()) {
    if (to.first.data) put(to.first, k, 0, int64_t(list.list_first[k]));
    if (to.second.data) put(to.second, k, 0, int64_t(list.list_second[k]));
    if (to.shifts.data)
      for (int axis = 0; axis < 3; ++axis) put(to.shifts, k, axis, int64_t(list.list_shift[3 * k + axis]));
    if (to.vectors.data || to.distances.data) write_vector(list, k, list.list_first[k], list.list_second[k], to);
  }
}

}  // namespace

void gather_points(cudaStream_t stream, const DeviceArray& points, const DeviceArray& radii, dvec4* to, uint64_t rows) {
  if (rows == 0) return;
  gather<<<blocks_for(rows), block, 0, stream>>>(points, radii, to, rows);
  cuda_check(cudaGetLastError(), "reading the points of a list");
}

void write_list_columns(cudaStream_t stream, const BufferHandles& list, uint64_t looking, int64_t room,
                        const DeviceColumns& to) {
  const auto buffers = std::bit_cast<KernelBuffers>(list);
  write_columns<<<blocks_for(std::max(uint64_t(room), looking + 1)), block, 0, stream>>>(buffers, looking, room, to);
  cuda_check(cudaGetLastError(), "writing the columns of a list");
}

}  // namespace spherepair
