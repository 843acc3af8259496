// SPDX-License-Identifier: MIT
// Reads spheres from an NPY array: n x 3 centres, or n x 4 with the radius.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <type_traits>

#include "bench/formats/npy_header.h"
#include "bench/formats/sphere_file.h"

namespace spherepair {
namespace {

struct Array {
  const FileBytes& file;
  uint64_t data_at, rows, columns;
  uint64_t row_stride, column_stride;  // bytes
  bool swap;                           // the file's byte order is not this machine's

  uint64_t byte_of(uint64_t row, uint64_t column) const { return data_at + row * row_stride + column * column_stride; }
};

template <typename Real>
Real load(const Array& array, uint64_t row, uint64_t column) {
  using Bits = std::conditional_t<sizeof(Real) == 4, uint32_t, uint64_t>;
  Bits bits;
  std::memcpy(&bits, array.file.bytes().data() + array.byte_of(row, column), sizeof bits);
  if (array.swap) {
    if constexpr (sizeof(Real) == 4)
      bits = __builtin_bswap32(bits);
    else
      bits = __builtin_bswap64(bits);
  }
  return std::bit_cast<Real>(bits);
}

struct Converted {
  uint64_t changed = 0, wrong = 0;
  uint64_t first_wrong = std::numeric_limits<uint64_t>::max();  // row * columns + column
};

template <typename Real>
void convert_row(const Array& array, uint64_t row, vec4& sphere, Converted& done) {
  float* fields[] = {&sphere.x, &sphere.y, &sphere.z, &sphere.w};
  for (uint64_t column = 0; column < array.columns; ++column) {
    const Real value = load<Real>(array, row, column);
    if (why_invalid(double(value), column == 3)) [[unlikely]] {
      ++done.wrong;
      done.first_wrong = std::min(done.first_wrong, row * array.columns + column);
      continue;
    }
    *fields[column] = float(value);
    done.changed += Real(*fields[column]) != value;
  }
}

// Integer sums and a minimum do not depend on the number of threads.
template <typename Real>
Converted convert(const Array& array, std::vector<vec4>& spheres, int threads) {
  uint64_t changed = 0, wrong = 0, first_wrong = Converted{}.first_wrong;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(+ : changed, wrong) reduction(min : first_wrong)
  for (uint64_t start = 0; start < array.rows; start += 65536) {
    Converted done;
    const uint64_t end = std::min(start + 65536, array.rows);
    for (uint64_t row = start; row < end; ++row) convert_row<Real>(array, row, spheres[row], done);
    changed += done.changed;
    wrong += done.wrong;
    first_wrong = std::min(first_wrong, done.first_wrong);
  }
  return {changed, wrong, first_wrong};
}

template <typename Real>
[[noreturn]] void refuse(const Array& array, const Converted& done) {
  const uint64_t row = done.first_wrong / array.columns, column = done.first_wrong % array.columns;
  const double value = double(load<Real>(array, row, column));
  constexpr const char* names[] = {"x", "y", "z", "radius"};
  array.file.fail_at_byte(array.byte_of(row, column), why_invalid(value, column == 3),
                          fmt::format("{} ({} of sphere {}; the first of {} such numbers of {})", value, names[column],
                                      row, done.wrong, array.rows * array.columns));
}

template <typename Real>
uint64_t fill(const Array& array, std::vector<vec4>& spheres, int threads) {
  const Converted done = convert<Real>(array, spheres, threads);
  if (done.wrong) refuse<Real>(array, done);
  return done.changed;
}

std::string shape_text(const NpyHeader& header) {
  return fmt::format("({}{})", fmt::join(header.shape, ", "), header.shape.size() == 1 ? "," : "");
}

void check_header(const FileBytes& file, const NpyHeader& header) {
  const std::string& dtype = header.dtype;
  const bool known = dtype.size() == 3 && std::string_view("<>=").find(dtype[0]) != std::string_view::npos &&
                     (dtype.ends_with("f4") || dtype.ends_with("f8"));
  if (!known)
    file.fail_at_byte(header.dtype_at, "dtype float32 ('<f4' or '>f4') or float64 ('<f8' or '>f8')", in_quotes(dtype));
  if (header.shape.size() != 2 || header.shape[1] < 3 || header.shape[1] > 4)
    file.fail_at_byte(header.shape_at, "shape (n, 3): x y z, or (n, 4): x y z radius", shape_text(header));
  constexpr uint64_t most = std::numeric_limits<int32_t>::max();
  if (header.shape[0] > most)
    file.fail_at_byte(header.shape_at, fmt::format("at most {} spheres", most), shape_text(header));
}

Array array_of(const FileBytes& file, const NpyHeader& header) {
  check_header(file, header);
  const uint64_t rows = header.shape[0], columns = header.shape[1], size = header.dtype.ends_with("f4") ? 4 : 8;
  const uint64_t wanted = rows * columns * size, found = file.bytes().size() - header.data_at;
  if (found < wanted)
    file.fail_at_byte(file.bytes().size(), fmt::format("{} bytes of data from byte {} on", wanted, header.data_at),
                      fmt::format("the end of the file after {}: it is truncated", found));
  if (found > wanted)
    file.fail_at_byte(header.data_at + wanted, "the end of the file after the data",
                      fmt::format("{} trailing bytes", found - wanted));
  const char foreign = std::endian::native == std::endian::little ? '>' : '<';
  return {file,
          header.data_at,
          rows,
          columns,
          header.fortran_order ? size : columns * size,
          header.fortran_order ? rows * size : size,
          header.dtype[0] == foreign};
}

}  // namespace

SphereFile read_npy(const FileBytes& file, const SphereFileOptions& options) {
  const NpyHeader header = read_npy_header(file);
  const Array array = array_of(file, header);
  if (options.frame)
    throw std::invalid_argument(fmt::format("{} is an NPY file, and --frame is for XYZ files only", file.name()));
  SphereFile input;
  input.own_radii = array.columns == 4;
  check_radius(file, input.own_radii, options);
  input.scene.positions.resize(array.rows, vec4{0, 0, 0, options.radius.value_or(0)});
  input.values = array.rows * array.columns;
  const bool single = header.dtype.ends_with("f4");
  const int threads = reading_threads(options);
  input.changed =
      single ? fill<float>(array, input.scene.positions, threads) : fill<double>(array, input.scene.positions, threads);
  input.format =
      fmt::format("NPY, {} x {} {} {}-endian in {} order", array.rows, array.columns, single ? "float32" : "float64",
                  header.dtype[0] == '>' ? "big" : "little", header.fortran_order ? "Fortran" : "C");
  return input;
}

}  // namespace spherepair
