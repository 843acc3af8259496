// SPDX-License-Identifier: MIT
// Limits and features of the current context's driver.
#pragma once

#include "common/backend/backend.h"
#include "glsl/driver_memory.h"
#include "glsl/program.h"

namespace spherepair {

struct DeviceLimits {
  uint64_t largest_binding = 0;  // bytes of a storage block
  uint64_t largest_texture = 0;  // texels of a texture buffer
  Features features;
  bool sparse = false;      // the driver has sparse storage
  bool large_pages = true;  // requested by the options
  bool vendor_free = false;
};

// Throws BackendError for a driver without what every kernel needs.
DeviceLimits device_limits(const OpenOptions& options);

// Allocates the buffers of a context. Large ones come from the driver's own memory if it can be imported, else from
// sparse storage.
class BufferMemory {
 public:
  explicit BufferMemory(const DeviceLimits& limits) : limits_(limits) {}

  // Throws BackendError with the bytes requested and free.
  BufferStorage allocate(uint64_t bytes);

 private:
  const DeviceLimits& limits_;
  bool opened_ = false;
  std::unique_ptr<DriverMemory> driver_;
};

// The error message, with the remedy.
std::string texture_too_long(uint64_t texels, const DeviceLimits& limits);

BackendInfo describe_device(bool software, const DeviceLimits& limits);

}  // namespace spherepair
