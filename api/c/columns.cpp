// SPDX-License-Identifier: MIT
#include "api/c/columns.h"

#include <fmt/format.h>

#include "api/c/arrays.h"
#include "common/lists/list_systems.h"
#include "common/lists/pair_list.h"

namespace spherepair {
namespace {

void check_column(const sp_array& array, const char* name, int64_t columns, std::initializer_list<sp_type> types,
                  bool on_device) {
  if (!array.data) return;
  on_device ? check_shape(array, name, columns, types) : check_array(array, name, columns, types);
}

void write_first(const PairRows& list, const sp_array& to) {
  const auto write = [&]<typename Element>(Element) {
    list.for_pairs([&](int64_t row, int64_t k) { element<Element>(to, k) = Element(row); });
  };
  to.type == SP_I32 ? write(int32_t()) : write(int64_t());
}

}  // namespace

void check_columns(const sp_pairs& pairs, bool on_device) {
  if (pairs.size != sizeof(sp_pairs))
    refuse(fmt::format("pairs.size is {}, but sizeof(sp_pairs) is {}: the program was compiled with another header",
                       pairs.size, sizeof(sp_pairs)));
  check_column(pairs.first, "first", 1, {SP_I32, SP_I64}, on_device);
  check_column(pairs.second, "second", 1, {SP_I32, SP_I64}, on_device);
  check_column(pairs.shifts, "shifts", 3, {SP_I32, SP_I64}, on_device);
  check_column(pairs.vectors, "vectors", 3, {SP_F64}, on_device);
  check_column(pairs.distances, "distances", 1, {SP_F64}, on_device);
  check_column(pairs.offsets, "offsets", 1, {SP_I64}, on_device);
  if (pairs.found.data && !on_device) refuse("found is given: it is for positions in CUDA's memory");
  check_column(pairs.found, "found", 1, {SP_I64}, on_device);
  if (pairs.found.data && pairs.found.rows < 1) refuse("found has no row: it needs one");
}

void check_room(const sp_pairs& pairs, int64_t firsts, std::string& message) {
  const std::pair<const char*, const sp_array*> columns[] = {{"first", &pairs.first},
                                                             {"second", &pairs.second},
                                                             {"shifts", &pairs.shifts},
                                                             {"vectors", &pairs.vectors},
                                                             {"distances", &pairs.distances}};
  for (const auto& [name, array] : columns)
    if (array->data && array->rows < pairs.count)
      message = fmt::format("{} has {} rows, but the list has {} pairs", name, array->rows, pairs.count);
  if (pairs.offsets.data && pairs.offsets.rows < firsts + 1)
    message = fmt::format("offsets has {} rows, but needs {}", pairs.offsets.rows, firsts + 1);
}

void write_list(const ListProblem& problem, const PairRows& list, const sp_pairs& to) {
  if (to.first.data) write_first(list, to.first);
  if (to.second.data)
    write_array(to.second, list.count(), 1, [&](int64_t k, int64_t) { return list.second[size_t(k)]; });
  if (to.shifts.data)
    write_array(to.shifts, list.count(), 3, [&](int64_t k, int64_t axis) { return list.shift(k)[size_t(axis)]; });
  if (to.offsets.data)
    write_array(to.offsets, list.rows() + 1, 1, [&](int64_t row, int64_t) { return list.offsets[size_t(row)]; });
  if (!to.vectors.data && !to.distances.data) return;
  const PointSystems systems(problem.firsts());
  list.for_pairs([&](int64_t row, int64_t k) {
    const ListedPair pair = {uint32_t(row), list.second[size_t(k)], list.shift(k)};
    const Point3 way = displacement(problem, problem.boxes[systems[uint64_t(row)]], pair);
    if (to.vectors.data)
      for (int64_t axis = 0; axis < 3; ++axis) element<double>(to.vectors, k, axis) = way[size_t(axis)];
    if (to.distances.data) element<double>(to.distances, k) = length(way);
  });
}

}  // namespace spherepair
