// SPDX-License-Identifier: MIT
// Reads spheres from an NPY array: n x 3 centres, n x 4 with the radius, or a structured array with fields of these
// names. Also converts the binary numbers of all other formats.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "bench/npy/npy_array.h"
#include "bench/spheres/columns.h"
#include "bench/spheres/sphere_file.h"

namespace spherepair {
namespace {

struct Half {
  uint16_t bits;
  operator float() const {
    const int exponent = bits >> 10 & 31, fraction = bits & 1023;
    const float size = exponent == 31  ? (fraction ? NAN : INFINITY)
                       : exponent == 0 ? std::ldexp(float(fraction), -24)
                                       : std::ldexp(float(fraction + 1024), exponent - 25);
    return bits >> 15 ? -size : size;
  }
};

template <typename Number>
Number load(const NumberColumn& column, uint64_t row) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), column.file->bytes().data() + column.byte_of(row), sizeof bytes);
  const char foreign = std::endian::native == std::endian::little ? '>' : '<';
  if (column.dtype[0] == foreign) std::ranges::reverse(bytes);
  return std::bit_cast<Number>(bytes);
}

// Converts a number, and notes whether float32 changes it. Float32 holds every number of the shorter types.
template <typename Number>
Decimal converted(Number number) {
  if constexpr (std::is_same_v<Number, Half> || sizeof(Number) < 4 || std::is_same_v<Number, float>) {
    const float value = float(number);
    return {double(value), value, false};
  } else {
    const float value = float(number);
    return {double(number), value, static_cast<long double>(value) != static_cast<long double>(number)};
  }
}

// Calls work with a value of the dtype's type.
template <typename Work>
void with_type(std::string_view dtype, Work work) {
  const auto is = [&](const char* wanted, auto value) { return dtype.substr(1) == wanted && (work(value), true); };
  const bool known = is("f4", float()) || is("f8", double()) || is("f2", Half()) || is("i1", int8_t()) ||
                     is("i2", int16_t()) || is("i4", int32_t()) || is("i8", int64_t()) || is("u1", uint8_t()) ||
                     is("u2", uint16_t()) || is("u4", uint32_t()) || is("u8", uint64_t());
  if (!known) throw std::logic_error("a dtype that table_of refuses");
}

bool float32_holds(std::string_view dtype) { return dtype.ends_with("f4") || dtype[2] == '2' || dtype[2] == '1'; }

struct Converted {
  uint64_t changed = 0, wrong = 0;
  uint64_t first_wrong = std::numeric_limits<uint64_t>::max();  // row * columns + column
};

template <typename Number>
void convert_column(const NumberTable& table, size_t k, uint64_t start, uint64_t end, SphereRows& rows,
                    Converted& done) {
  const NumberColumn& column = table.columns[k];
  const bool is_radius = column.quantity == QUANTITY_RADIUS;
  for (uint64_t row = start; row < end; ++row) {
    Decimal number = converted(load<Number>(column, row));
    if (why_invalid(number.value, is_radius)) [[unlikely]] {
      ++done.wrong;
      done.first_wrong = std::min(done.first_wrong, row * table.columns.size() + k);
      continue;
    }
    if (is_radius && table.meaning.diameters) number = halved(number);
    rows.set(row, column.quantity, number);
    done.changed += number.changed;
  }
}

// Integer sums and a minimum do not depend on the number of threads.
Converted convert(const NumberTable& table, SphereRows& rows, int threads) {
  uint64_t changed = 0, wrong = 0, first_wrong = Converted{}.first_wrong;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(+ : changed, wrong) reduction(min : first_wrong)
  for (uint64_t start = 0; start < table.rows; start += 4096) {
    Converted done;
    const uint64_t end = std::min(start + 4096, table.rows);
    for (size_t k = 0; k < table.columns.size(); ++k)
      with_type(table.columns[k].dtype,
                [&](auto number) { convert_column<decltype(number)>(table, k, start, end, rows, done); });
    changed += done.changed;
    wrong += done.wrong;
    first_wrong = std::min(first_wrong, done.first_wrong);
  }
  return {changed, wrong, first_wrong};
}

[[noreturn]] void refuse(const NumberTable& table, const Converted& done) {
  const uint64_t row = done.first_wrong / table.columns.size();
  const NumberColumn& column = table.columns[done.first_wrong % table.columns.size()];
  const double value = number_at(column, row);
  column.file->fail_at_byte(
      column.byte_of(row), why_invalid(value, column.quantity == QUANTITY_RADIUS),
      fmt::format("{} ({} of sphere {}; the first of {} such numbers of {})", value, quantity_names[column.quantity],
                  row, done.wrong, table.rows * table.columns.size()));
}

}  // namespace

double number_at(const NumberColumn& column, uint64_t row) {
  double value = 0;
  with_type(column.dtype, [&](auto number) { value = converted(load<decltype(number)>(column, row)).value; });
  return value;
}

void read_numbers(NumberTable table, const SphereFileOptions& options, SphereRows& rows, SphereFile& input) {
  const auto any = [&](auto wanted) { return std::ranges::any_of(table.columns, wanted); };
  input.unused_radii = take_radii_away(table.meaning, options);
  if (input.unused_radii)
    std::erase_if(table.columns, [](const NumberColumn& column) { return column.quantity == QUANTITY_RADIUS; });
  input.own_radii = any([](const NumberColumn& column) { return column.quantity == QUANTITY_RADIUS; });
  check_radius(table.file, table.meaning, options);
  input.units = table.meaning.units;
  const double radius = options.radius.value_or(0);
  rows.resize(table.rows, radius, any([](const NumberColumn& column) { return column.quantity >= QUANTITY_VX; }),
              options.exact || radius != double(float(radius)) || table.meaning.diameters ||
                  any([](const NumberColumn& column) { return !float32_holds(column.dtype); }));
  input.values = table.rows * table.columns.size();
  const Converted done = convert(table, rows, reading_threads(options));
  if (done.wrong) refuse(table, done);
  input.changed = done.changed;
}

SphereFile read_npy(const FileBytes& file, const SphereFileOptions& options, SphereRows& rows) {
  const NpyHeader header = read_npy_header(file);
  const NumberTable table = table_of(file, header, options.columns);
  SphereFile input;
  read_numbers(table, options, rows, input);
  input.format = describe(table, header);
  return input;
}

}  // namespace spherepair
