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

// The columns that kernels must write. Vectors and distances need first, second and shifts.
uint wanted_of(const sp_pairs& pairs) {
  const bool vectors = pairs.vectors.data || pairs.distances.data;
  return (pairs.first.data || vectors ? LIST_WANTS_FIRST : 0) | (pairs.second.data || vectors ? LIST_WANTS_SECOND : 0) |
         (pairs.shifts.data || vectors ? LIST_WANTS_SHIFTS : 0);
}

// The first array besides points that lies in CUDA's memory, so that a call copies it and waits; null: none.
const char* copied_array(const sp_problem& given) {
  const std::pair<const char*, const sp_array*> arrays[] = {{"boxes", &given.boxes},
                                                            {"periodic", &given.periodic},
                                                            {"offsets", &given.offsets},
                                                            {"query_offsets", &given.query_offsets},
                                                            {"exclusions", &given.exclusions}};
  for (const auto& [name, array] : arrays)
    if (array->data && is_cuda_array(*array)) return name;
  return nullptr;
}

// The rows of the shortest column.
int64_t room_of(const sp_pairs& pairs) {
  int64_t room = most_points;
  bool any = false;
  for (const sp_array* column : {&pairs.first, &pairs.second, &pairs.shifts, &pairs.vectors, &pairs.distances})
    if (column->data) any = true, room = std::min(room, column->rows);
  return any ? room : 0;
}

// Lets kernels write straight into a caller's column of contiguous int32, instead of a buffer of the list's own.
class BorrowedColumn {
 public:
  BorrowedColumn(Buffers& buffers, uint slot, DeviceArray& column, int64_t columns, int64_t rows)
      : buffers_(buffers), slot_(slot), own_(buffers.memory(slot)) {
    const bool contiguous = (columns == 1 || column.column_stride == 1) && column.row_stride == columns;
    taken_ = column.data && column.type == ElementType::int32 && contiguous;
    if (!taken_) return;
    // At least the 16 bytes of the smallest buffer, so that none is allocated in its place.
    const uint64_t bytes = std::max<uint64_t>(uint64_t(rows * columns) * sizeof(int32_t), 16);
    buffers_.share(slot, {uint64_t(uintptr_t(column.data)), bytes, nullptr});
    column = {};  // so that nothing is copied
  }
  ~BorrowedColumn() {
    if (taken_) buffers_.share(slot_, own_);
  }
  BorrowedColumn(const BorrowedColumn&) = delete;
  BorrowedColumn& operator=(const BorrowedColumn&) = delete;

 private:
  Buffers& buffers_;
  uint slot_;
  Memory own_;
  bool taken_ = false;
};

struct BorrowedColumns {
  BorrowedColumns(Buffers& buffers, DeviceColumns& columns, int64_t rows)
      : first(buffers, SLOT_LIST_FIRST, columns.first, 1, rows),
        second(buffers, SLOT_LIST_SECOND, columns.second, 1, rows),
        shifts(buffers, SLOT_LIST_SHIFT, columns.shifts, 3, rows) {}
  BorrowedColumn first, second, shifts;
};

}  // namespace

// While it lives, launches and copies go to the caller's stream.
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

// Counts the pairs and waits for the number. Throws ListError for points that cannot be listed.
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

DeviceColumns DeviceCalls::columns_of(const sp_pairs& pairs) const {
  return {.first = array_of(pairs.first, "first"),
          .second = array_of(pairs.second, "second"),
          .shifts = array_of(pairs.shifts, "shifts"),
          .vectors = array_of(pairs.vectors, "vectors"),
          .distances = array_of(pairs.distances, "distances"),
          .offsets = array_of(pairs.offsets, "offsets"),
          .found = array_of(pairs.found, "found")};
}

// Writes the rows that count() has found into the columns, at most `room` of them.
void DeviceCalls::write(const ListProblem& problem, const DeviceColumns& columns, int64_t room) {
  if (room > 0) lists_.fill();
  arrays_.write_columns(lists_.buffers().handles(), problem.firsts().size(), room, columns);
}

std::unique_ptr<OwnedPairs> DeviceCalls::list(const sp_problem& given, uint32_t wanted) {
  const InStream in_stream(*this, given);
  const ListProblem problem = read(given);
  lists_.begin(problem);
  const int64_t pairs = counted(given);
  auto owned =
      std::make_unique<OwnedPairs>(pairs, int64_t(problem.firsts().size()), wanted, device_, given.positions.device_id);
  DeviceColumns columns = columns_of(*owned);
  const BorrowedColumns borrowed(lists_.buffers(), columns, pairs);
  lists_.set_columns(wanted_of(*owned), pairs);
  write(problem, columns, pairs);
  return owned;
}

bool DeviceCalls::fill(const sp_problem& given, sp_pairs& pairs, std::string& message) {
  const InStream in_stream(*this, given);
  DeviceColumns columns = columns_of(pairs);
  if (arrays_.is_captured())
    if (const char* const name = copied_array(given))
      refuse(fmt::format("this call cannot be captured, since it copies {} to the host: give {} in the host's memory",
                         name, name));
  const ListProblem problem = read(given);
  const uint wanted = wanted_of(pairs);
  const int64_t room = room_of(pairs);
  const BorrowedColumns borrowed(lists_.buffers(), columns, room);
  if (arrays_.is_captured() && !(pairs.found.data && lists_.is_ready(problem, wanted, room)))
    refuse(
        "this call cannot be captured: give `found`, and call sp_fill once with the same problem before the capture");
  const bool known = lists_.begin(problem);
  const bool ready = lists_.set_columns(wanted, room) && known;
  pairs.count = -1;
  if (ready && pairs.found.data) {
    read_points(given);
    lists_.count();
  } else {
    pairs.count = counted(given);
  }
  const int64_t firsts = int64_t(problem.firsts().size());
  check_room(pairs, firsts, message);
  if (message.empty()) {
    write(problem, columns, room);
  } else if (pairs.found.data) {  // the number is written in any case
    DeviceColumns number;
    number.found = columns.found;
    write(problem, number, pairs.count > room ? room : 0);
  }
  return message.empty();
}

}  // namespace spherepair
