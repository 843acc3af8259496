// SPDX-License-Identifier: MIT
// Kernels between callers' arrays and those of a list; all go to the stream.
#pragma once

#include <cuda_runtime.h>

#include "common/device/device_arrays.h"

namespace spherepair {

void gather_points(cudaStream_t stream, const DeviceArray& points, const DeviceArray& radii, dvec4* to, uint64_t rows);
void write_list_columns(cudaStream_t stream, const BufferHandles& list, uint64_t looking, int64_t room,
                        const DeviceColumns& to);

}  // namespace spherepair
