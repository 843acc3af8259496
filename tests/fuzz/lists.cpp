// SPDX-License-Identifier: MIT
// Arguments of the C calls: whatever they are, there is a list or a message, and what is written stays in its arrays.
#include <array>
#include <string>

#include "include/spherepair/spherepair.h"
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

namespace {

constexpr int64_t ROOM = 64;  // numbers of each array

// An array that lies within its memory, of any type and shape.
sp_array array_in(Values& values, std::array<double, ROOM>& memory) {
  sp_array array = {};
  if (values.next<uint8_t>() % 4 == 0) return array;
  for (double& number : memory) {
    const auto kind = values.next<uint8_t>();
    number = kind < 128 ? double(int8_t(kind)) / 8 : kind < 140 ? values.next<double>() : double(kind % 3);
  }
  const int64_t columns[] = {1, 2, 3, 9, 0, -1};
  array.columns = columns[values.next<uint8_t>() % 6];
  array.rows = values.next<uint8_t>() % (array.columns > 0 ? ROOM / array.columns : 7);
  array.row_stride = array.columns, array.column_stride = 1;
  array.type = values.next<uint8_t>() % 6;
  array.device_type = values.next<uint8_t>() % 16 ? 1 : 2;
  array.data = values.next<uint8_t>() % 16 ? memory.data() : nullptr;
  return array;
}

}  // namespace

FUZZ(lists) {
  static sp_context* const context = [] {
    sp_context* opened = nullptr;
    require(sp_open("cpu", nullptr, 1, &opened) == SP_OK, "the CPU opens");
    return opened;
  }();
  Values values(data, size);
  std::array<std::array<double, ROOM>, 9> memory;
  sp_problem problem = {};
  problem.size = sizeof problem;
  sp_array* const arrays[] = {&problem.positions,   &problem.radii,         &problem.boxes,
                              &problem.periodic,    &problem.offsets,       &problem.queries,
                              &problem.query_radii, &problem.query_offsets, &problem.exclusions};
  for (size_t k = 0; k < memory.size(); ++k) *arrays[k] = array_in(values, memory[k]);
  problem.cutoff = values.next<uint8_t>() % 8 ? values.next<uint8_t>() / 16.0 : 0;
  problem.skin = values.next<uint8_t>() % 8 ? 0 : values.next<double>();
  problem.half = values.next<uint8_t>() % 3, problem.inclusive = values.next<uint8_t>() % 2;
  problem.self_pairs = values.next<uint8_t>() % 2;
  int64_t count = -1;
  const sp_status counted = sp_count(context, &problem, &count);
  require((counted == SP_OK) == (*sp_message(context) == 0), "what fails says why");
  if (counted != SP_OK || count > 100'000) return;
  sp_pairs* list = nullptr;
  require(sp_list(context, &problem, SP_SHIFTS | SP_VECTORS | SP_DISTANCES | SP_OFFSETS, &list) == SP_OK,
          "what counts lists");
  require(list->count == count, "the list has as many");
  sp_free(list);
}
