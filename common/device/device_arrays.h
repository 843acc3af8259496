// SPDX-License-Identifier: MIT
// Arrays that callers have in a device's memory, and the stream in which they use them.
#pragma once

#include "common/device/memory.h"

namespace spherepair {

enum class ElementType { float32, float64, int32, int64 };

// Element (row, column) is at data + row * row_stride + column * column_stride elements. Null: there is none.
struct DeviceArray {
  void* data = nullptr;
  ElementType type = {};
  int64_t row_stride = 1, column_stride = 1;
};

// The columns of a list that are written for each of its pairs.
struct DeviceColumns {
  DeviceArray first, second, shifts, vectors, distances;
  DeviceArray offsets;  // of each row
  DeviceArray found;    // one int64: the number of pairs; see DeviceArrays::write_columns
};

class DeviceArrays {
 public:
  virtual ~DeviceArrays() = default;
  virtual bool has(const void* data, int number) const = 0;  // whether it is memory of this device, of that number
  // From here to `end`, launches and copies go to the stream; null: to the default stream.
  virtual void begin(void* stream) = 0;
  virtual void end() noexcept = 0;
  virtual bool is_captured() const = 0;  // whether the stream is being captured into a graph

  virtual void read(const void* data, void* to, uint64_t bytes) = 0;  // to the host; waits
  // `rows` points with their radii into dvec4, from element `first` on.
  virtual void read_points(const DeviceArray& points, const DeviceArray& radii, const Memory& to, uint64_t first,
                           uint64_t rows) = 0;
  // The columns of a list of at most `room` pairs from the buffers of its kernels. `found` gets the number of pairs,
  // also where it is more than `room`; -1 - i where element i is not listed; the lowest int64 where the list needs a
  // call that waits.
  virtual void write_columns(const BufferHandles& list, uint64_t looking, int64_t room, const DeviceColumns& to) = 0;
};

}  // namespace spherepair
