// SPDX-License-Identifier: MIT
// What the driver of the current context offers.
#pragma once

#include "common/backend/backend.h"
#include "glsl/program.h"

namespace spherepair {

struct DeviceLimits {
  uint64_t largest_binding = 0;  // bytes of a storage block
  uint64_t largest_texture = 0;  // texels of a texture buffer
  Features features;
  bool sparse = false;  // buffers in sparse storage are to be had, and wanted
};

// Throws BackendError for a driver without what every kernel needs.
DeviceLimits device_limits(const OpenOptions& options);

// A buffer of so many bytes. Throws BackendError with the bytes asked and free.
unsigned new_buffer(uint64_t bytes, const DeviceLimits& limits);

// In words, with what to do.
std::string texture_too_long(uint64_t texels, const DeviceLimits& limits);

BackendInfo describe_device(bool software, const DeviceLimits& limits);

}  // namespace spherepair
