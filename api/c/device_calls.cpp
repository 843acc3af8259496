// SPDX-License-Identifier: MIT
#include "api/c/device_calls.h"

#include <fmt/format.h>

#include "api/c/columns.h"
#include "api/c/problem_of.h"

namespace spherepair {
namespace {

DeviceArrays& arrays_of(Backend& backend) {
  Device* const device = backend.device();
  if (DeviceArrays* const arrays = device ? device->arrays() : nullptr) return *arrays;
  refuse(
      fmt::format("positions lies in CUDA's memory, but the context is of {}: open a context of cuda, or copy the "
                  "array to the host",
                  backend.info().name));
}

// The columns that kernels write for what a caller wants of each pair.
uint wanted_of(const sp_pairs& pairs) {
  const bool vectors = pairs.vectors.data || pairs.distances.data;
  return (pairs.first.data || vectors ? LIST_WANTS_FIRST : 0) | (pairs.second.data || vectors ? LIST_WANTS_SECOND : 0) |
         (pairs.shifts.data || vectors ? LIST_WANTS_SHIFTS : 0);
}

// The rows of the shortest column.
int64_t room_of(const sp_pairs& pairs) {
  int64_t room = most_points;
  bool any = false;
  for (const sp_array* column : {&pairs.first, &pairs.second, &pairs.shifts, &pairs.vectors, &pairs.distances})
    if (column->data) any = true, room = std::min(room, column->rows);
  return any ? room : 0;
}

// A buffer of the kernels that is the caller's column for a while.
class BorrowedColumn {
 public:
  BorrowedColumn(DeviceLists& lists, uint slot, const sp_array& column, sp_type type, int64_t columns)
      : lists_(lists), slot_(slot), own_(lists.buffers().memory(slot)) {
    const int64_t size = type == SP_I64 ? 8 : 4;
    taken_ = column.data && column.type == type && (columns == 1 || column.column_stride == 1) &&
             column.row_stride == columns;
    if (taken_)
      lists_.buffers().share(slot, {uint64_t(uintptr_t(column.data)), uint64_t(column.rows * columns * size), nullptr});
  }
  ~BorrowedColumn() { give_back(); }
  BorrowedColumn(const BorrowedColumn&) = delete;
  BorrowedColumn& operator=(const BorrowedColumn&) = delete;

  bool taken() const { return taken_; }

 private:
  void give_back() {
    if (taken_) lists_.buffers().share(slot_, own_);
  }

  DeviceLists& lists_;
  uint slot_;
  Memory own_;
  bool taken_;
};

}  // namespace

// The calls' launches and copies go to the caller's stream.
class DeviceCalls::InStream {
 public:
  InStream(DeviceCalls& calls, const sp_problem& given) : in_thread_(calls.backend_), arrays_(calls.arrays_) {
    arrays_.begin(given.stream);
  }
  ~InStream() { arrays_.end(); }
  InStream(const InStream&) = delete;
  InStream& operator=(const InStream&) = delete;

