// SPDX-License-Identifier: MIT
// Lists of pairs made by a device: points are binned into cells of their wrapped coordinates, the rows of the list are
// counted, then filled and sorted. The same list as the CPU's, see displacement.h. Nothing here waits for the device
// but `found` and the reads of `list`.
#pragma once

#include <optional>
#include <span>

#include "common/device/context.h"
#include "common/lists/displacement.h"
#include "common/lists/lattice.h"
#include "common/shared/list.h"

namespace spherepair {

class DeviceLists {
 public:
  explicit DeviceLists(Device& device) : context_(device) {}

  // The list of a problem that has been checked; none where the reach spans more images than a device's list can hold.
  std::optional<std::vector<ListedPair>> list(const ListProblem& problem);

  // The steps of it. Of a problem's sets the offsets count; their points are in `points`, dvec4 each with the radius in
  // w, points before queries. The columns that are wanted, LIST_WANTS_*, are written where they have room for all
  // pairs. Both give whether the device knew all that and had enough memory: then nothing was sent or allocated.
  bool begin(const ListProblem& problem);
  bool set_columns(uint wanted, int64_t room);
  bool is_ready(const ListProblem& problem, uint wanted, int64_t room) const;  // whether neither would send anything
  Memory points() const { return context_.buffers.memory(SLOT_LIST_GIVEN); }
  void write_points(const ListProblem& problem);  // of the host
  uint64_t looking() const { return sent_.state.looking; }
  void count();
  struct Found {
    int64_t pairs = 0;
    std::optional<uint64_t> wrong, far;  // the first element whose numbers are not listed, or that is too far away
    bool wide = false;                   // the reach spans too many images
  };
  Found found();  // waits
  void fill();
  [[noreturn]] void refuse(const Found& found);  // throws ListError

  Buffers& buffers() { return context_.buffers; }

 private:
  // What the device is told of a problem.
  struct Sent {
    ListState state = {};
    std::vector<ListSystem> systems;
    std::vector<uvec2> exclusions;
  };
  static Sent told(const ListProblem& problem);
  bool knows(const Sent& told) const;
  bool grow(std::span<const std::pair<uint, uint64_t>> slots);
  bool make_room();

  void launch(Kernel kernel, uint block, uint64_t groups);
  std::vector<ListedPair> read_list(uint64_t pairs);

  DeviceContext context_;
  Sent sent_;
};

}  // namespace spherepair
