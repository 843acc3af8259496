// SPDX-License-Identifier: MIT
#include "api/c/problem_of.h"

#include <fmt/format.h>

#include "api/c/arrays.h"

namespace spherepair {
namespace {

std::vector<uint64_t> offsets_from(const sp_array& array, const std::string& name, uint64_t points) {
  if (!is_given(array)) return {0, points};
  const std::vector<int64_t> offsets = read_integers(array, name, 1);
  if (offsets.empty())
    refuse(name +
           " is empty, but must have one entry more than there are systems: give 0 and the number of points for one "
           "system");
  if (offsets.front() != 0) refuse(fmt::format("{}[0] is {}, but must be 0", name, offsets.front()));
  for (size_t b = 1; b < offsets.size(); ++b)
    if (offsets[b] < offsets[b - 1])
      refuse(fmt::format("{}[{}] is {}, below {} before it", name, b, offsets[b], offsets[b - 1]));
  if (uint64_t(offsets.back()) != points)
    refuse(fmt::format("{} ends with {}, but there are {} points", name, offsets.back(), points));
  return {offsets.begin(), offsets.end()};
}

PointSet set_of(const sp_array& points, const sp_array& radii, const sp_array& offsets, const std::string& prefix,
                bool on_device, std::vector<Point3> memory) {
  PointSet set;
  const std::string name = prefix.empty() ? "positions" : "queries";
  if (on_device) {
    check_shape(points, name, 3, {SP_F32, SP_F64});
    if (is_given(radii)) check_shape(radii, prefix + "radii", 1, {SP_F32, SP_F64});
  } else {
    set.points = read_points(points, name, std::move(memory));
    if (is_given(radii)) set.radii = read_numbers(radii, prefix + "radii", 1);
  }
  if (is_given(radii) && radii.rows != points.rows)
    refuse(fmt::format("{}radii has {} rows, but {} has {}", prefix, radii.rows, name, points.rows));
  set.offsets = offsets_from(offsets, prefix + "offsets", uint64_t(points.rows));
  return set;
}

std::vector<ListBox> boxes_of(const sp_problem& given, size_t systems) {
  std::vector<ListBox> boxes(1);
  if (is_given(given.boxes) != is_given(given.periodic)) refuse("boxes and periodic go together: give both or neither");
  if (is_given(given.boxes)) {
    const std::vector<double> rows = read_numbers(given.boxes, "boxes", 9);
    const std::vector<uint8_t> flags = read_flags(given.periodic, "periodic", 3);
    if (given.boxes.rows != given.periodic.rows)
      refuse(fmt::format("boxes has {} rows, but periodic has {}", given.boxes.rows, given.periodic.rows));
    boxes.resize(size_t(given.boxes.rows));
    for (size_t b = 0; b < boxes.size(); ++b)
      for (size_t k = 0; k < 3; ++k) {
        if (flags[3 * b + k] > 1)
          refuse(fmt::format("periodic[{}][{}] is {}, but must be 0 or 1", b, k, flags[3 * b + k]));
        boxes[b].periodic[k] = flags[3 * b + k] == 1;
        for (size_t axis = 0; axis < 3; ++axis) boxes[b].rows[k][axis] = rows[9 * b + 3 * k + axis];
      }
  }
  if (boxes.size() == 1) boxes.assign(systems, boxes[0]);
  if (boxes.size() != systems)
    refuse(fmt::format("boxes has {} rows, but there are {} systems", boxes.size(), systems));
  return boxes;
}

bool flag(int32_t value, const char* name) {
  if (value != 0 && value != 1) refuse(fmt::format("{} is {}, but must be 0 or 1", name, value));
  return value == 1;
}

std::vector<std::array<uint32_t, 2>> exclusions_of(const sp_array& array) {
  if (!is_given(array)) return {};
  const std::vector<int64_t> ids = read_integers(array, "exclusions", 2);
  std::vector<std::array<uint32_t, 2>> pairs(ids.size() / 2);
  for (size_t e = 0; e < ids.size(); ++e) {
    if (ids[e] < 0 || ids[e] > 0x7FFFFFFF) refuse(fmt::format("exclusions[{}] has the index {}", e / 2, ids[e]));
    pairs[e / 2][e % 2] = uint32_t(ids[e]);
  }
  return pairs;
}

}  // namespace

ListProblem problem_of(const sp_problem& caller, const ReadDevice& read, ListProblem last) {
  if (caller.size != sizeof(sp_problem))
    refuse(fmt::format("problem.size is {}, but sizeof(sp_problem) is {}: the program was compiled with another header",
                       caller.size, sizeof(sp_problem)));
  sp_problem given = caller;
  std::vector<std::byte> kept[5];
  if (read)
    for (size_t k = 0;
         sp_array * array : {&given.boxes, &given.periodic, &given.offsets, &given.query_offsets, &given.exclusions})
      *array = on_host(*array, read, kept[k++]);
  const bool on_device = bool(read);
  ListProblem problem;
  problem.set = set_of(given.positions, given.radii, given.offsets, "", on_device, std::move(last.set.points));
  problem.asks = is_given(given.queries) || given.queries.columns != 0;
  problem.half = flag(given.half, "half");
  problem.inclusive = flag(given.inclusive, "inclusive");
  problem.self_pairs = flag(given.self_pairs, "self_pairs");
  if (problem.asks) {
    problem.queries = set_of(given.queries, given.query_radii, given.query_offsets, "query_", on_device,
                             std::move(last.queries.points));
    if (problem.half || problem.self_pairs) refuse("half and self_pairs must be 0 where there are queries");
    if (is_given(given.radii) != is_given(given.query_radii))
      refuse("radii and query_radii go together: give both or neither");
    if (problem.queries.offsets.size() != problem.set.offsets.size())
      refuse(fmt::format("query_offsets is of {} systems, but offsets of {}", problem.queries.offsets.size() - 1,
                         problem.set.offsets.size() - 1));
  } else if (is_given(given.query_radii) || is_given(given.query_offsets)) {
    refuse("query_radii and query_offsets need queries");
  }
  if (on_device && is_given(given.radii) && given.cutoff != 0)
    refuse("there are radii and a cutoff: give one of them (and a skin)");
  problem.cutoff = given.cutoff;
  problem.skin = given.skin;
  problem.boxes = boxes_of(given, problem.set.offsets.size() - 1);
  problem.exclusions = exclusions_of(given.exclusions);
  return problem;
}

}  // namespace spherepair
