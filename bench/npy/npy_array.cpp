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

// Finds the columns by the field names of a structured array, by --columns, or by their order.
Columns columns_of(const FileBytes& file, const NpyHeader& header, std::span<const std::string> option) {
  std::vector<NamedColumn> names;
  if (header.structured)
    for (const NpyField& field : header.fields) names.push_back({field.name, field.count});
  if (!option.empty()) return columns_of_option(option, names, file.name());
  if (!header.structured) return columns_by_order(header.shape[1]);
  return columns_of_names(fmt::format("{}, byte {}", file.name(), header.fields.front().dtype_at), names);
}

Columns checked_columns(const FileBytes& file, const NpyHeader& header, std::span<const std::string> option) {
  const Columns columns = columns_of(file, header, option);
  uint64_t count = 0;
  for (const NpyField& field : header.fields) count += field.count;
  if (header.structured && columns.count != count)
    file.fail_at_byte(header.fields.front().dtype_at,
                      fmt::format("fields of {}, by --columns", counted(columns.count, "column")),
                      fmt::to_string(count));
  return columns;
}

void add_column(NumberTable& table, Quantity quantity, const NpyField& field, uint64_t first, uint64_t stride) {
  require_known(table.file, field);
  table.columns.push_back({&table.file, quantity, field.dtype, first, stride});
}

NumberTable structured_array(const FileBytes& file, const NpyHeader& header, const Columns& columns) {
  NumberTable table{.file = file, .meaning = columns};
  uint64_t row_bytes = 0;
  for (const NpyField& field : header.fields) row_bytes += field.count * field.item_bytes();
  uint64_t offset = header.data_at, column = 0;
  for (const NpyField& field : header.fields) {
    bool read = false;
    for (uint64_t k = 0; k < field.count; ++k, ++column, offset += field.item_bytes())
      for (size_t q = 0; q < quantity_names.size(); ++q)
        if (columns.columns[q] == column) add_column(table, Quantity(q), field, offset, row_bytes), read = true;
    if (!read && !field.name.empty()) table.not_read += (table.not_read.empty() ? "" : ", ") + in_quotes(field.name);
  }
  return table;
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
}

// Throws unless the file has the bytes of its rows, and no more.
void check_size(const FileBytes& file, const NpyHeader& header) {
  const uint64_t rows = header.shape[0];
  if (rows > kMostSpheres)
    file.fail_at_byte(header.shape_at, fmt::format("at most {} spheres", kMostSpheres), shape_text(header));
  uint64_t row_bytes = 0;
  for (const NpyField& field : header.fields) row_bytes += field.count * field.item_bytes();
  if (!header.structured) row_bytes *= header.shape[1];
  const uint64_t found = file.bytes().size() - header.data_at;
  const bool fits = row_bytes == 0 || rows <= found / row_bytes;  // their product may be beyond 64 bits
  const uint64_t wanted = rows * row_bytes;
  if (!fits)
    file.fail_at_byte(file.bytes().size(),
                      fmt::format("{} of data from byte {} on", counted(wanted, "byte"), header.data_at),
                      fmt::format("the end of the file after {}: it is truncated", found));
  if (found > wanted)
    file.fail_at_byte(header.data_at + wanted, "the end of the file after the data",
                      counted(found - wanted, "trailing byte"));
}

}  // namespace

bool is_real_dtype(std::string_view dtype) {
  constexpr std::string_view known[] = {"f2", "f4", "f8", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8"};
  if (dtype.size() != 3 || std::ranges::find(known, dtype.substr(1)) == std::end(known)) return false;
  return std::string_view("<>=").find(dtype[0]) != dtype.npos || (dtype[0] == '|' && dtype[2] == '1');
}

NumberTable plain_table(const FileBytes& file, const NpyHeader& header, const Columns& columns) {
  const NpyField& field = header.fields.front();
  const uint64_t rows = header.shape[0], size = field.item_bytes();
  NumberTable table{.file = file, .rows = rows, .meaning = columns};
  for (size_t q = 0; q < quantity_names.size(); ++q)
    if (columns.columns[q])
      add_column(table, Quantity(q), field,
                 header.data_at + *columns.columns[q] * (header.fortran_order ? rows : 1) * size,
                 header.fortran_order ? size : header.shape[1] * size);
  check_size(file, header);
  return table;
}

NumberTable table_of(const FileBytes& file, const NpyHeader& header, std::span<const std::string> option) {
  if (header.fields.empty()) file.fail_at_byte(header.data_at, "a structured array with fields", "none");
  if (!header.structured) require_known(file, header.fields.front());
  for (const NpyField& field : header.fields)
    if (!field.item_bytes()) file.fail_at_byte(field.dtype_at, "a dtype of fixed size", in_quotes(field.dtype));
  check_shape(file, header, option.size());
  const Columns columns = checked_columns(file, header, option);
  if (!header.structured) return plain_table(file, header, columns);
  NumberTable table = structured_array(file, header, columns);
  table.rows = header.shape[0];
  check_size(file, header);
  return table;
}

std::string describe(const NumberTable& table, const NpyHeader& header) {
  if (header.structured) {
    std::string text = fmt::format("NPY, {} structured rows of", table.rows);
    for (const NumberColumn& column : table.columns)
      text += fmt::format(" {}{}:{}", quantity_names[column.quantity],
                          column.quantity == QUANTITY_RADIUS && table.meaning.diameters ? " (half the diameter)" : "",
                          column.dtype.substr(1));
    return text + (table.not_read.empty() ? "" : "; not read: " + table.not_read);
  }
  const std::string_view dtype = header.fields.front().dtype;
  const char* kind = dtype[1] == 'f' ? "float" : dtype[1] == 'i' ? "int" : "uint";
  return fmt::format("NPY ({}), {} x {} {}{} {}-endian in {} order", table.meaning.text, table.rows,
                     table.meaning.count, kind, 8 * (dtype[2] - '0'), dtype[0] == '>' ? "big" : "little",
                     header.fortran_order ? "Fortran" : "C");
}

}  // namespace spherepair
