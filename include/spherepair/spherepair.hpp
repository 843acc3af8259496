// SPDX-License-Identifier: MIT
//
// Lists of pairs for C++20: spherepair.h with spans, owners and exceptions. That header defines a pair, full and half
// lists, and the order of lists.
//
//   spherepair::Context context("cpu");
//   const auto list = context.list({.positions = positions, .cutoff = 1.5, .half = true}, SP_DISTANCES);
//   for (int64_t k = 0; k < list.size(); ++k) use(list.first()[k], list.second()[k], list.distances()[k]);
#pragma once

#include <spherepair/spherepair.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>

namespace spherepair {

// A call that failed. what() says which argument is wrong and why, or has the driver's reason.
class Error : public std::runtime_error {
 public:
  Error(sp_status status, const std::string& message) : std::runtime_error(message), status_(status) {}
  sp_status status() const noexcept { return status_; }

 private:
  sp_status status_;
};

// Context::fill found more pairs than a column has rows. Nothing was written.
class CapacityError : public Error {
 public:
  CapacityError(int64_t needed, const std::string& message) : Error(SP_E_CAPACITY, message), needed_(needed) {}
  int64_t needed() const noexcept { return needed_; }  // pairs in the list

 private:
  int64_t needed_;
};

template <typename Item, typename... Types>
concept OneOf = (std::same_as<Item, Types> || ...);

template <typename Range, typename... Types>
concept RangeOf = std::ranges::contiguous_range<Range> && std::ranges::sized_range<Range> &&
    OneOf<std::ranges::range_value_t<Range>, Types...>;

namespace detail {

template <typename Number>
inline constexpr sp_type type_of = std::integral<Number> ? (sizeof(Number) == 4 ? SP_I32 : SP_I64)
                                                         : (sizeof(Number) == 4 ? SP_F32 : SP_F64);

// An array in the host's memory. It has an address even if it has no rows, so that it counts as given.
inline sp_array host_array(const void* data, sp_type type, int64_t rows, int64_t columns, int64_t row_stride) {
  static constexpr int64_t none = 0;
  return {const_cast<void*>(data ? data : &none), rows, columns, row_stride, 1, type, 1, 0};
}

struct Release {
  void operator()(sp_context* context) const { sp_close(context); }
  void operator()(sp_pairs* pairs) const { sp_free(pairs); }
};

}  // namespace detail

// A view of the caller's rows of `Columns` numbers. A view of an empty range counts as given, with no rows.
template <size_t Columns, typename... Types>
class View {
 public:
  View() = default;  // not given

  // A range of numbers, one row after another. Throws Error if the last row is not whole.
  template <RangeOf<Types...> Range>
  View(const Range& range) : View(std::ranges::data(range), int64_t(std::ranges::size(range) / Columns)) {
    if (const size_t size = std::ranges::size(range); size % Columns != 0)
      throw Error(SP_E_ARGUMENT, "an array has " + std::to_string(size) + " numbers, but each of its rows has " +
                                     std::to_string(Columns));
  }

  // A range of rows, each a std::array.
  template <RangeOf<std::array<Types, Columns>...> Range>
  View(const Range& range)
      : View(std::ranges::empty(range) ? nullptr : std::ranges::data(range)->data(),
             int64_t(std::ranges::size(range))) {}

  // Rows that are part of larger structs: row k begins k * stride numbers after `data`.
  template <OneOf<Types...> Number>
  View(const Number* data, int64_t rows, int64_t stride = Columns)
      : array_(detail::host_array(data, detail::type_of<Number>, rows, Columns, stride)) {}

  const sp_array& array() const { return array_; }

 private:
  sp_array array_ = {};
};

using Points = View<3, double, float>;
using Numbers = View<1, double, float>;
using Offsets = View<1, int64_t, int32_t>;
using Exclusions = View<2, int64_t, int32_t>;

// The rows H_0, H_1, H_2 of a box, and along which of them it is periodic. A row that is not periodic is not read.
struct Box {
  std::array<std::array<double, 3>, 3> rows = {};
  std::array<bool, 3> periodic = {true, true, true};

  static Box orthogonal(double x, double y, double z) { return {{{{x, 0, 0}, {0, y, 0}, {0, 0, z}}}}; }
};

// The problem: which pairs to list; sp_problem explains each field. Views must stay valid until the call returns.
struct Problem {
  Points positions = {};            // N x 3
  Numbers radii = {};               // N; not given: the cutoff is for all
  double cutoff = 0, skin = 0;      // lengths, in the unit of the positions
  std::optional<Box> box = {};      // of every system; neither box nor boxes: open
  std::span<const Box> boxes = {};  // B, one a system
  Offsets offsets = {};             // B + 1; not given: one system
  Points queries = {};              // Q x 3; given: pairs of query i and point j
  Numbers query_radii = {};         // Q
  Offsets query_offsets = {};       // B + 1
  Exclusions exclusions = {};       // E x 2
  bool half = false, inclusive = false, self_pairs = false;