 private:
  InThread in_thread_;
  DeviceArrays& arrays_;
};

bool is_on_device(const sp_problem& given) { return is_cuda_array(given.positions); }

DeviceCalls::DeviceCalls(Backend& backend)
    : backend_(backend), arrays_(arrays_of(backend)), device_(*backend.device()), lists_(device_) {}

DeviceArray DeviceCalls::array_of(const sp_array& array, const char* name) const {
  if (!array.data) return {};
  if (!is_cuda_array(array))
    refuse(fmt::format("{} lies in the host's memory, but positions in CUDA's: both must lie in one", name));
  if (array.rows > 0 && !arrays_.has(array.data, array.device_id))
    refuse(fmt::format("{} is not memory of the context's device, {}, or device_id, {}, is another's", name,
                       backend_.info().device, array.device_id));
  constexpr ElementType types[] = {ElementType::float32, ElementType::float64, ElementType::int32, ElementType::int64};
  return {array.data, types[array.type], array.row_stride, array.column_stride};
}

ListProblem DeviceCalls::read(const sp_problem& given) {
  ListProblem problem =
      problem_of(given, [&](const void* from, void* to, uint64_t bytes) { arrays_.read(from, to, bytes); });
  check_problem(problem);
  return problem;
}

void DeviceCalls::read_points(const sp_problem& given) {
  arrays_.read_points(array_of(given.positions, "positions"), array_of(given.radii, "radii"), lists_.points(), 0,
                      uint64_t(given.positions.rows));
  if (given.queries.rows > 0)
    arrays_.read_points(array_of(given.queries, "queries"), array_of(given.query_radii, "query_radii"), lists_.points(),
                        uint64_t(given.positions.rows), uint64_t(given.queries.rows));
}

// Waits. Throws ListError for points that cannot be listed.
int64_t DeviceCalls::counted(const sp_problem& given) {
  read_points(given);
  lists_.count();
  const DeviceLists::Found found = lists_.found();
  if (found.wrong || found.far || found.wide) lists_.refuse(found);
  return found.pairs;
}

int64_t DeviceCalls::count(const sp_problem& given) {
  const InStream in_stream(*this, given);
  const ListProblem problem = read(given);
  lists_.begin(problem);
  return counted(given);
}

// Fills the rows that count() has found, and the columns from them.
void DeviceCalls::write(const ListProblem& problem, const sp_pairs& pairs, int64_t room) {
  const BorrowedColumn first(lists_, SLOT_LIST_FIRST, pairs.first, SP_I32, 1),
      second(lists_, SLOT_LIST_SECOND, pairs.second, SP_I32, 1),
      shifts(lists_, SLOT_LIST_SHIFT, pairs.shifts, SP_I32, 3);
  if (room > 0) lists_.fill();
  DeviceColumns columns;
  columns.vectors = array_of(pairs.vectors, "vectors");
  columns.distances = array_of(pairs.distances, "distances");
  columns.offsets = array_of(pairs.offsets, "offsets");
  columns.found = array_of(pairs.found, "found");
  if (!first.taken()) columns.first = array_of(pairs.first, "first");
  if (!second.taken()) columns.second = array_of(pairs.second, "second");
  if (!shifts.taken()) columns.shifts = array_of(pairs.shifts, "shifts");
  arrays_.write_columns(lists_.buffers().handles(), problem.firsts().size(), room, columns);
}

std::unique_ptr<OwnedPairs> DeviceCalls::list(const sp_problem& given, uint32_t wanted) {
  const InStream in_stream(*this, given);
  const ListProblem problem = read(given);
  lists_.begin(problem);
  const int64_t pairs = counted(given);
  auto owned =
      std::make_unique<OwnedPairs>(pairs, int64_t(problem.firsts().size()), wanted, device_, given.positions.device_id);
  lists_.set_columns(wanted_of(*owned), pairs);
  write(problem, *owned, pairs);
  return owned;
}

bool DeviceCalls::fill(const sp_problem& given, sp_pairs& pairs, std::string& message) {
  for (const sp_array* column :
       {&pairs.first, &pairs.second, &pairs.shifts, &pairs.vectors, &pairs.distances, &pairs.offsets, &pairs.found})
    array_of(*column, "a column");
  const InStream in_stream(*this, given);
  const ListProblem problem = read(given);
  const uint wanted = wanted_of(pairs);
  const int64_t room = room_of(pairs);
  if (arrays_.is_captured() && !(pairs.found.data && lists_.is_ready(problem, wanted, room)))
    refuse(
        "this call cannot be captured: give `found`, and call sp_fill once with the same problem before the capture");
  const bool known = lists_.begin(problem);
  const bool ready = lists_.set_columns(wanted, room) && known;
  const bool waits = !pairs.found.data || !ready;
  pairs.count = -1;
  if (waits) {
    pairs.count = counted(given);
    check_room(pairs, int64_t(problem.firsts().size()), message);
    if (!message.empty()) return false;
  } else {
    read_points(given);
    lists_.count();
  }
  write(problem, pairs, room);
  return true;
}

}  // namespace spherepair
