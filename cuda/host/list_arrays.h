// SPDX-License-Identifier: MIT
// Kernels that copy between callers' arrays and the buffers of a list, in the stream given.
#pragma once

#include <cuda_runtime.h>

#include "common/device/device_arrays.h"

namespace spherepair {

void gather_points(cudaStream_t stream, const DeviceArray& points, const DeviceArray& radii, dvec4* to, uint64_t rows);
void write_list_columns(cudaStream_t stream, const BufferHandles& list, uint64_t looking, int64_t room,
                        const DeviceColumns& to);

}  // namespace spherepair
