// SPDX-License-Identifier: MIT
#include "bench/npy/npy_array.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/io/numbers.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

std::string shape_text(const NpyHeader& header) {
  return fmt::format("({}{})", fmt::join(header.shape, ", "), header.shape.size() == 1 ? "," : "");
}

void require_known(const FileBytes& file, const NpyField& field) {
  if (!is_real_dtype(field.dtype))
    file.fail_at_byte(field.dtype_at,
                      "a dtype of real numbers: float16, float32, float64, int8 ... int64 or uint8 ... uint64",
                      in_quotes(field.dtype));
}

// Columns by the names of a structured array's fields, or by --columns, or by their order.
Columns columns_of(const FileBytes& file, const NpyHeader& header, std::span<const std::string> option) {
  std::vector<NamedColumn> names;
  if (header.structured)
    for (const NpyField& field : header.fields) names.push_back({field.name, field.count});
  if (!option.empty()) return columns_of_option(option, names, file.name());
  if (!header.structured) return columns_by_order(header.shape[1]);
  return columns_of_names(fmt::format("{}, byte {}", file.name(), header.fields.front().dtype_at), names);
}

void add_column(NpyArray& array, Quantity quantity, const NpyField& field, uint64_t first, uint64_t stride) {
  require_known(array.file, field);
  array.columns.push_back({quantity, field.dtype, first, stride});
}

NpyArray structured_array(const FileBytes& file, const NpyHeader& header, const Columns& columns) {
  NpyArray array{.file = file, .meaning = columns};
  uint64_t row_bytes = 0;
  for (const NpyField& field : header.fields) row_bytes += field.count * field.item_bytes();
  uint64_t offset = header.data_at, column = 0;
  for (const NpyField& field : header.fields) {
    bool read = false;
    for (uint64_t k = 0; k < field.count; ++k, ++column, offset += field.item_bytes())
      for (size_t q = 0; q < quantity_names.size(); ++q)
        if (columns.columns[q] == column) add_column(array, Quantity(q), field, offset, row_bytes), read = true;
    if (!read && !field.name.empty()) array.not_read += (array.not_read.empty() ? "" : ", ") + in_quotes(field.name);
  }
  return array;
}

NpyArray plain_array(const FileBytes& file, const NpyHeader& header, const Columns& columns) {
  const NpyField& field = header.fields.front();
  const uint64_t rows = header.shape[0], size = field.item_bytes();
  NpyArray array{.file = file, .meaning = columns};
  for (size_t q = 0; q < quantity_names.size(); ++q)
    if (columns.columns[q])
      add_column(array, Quantity(q), field,
                 header.data_at + *columns.columns[q] * (header.fortran_order ? rows : 1) * size,
                 header.fortran_order ? size : header.shape[1] * size);
  return array;
}

void check_shape(const FileBytes& file, const NpyHeader& header, uint64_t columns_of_option) {
  const auto fail = [&](std::string_view expected) {
    file.fail_at_byte(header.shape_at, expected, shape_text(header));
  };
  if (header.structured && header.shape.size() != 1) fail("shape (n,) of a structured array");
  const bool plain = !header.structured && header.shape.size() == 2;
  if (plain && columns_of_option && header.shape[1] != columns_of_option)
    fail(fmt::format("shape (n, {}), by --columns", columns_of_option));
  if (!header.structured && (!plain || (!columns_of_option && (header.shape[1] < 3 || header.shape[1] > 4))))
    fail("shape (n, 3): x y z, or (n, 4): x y z radius; other columns need --columns");
  if (header.shape[0] > kMostSpheres) fail(fmt::format("at most {} spheres", kMostSpheres));
}

}  // namespace

bool is_real_dtype(std::string_view dtype) {
  constexpr std::string_view known[] = {"f2", "f4", "f8", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8"};
  if (dtype.size() != 3 || std::ranges::find(known, dtype.substr(1)) == std::end(known)) return false;
  return std::string_view("<>=").find(dtype[0]) != dtype.npos || (dtype[0] == '|' && dtype[2] == '1');
}

NpyArray array_of(const FileBytes& file, const NpyHeader& header, std::span<const std::string> option) {
  if (header.fields.empty()) file.fail_at_byte(header.data_at, "a structured array with fields", "none");
  if (!header.structured) require_known(file, header.fields.front());
  for (const NpyField& field : header.fields)
    if (!field.item_bytes()) file.fail_at_byte(field.dtype_at, "a dtype of fixed size", in_quotes(field.dtype));
  check_shape(file, header, option.size());
  const Columns columns = columns_of(file, header, option);
  NpyArray array = header.structured ? structured_array(file, header, columns) : plain_array(file, header, columns);
  array.rows = header.shape[0];
  uint64_t row_bytes = 0;
  for (const NpyField& field : header.fields) row_bytes += field.count * field.item_bytes();
  const uint64_t wanted = array.rows * row_bytes * (header.structured ? 1 : header.shape[1]),
                 found = file.bytes().size() - header.data_at;
  if (found < wanted)
    file.fail_at_byte(file.bytes().size(),
                      fmt::format("{} of data from byte {} on", counted(wanted, "byte"), header.data_at),
                      fmt::format("the end of the file after {}: it is truncated", found));
  if (found > wanted)
    file.fail_at_byte(header.data_at + wanted, "the end of the file after the data",
                      counted(found - wanted, "trailing byte"));
  return array;
}

std::string describe(const NpyArray& array, const NpyHeader& header) {
  if (header.structured) {
    std::string text = fmt::format("NPY, {} structured rows of", array.rows);
    for (const NpyColumn& column : array.columns)
      text += fmt::format(" {}{}:{}", quantity_names[column.quantity],
                          column.quantity == QUANTITY_RADIUS && array.meaning.diameters ? " (half the diameter)" : "",
                          column.dtype.substr(1));
    return text + (array.not_read.empty() ? "" : "; not read: " + array.not_read);
  }
  const std::string_view dtype = header.fields.front().dtype;
  const char* kind = dtype[1] == 'f' ? "float" : dtype[1] == 'i' ? "int" : "uint";
  return fmt::format("NPY ({}), {} x {} {}{} {}-endian in {} order", array.meaning.text, array.rows,
                     array.meaning.count, kind, 8 * (dtype[2] - '0'), dtype[0] == '>' ? "big" : "little",
                     header.fortran_order ? "Fortran" : "C");
}

}  // namespace spherepair
