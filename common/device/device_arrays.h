// SPDX-License-Identifier: MIT
// Arrays that callers have in a device's memory, and the stream in which callers use them.
#pragma once

#include "common/device/memory.h"

namespace spherepair {

enum class ElementType { float32, float64, int32, int64 };

// Element (row, column) is at data + row * row_stride + column * column_stride elements. data is null: no array.
struct DeviceArray {
  void* data = nullptr;
  ElementType type = {};
  int64_t row_stride = 1, column_stride = 1;
};

// The caller's columns, which get one row for each pair of a list.
struct DeviceColumns {
  DeviceArray first, second, shifts, vectors, distances;
  DeviceArray offsets;  // begin of each point's pairs: one row more than there are points
  DeviceArray found;    // one int64: the number of pairs; see DeviceArrays::write_columns
};

class DeviceArrays {
 public:
  virtual ~DeviceArrays() = default;
  virtual bool has(const void* data, int number) const = 0;  // data lies in this device's memory; number is its number
  // Until end(), launches and copies go to this stream; null: the default stream.
  virtual void begin(void* stream) = 0;
  virtual void end() noexcept = 0;
  virtual bool is_captured() const = 0;  // whether the stream is being captured into a graph

  virtual void read(const void* data, void* to, uint64_t bytes) = 0;  // copies to the host; waits
  // Copies `rows` points with their radii into dvec4, starting at element `first`.
  virtual void read_points(const DeviceArray& points, const DeviceArray& radii, const Memory& to, uint64_t first,
                           uint64_t rows) = 0;
  // Writes a list of at most `room` pairs from its kernels' buffers into the columns. `found` gets the number of pairs,
  // even if that is more than `room`. It gets -1 - i if element i cannot be listed, and the lowest int64 if the list
  // needs a call that waits.
  virtual void write_columns(const BufferHandles& list, uint64_t looking, int64_t room, const DeviceColumns& to) = 0;
};

}  // namespace spherepair
