// SPDX-License-Identifier: MIT
// Reads and writes the arrays of include/spherepair/spherepair.h. Messages name the array. All throw ListError.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/lists/list_systems.h"
#include "include/spherepair/spherepair.h"

namespace spherepair {

[[noreturn]] void refuse(const std::string& what);

inline bool is_given(const sp_array& array) { return array.data != nullptr || array.rows != 0; }

// DLPack's device types.
constexpr int32_t host_memory = 1, cuda_memory = 2, cuda_pinned_memory = 3, cuda_managed_memory = 13;
inline bool is_cuda_array(const sp_array& array) {
  return array.device_type == cuda_memory || array.device_type == cuda_managed_memory;
}

// Refuses an array that has another number of columns, another type, too many rows or no memory.
void check_shape(const sp_array& array, const std::string& name, int64_t columns, std::initializer_list<sp_type> types);
// Refuses the same, and an array that does not lie in the host's memory.
void check_array(const sp_array& array, const std::string& name, int64_t columns, std::initializer_list<sp_type> types);

// Copies bytes of a device's memory to the host's.
using ReadDevice = std::function<void(const void* from, void* to, uint64_t bytes)>;

// The same array in the host's memory: itself, or a copy that `keep` owns.
sp_array on_host(const sp_array& array, const ReadDevice& read, std::vector<std::byte>& keep);

// In the memory of `points`, whose contents are lost.
std::vector<Point3> read_points(const sp_array& array, const std::string& name, std::vector<Point3> points = {});
std::vector<double> read_numbers(const sp_array& array, const std::string& name, int64_t columns);
std::vector<int64_t> read_integers(const sp_array& array, const std::string& name, int64_t columns);
std::vector<uint8_t> read_flags(const sp_array& array, const std::string& name, int64_t columns);

// The element at this row and column, by the array's strides.
template <typename Element>
Element& element(const sp_array& array, int64_t row, int64_t column = 0) {
  return static_cast<Element*>(array.data)[row * array.row_stride + column * array.column_stride];
}

// Writes value(row, column) to each element, converted to the array's type.
template <typename Value>
void write_array(const sp_array& array, int64_t rows, int64_t columns, Value value) {
  const auto write = [&]<typename Element>(Element) {
    in_shares(0, rows, [&](int64_t begin, int64_t end) {
      for (int64_t row = begin; row < end; ++row)
        for (int64_t column = 0; column < columns; ++column)
          element<Element>(array, row, column) = Element(value(row, column));
    });
  };
  switch (array.type) {
    case SP_F32:
      return write(float());
    case SP_F64:
      return write(double());
    case SP_I32:
      return write(int32_t());
    case SP_I64:
      return write(int64_t());
    default:
      return write(uint8_t());
  }
}

}  // namespace spherepair
