// SPDX-License-Identifier: MIT
#include "bench/spheres/npy_array.h"

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

// The fields that a structured array may have; of those of three numbers the first quantity.
struct KnownField {
  std::string_view name;
  Quantity first;
  uint64_t count = 1;
};
constexpr KnownField known_fields[] = {
    {"x", QUANTITY_X},          {"y", QUANTITY_Y},           {"z", QUANTITY_Z},           {"radius", QUANTITY_RADIUS},
    {"radii", QUANTITY_RADIUS}, {"r", QUANTITY_RADIUS},      {"vx", QUANTITY_VX},         {"vy", QUANTITY_VY},
    {"vz", QUANTITY_VZ},        {"pos", QUANTITY_X, 3},      {"position", QUANTITY_X, 3}, {"velo", QUANTITY_VX, 3},
    {"vel", QUANTITY_VX, 3},    {"velocity", QUANTITY_VX, 3}};

NpyArray structured_array(const FileBytes& file, const NpyHeader& header) {
  NpyArray array{.file = file};
  uint64_t offset = header.data_at, row_bytes = 0;
  for (const NpyField& field : header.fields) {
    if (!field.item_bytes()) file.fail_at_byte(field.dtype_at, "a dtype of fixed size", in_quotes(field.dtype));
    row_bytes += field.count * field.item_bytes();
  }
  for (const NpyField& field : header.fields) {
    const auto known = std::ranges::find(known_fields, field.name, &KnownField::name);
    if (known == std::end(known_fields) || known->count != field.count) {
      if (!field.name.empty()) array.not_read += (array.not_read.empty() ? "" : ", ") + in_quotes(field.name);
    } else {
      require_known(file, field);
      for (uint64_t k = 0; k < field.count; ++k)
        array.columns.push_back({Quantity(known->first + k), field.dtype, offset + k * field.item_bytes(), row_bytes});
    }
    offset += field.count * field.item_bytes();
  }
  std::vector<std::string> names;
  for (const NpyColumn& column : array.columns) names.push_back(quantity_names[column.quantity]);
  columns_of_names(fmt::format("{}, byte {}", file.name(), header.fields.front().dtype_at), names);
  return array;
}

NpyArray plain_array(const FileBytes& file, const NpyHeader& header) {
  const NpyField& field = header.fields.front();
  require_known(file, field);
  const uint64_t rows = header.shape[0], columns = header.shape[1], size = field.item_bytes();
  NpyArray array{.file = file};
  for (uint64_t k = 0; k < columns; ++k)
    array.columns.push_back({Quantity(k), field.dtype, header.data_at + k * (header.fortran_order ? rows : 1) * size,
                             header.fortran_order ? size : columns * size});
  return array;
}

void check_shape(const FileBytes& file, const NpyHeader& header) {
  const auto fail = [&](std::string_view expected) {
    file.fail_at_byte(header.shape_at, expected, shape_text(header));
  };
  if (header.structured && header.shape.size() != 1) fail("shape (n,) of a structured array");
  if (!header.structured && (header.shape.size() != 2 || header.shape[1] < 3 || header.shape[1] > 4))
    fail("shape (n, 3): x y z, or (n, 4): x y z radius");
  if (header.shape[0] > kMostSpheres) fail(fmt::format("at most {} spheres", kMostSpheres));
}

}  // namespace

bool is_real_dtype(std::string_view dtype) {
  constexpr std::string_view known[] = {"f2", "f4", "f8", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8"};
  if (dtype.size() != 3 || std::ranges::find(known, dtype.substr(1)) == std::end(known)) return false;
  return std::string_view("<>=").find(dtype[0]) != dtype.npos || (dtype[0] == '|' && dtype[2] == '1');
}

NpyArray array_of(const FileBytes& file, const NpyHeader& header) {
  if (header.fields.empty()) file.fail_at_byte(header.data_at, "a structured array with fields", "none");
  if (!header.structured) require_known(file, header.fields.front());
  check_shape(file, header);
  NpyArray array = header.structured ? structured_array(file, header) : plain_array(file, header);
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
      text += fmt::format(" {}:{}", quantity_names[column.quantity], column.dtype.substr(1));
    return text + (array.not_read.empty() ? "" : "; not read: " + array.not_read);
  }
  const std::string_view dtype = header.fields.front().dtype;
  const char* kind = dtype[1] == 'f' ? "float" : dtype[1] == 'i' ? "int" : "uint";
  return fmt::format("NPY, {} x {} {}{} {}-endian in {} order", array.rows, array.columns.size(), kind,
                     8 * (dtype[2] - '0'), dtype[0] == '>' ? "big" : "little", header.fortran_order ? "Fortran" : "C");
}

}  // namespace spherepair
