// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "common/device/device.h"

namespace spherepair {

// The Vulkan device that options.vulkan_device names, else the first. Throws BackendError: no loader, no driver, no
// device with what kernels need, software where hardware is required.
std::unique_ptr<Device> open_vulkan_device(const OpenOptions& options);

// A buffer of a Vulkan device that another API can import. Must not outlive the device.
class ExportedMemory {
 public:
  virtual ~ExportedMemory() = default;
  virtual uint64_t bytes() const = 0;      // of the allocation, at whose start the buffer lies
  virtual int descriptor() const = 0;      // a new file descriptor, which the importer closes
  virtual void copy(uint64_t buffer) = 0;  // fills it from a buffer of the device, and waits
};

// For devices from open_vulkan_device.
bool exports_memory(const Device& vulkan);
std::unique_ptr<ExportedMemory> export_memory(Device& vulkan, uint64_t bytes);

}  // namespace spherepair
