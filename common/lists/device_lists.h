// SPDX-License-Identifier: MIT
// Makes lists of pairs on a device: bins the points into cells, counts the rows of the list, then fills and sorts them.
// The list is the CPU's, see displacement.h. Only found() and list() wait for the device.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "common/device/context.h"
#include "common/lists/device_problem.h"
#include "common/lists/pair_rows.h"

namespace spherepair {

class DeviceLists {
 public:
  explicit DeviceLists(Device& device) : context_(device) {}

  // Lists a problem that has been checked. None: the reach spans more images than the kernels can number, or a buffer
  // would be larger than the device allows.
  std::optional<PairRows> list(const ListProblem& problem);

  // The steps of list(). begin() reads the offsets of a problem's sets, not their points: those go into points(), a
  // dvec4 each with the radius in w, queries last. fill() writes the wanted columns (LIST_WANTS_*) if `room` holds all
  // pairs. begin() and set_columns() return true if they sent and allocated nothing, since the device had it from the
  // last call. A column in whose slot the caller has put memory is written there.
  bool begin(const ListProblem& problem);
  bool set_columns(uint wanted, int64_t room);
  bool is_ready(const ListProblem& problem, uint wanted, int64_t room) const;  // whether both would return true
  Memory points() const { return context_.buffers.memory(SLOT_LIST_GIVEN); }
  void write_points(const ListProblem& problem);  // of the host
  uint64_t looking() const { return sent_.state.looking; }
  void count();
  struct Found {
    int64_t pairs = 0;
    std::optional<uint64_t> wrong, far;  // the first element with an invalid number, and the first that is too far away
    bool wide = false;                   // the reach spans too many images
  };
  Found found();  // waits
  void fill();
  [[noreturn]] void refuse(const Found& found);  // throws ListError

  Buffers& buffers() { return context_.buffers; }

 private:
  bool grow(std::span<const std::pair<uint, uint64_t>> slots);
  std::array<std::pair<uint, uint64_t>, 4> column_sizes(uint wanted, int64_t room) const;  // slots and bytes
  bool make_room();  // returns whether any buffer grew
  void keep_more(uint64_t keys);
  bool is_empty() const { return sent_.state.points == 0 || sent_.state.looking == 0; }

  void prepare_small_systems();
  void prepare_systems();
  uint row_block() const { return 1u << sent_.state.row_bits == LIST_ROWS ? LIST_BLOCK / 2 : LIST_BLOCK; }
  uint64_t row_groups() const { return ceil_div(looking(), 1u << sent_.state.row_bits); }
  void launch(Kernel kernel, uint block, uint64_t groups, const Variant& variant = {});
  PairRows read_list(uint64_t pairs);

  DeviceContext context_;
  DeviceProblem sent_;         // by begin() and set_columns()
  bool long_rows_ = false;     // as set_columns() was told
  bool counts_again_ = false;  // fill() does: the keys of the last count() are lost
};

}  // namespace spherepair
