// SPDX-License-Identifier: MIT
// Lists of points in a device's memory, into columns in the same memory.
#pragma once

#include "api/c/guarded.h"
#include "common/lists/device_lists.h"

namespace spherepair {

// Whether a call is for arrays of a device: its positions are.
bool is_on_device(const sp_problem& given);

// What a context keeps for such calls.
class DeviceCalls {
 public:
  // Throws ListError for a backend whose callers have no memory of its device.
  explicit DeviceCalls(Backend& backend);

  int64_t count(const sp_problem& given);
  std::unique_ptr<OwnedPairs> list(const sp_problem& given, uint32_t wanted);
  // Waits for nothing where `found` is given and the call before had the same problem but for the numbers of points.
  // Gives false, with the reason in the message, where a column is too short.
  bool fill(const sp_problem& given, sp_pairs& pairs, std::string& message);

 private:
  class InStream;

  ListProblem read(const sp_problem& given);
  void read_points(const sp_problem& given);
  int64_t counted(const sp_problem& given);
  void write(const ListProblem& problem, const sp_pairs& pairs, int64_t room);
  DeviceArray array_of(const sp_array& array, const char* name) const;

  Backend& backend_;
  DeviceArrays& arrays_;
  Device& device_;
  DeviceLists lists_;
};

}  // namespace spherepair