  // The C struct; it points into this one. Throws Error if both box and boxes are given.
  sp_problem in_c() const {
    if (box && !boxes.empty()) throw Error(SP_E_ARGUMENT, "box and boxes are given: give one of them");
    const Box* const rows = box ? &*box : boxes.data();
    const int64_t count = box ? 1 : int64_t(boxes.size()), doubles = sizeof(Box) / sizeof(double);
    return {.size = sizeof(sp_problem),
            .positions = positions.array(),
            .radii = radii.array(),
            .cutoff = cutoff,
            .skin = skin,
            .boxes = count ? detail::host_array(&rows->rows, SP_F64, count, 9, doubles) : sp_array{},
            .periodic = count ? detail::host_array(&rows->periodic, SP_U8, count, 3, sizeof(Box)) : sp_array{},
            .offsets = offsets.array(),
            .queries = queries.array(),
            .query_radii = query_radii.array(),
            .query_offsets = query_offsets.array(),
            .exclusions = exclusions.array(),
            .half = half,
            .inclusive = inclusive,
            .self_pairs = self_pairs,
            .stream = nullptr};
  }
};

// The caller's memory for a list; a column that is not given is not written.
struct Columns {
  std::optional<std::span<int32_t>> first = {}, second = {};
  std::optional<std::span<std::array<int32_t, 3>>> shifts = {};
  std::optional<std::span<std::array<double, 3>>> vectors = {};
  std::optional<std::span<double>> distances = {};
  std::optional<std::span<int64_t>> offsets = {};  // N + 1 rows, or Q + 1

  sp_pairs in_c() const {
    const auto array = [](const auto& rows, sp_type type, int64_t columns = 1) {
      return rows ? detail::host_array(rows->data(), type, int64_t(rows->size()), columns, columns) : sp_array{};
    };
    return {sizeof(sp_pairs),
            0,
            array(first, SP_I32),
            array(second, SP_I32),
            array(shifts, SP_I32, 3),
            array(vectors, SP_F64, 3),
            array(distances, SP_F64),
            array(offsets, SP_I64),
            sp_array{}};
  }
};

// A list of pairs, in memory of its own: it outlives the context that made it. Columns that were not wanted are empty.
class PairList {
 public:
  explicit PairList(sp_pairs* owned) : pairs_(owned) {}

  int64_t size() const { return pairs_->count; }
  std::span<const int32_t> first() const { return column<int32_t>(pairs_->first); }
  std::span<const int32_t> second() const { return column<int32_t>(pairs_->second); }
  std::span<const std::array<int32_t, 3>> shifts() const { return column<std::array<int32_t, 3>>(pairs_->shifts); }
  std::span<const std::array<double, 3>> vectors() const { return column<std::array<double, 3>>(pairs_->vectors); }
  std::span<const double> distances() const { return column<double>(pairs_->distances); }
  // N + 1 rows, or Q + 1: pairs of point i are offsets()[i] to offsets()[i + 1] - 1.
  std::span<const int64_t> offsets() const { return column<int64_t>(pairs_->offsets); }

 private:
  template <typename Row>
  static std::span<const Row> column(const sp_array& array) {
    return {static_cast<const Row*>(array.data), size_t(array.rows)};
  }

  std::unique_ptr<sp_pairs, detail::Release> pairs_;
};

// An open backend. One thread at a time uses it; several contexts can be used at once.
class Context {
 public:
  // Opens a backend: cpu, opengl, cuda, vulkan, or auto: the first of CUDA, Vulkan and OpenGL on a GPU, else cpu.
  // device: a GPU's number or UUID. threads: of cpu; 0: one a core. Throws Error: SP_E_BACKEND if the backend is
  // missing here, SP_E_ARGUMENT for an unknown name.
  explicit Context(const std::string& backend = "auto", const std::string& device = "", int32_t threads = 0) {
    if (sp_abi_version() != SP_ABI_VERSION)
      throw Error(SP_E_BACKEND, "the library that was loaded has another ABI than spherepair.h: compile again");
    sp_context* opened = nullptr;
    const sp_status status = sp_open(backend.c_str(), device.empty() ? nullptr : device.c_str(), threads, &opened);
    context_.reset(opened);
    check(status);
  }

  std::string backend() const { return sp_backend(context_.get()); }  // its name; after "auto" the chosen one's
  std::string device() const { return sp_device(context_.get()); }    // as the driver names it

  // Counts the pairs. Throws Error, as list and fill do, with any status but SP_E_CAPACITY.
  int64_t count(const Problem& problem) {
    int64_t count = 0;
    const sp_problem asked = problem.in_c();
    check(sp_count(context_.get(), &asked, &count));
    return count;
  }

  // Makes the list. wanted: a sum of SP_SHIFTS, SP_VECTORS, SP_DISTANCES and SP_OFFSETS.
  PairList list(const Problem& problem, uint32_t wanted = 0) {
    sp_pairs* pairs = nullptr;
    const sp_problem asked = problem.in_c();
    check(sp_list(context_.get(), &asked, wanted, &pairs));
    return PairList(pairs);
  }

  // Writes the list into the columns and returns its number of pairs. Throws CapacityError if a column is too short.
  int64_t fill(const Problem& problem, const Columns& columns) {
    sp_pairs pairs = columns.in_c();
    const sp_problem asked = problem.in_c();
    const sp_status status = sp_fill(context_.get(), &asked, &pairs);
    if (status == SP_E_CAPACITY) throw CapacityError(pairs.count, sp_message(context_.get()));
    check(status);
    return pairs.count;
  }

 private:
  void check(sp_status status) const {
    if (status != SP_OK) throw Error(status, sp_message(context_.get()));
  }

  std::unique_ptr<sp_context, detail::Release> context_;
};

}  // namespace spherepair
