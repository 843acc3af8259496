// SPDX-License-Identifier: MIT
#include "api/c/arrays.h"

#include <fmt/format.h>

#include <algorithm>

namespace spherepair {
namespace {

constexpr const char* type_names[] = {"F32", "F64", "I32", "I64", "U8"};
constexpr int64_t type_sizes[] = {4, 8, 4, 8, 1};

template <typename Number, typename Element>
std::vector<Number> read(const sp_array& array) {
  std::vector<Number> numbers(size_t(array.rows) * size_t(array.columns));
  in_shares(0, array.rows, [&](int64_t begin, int64_t end) {
    for (int64_t row = begin; row < end; ++row)
      for (int64_t column = 0; column < array.columns; ++column)
        numbers[size_t(row * array.columns + column)] = Number(element<Element>(array, row, column));
  });
  return numbers;
}

}  // namespace

void refuse(const std::string& what) { throw ListError(ListFault::argument, what); }

void check_shape(const sp_array& array, const std::string& name, int64_t columns,
                 std::initializer_list<sp_type> types) {
  if (!array.data && array.rows == 0 && array.columns == 0) refuse(name + " are missing");
  if (array.rows < 0 || array.columns != columns)
    refuse(fmt::format("{} has {} rows of {}, but each row has {}", name, array.rows, array.columns, columns));
  if (array.rows > 0 && !array.data) refuse(fmt::format("{} has {} rows but no data", name, array.rows));
  if (array.rows > most_points)
    throw ListError(ListFault::range,
                    fmt::format("{} has {} rows, but {} at most can be read", name, array.rows, most_points));
  if (std::ranges::any_of(types, [&](sp_type type) { return int32_t(type) == array.type; })) return;
  std::string allowed;
  for (const sp_type type : types) allowed += (allowed.empty() ? "" : " or ") + std::string(type_names[type]);
  const bool known = array.type >= SP_F32 && array.type <= SP_U8;
  refuse(fmt::format("{} is of type {}, but must be {}", name,
                     known ? type_names[array.type] : std::to_string(array.type), allowed));
}

void check_array(const sp_array& array, const std::string& name, int64_t columns,
                 std::initializer_list<sp_type> types) {
  if (is_given(array) && array.device_type != host_memory && array.device_type != cuda_pinned_memory)
    refuse(
        fmt::format("{} lies on a device of type {} (as DLPack has them), but positions in the host's memory: both "
                    "must lie in one",
                    name, array.device_type));
  check_shape(array, name, columns, types);
}

sp_array on_host(const sp_array& array, const ReadDevice& read, std::vector<std::byte>& keep) {
  if (!is_cuda_array(array) || array.rows < 1 || array.columns < 1 || !array.data) return array;
  if (array.type < SP_F32 || array.type > SP_U8) return array;
  const int64_t rows = (array.rows - 1) * array.row_stride, columns = (array.columns - 1) * array.column_stride;
  const int64_t low = std::min<int64_t>(rows, 0) + std::min<int64_t>(columns, 0),
                high = std::max<int64_t>(rows, 0) + std::max<int64_t>(columns, 0), size = type_sizes[array.type];
  keep.resize(size_t((high - low + 1) * size));
  read(static_cast<const std::byte*>(array.data) + low * size, keep.data(), keep.size());
  sp_array copy = array;
  copy.data = keep.data() - low * size;
  copy.device_type = host_memory;
  return copy;
}

std::vector<double> read_numbers(const sp_array& array, const std::string& name, int64_t columns) {
  check_array(array, name, columns, {SP_F32, SP_F64});
  return array.type == SP_F32 ? read<double, float>(array) : read<double, double>(array);
}

std::vector<int64_t> read_integers(const sp_array& array, const std::string& name, int64_t columns) {
  check_array(array, name, columns, {SP_I32, SP_I64});
  return array.type == SP_I32 ? read<int64_t, int32_t>(array) : read<int64_t, int64_t>(array);
}

std::vector<uint8_t> read_flags(const sp_array& array, const std::string& name, int64_t columns) {
  check_array(array, name, columns, {SP_U8});
  return read<uint8_t, uint8_t>(array);
}

std::vector<Point3> read_points(const sp_array& array, const std::string& name, std::vector<Point3> points) {
  check_array(array, name, 3, {SP_F32, SP_F64});
  points.resize(size_t(array.rows));
  const auto read_as = [&]<typename Element>(Element) {
    in_shares(0, array.rows, [&](int64_t begin, int64_t end) {
      for (int64_t row = begin; row < end; ++row)
        for (int64_t axis = 0; axis < 3; ++axis) points[size_t(row)][size_t(axis)] = element<Element>(array, row, axis);
    });
  };
  if (array.type == SP_F32)
    read_as(float());
  else
    read_as(double());
  return points;
}

}  // namespace spherepair
