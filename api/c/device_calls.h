// SPDX-License-Identifier: MIT
// The library's calls for arrays in CUDA's memory.
#pragma once

#include "api/c/guarded.h"
#include "common/lists/device_lists.h"

namespace spherepair {

// Whether a problem's positions lie in CUDA's memory. Then its radii, its queries and all columns must lie there, too.
bool is_on_device(const sp_problem& given);

// Makes a context's calls for such problems, and keeps buffers from one call to the next.
class DeviceCalls {
 public:
  // Throws ListError for a backend whose callers cannot have arrays in its device's memory.
  explicit DeviceCalls(Backend& backend);

  int64_t count(const sp_problem& given);
  std::unique_ptr<OwnedPairs> list(const sp_problem& given, uint32_t wanted);
  // Waits for nothing if `found` is given and the last call had the same problem, apart from the numbers in positions,
  // radii and queries. Returns false, with the reason in the message, if a column is too short.
  bool fill(const sp_problem& given, sp_pairs& pairs, std::string& message);

 private:
  class InStream;

  ListProblem read(const sp_problem& given);
  void read_points(const sp_problem& given);
  int64_t counted(const sp_problem& given);
  DeviceColumns columns_of(const sp_pairs& pairs) const;
  void write(const ListProblem& problem, const DeviceColumns& columns, int64_t room);
  DeviceArray array_of(const sp_array& array, const char* name) const;

  Backend& backend_;
  DeviceArrays& arrays_;
  Device& device_;
  DeviceLists lists_;
};

}  // namespace spherepair
