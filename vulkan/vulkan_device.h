// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "common/device/device.h"

namespace spherepair {

// Opens the Vulkan device that options.vulkan_device names, else the first. Throws BackendError without a loader, a
// driver or a device that kernels can run on, or in software if hardware is required.
std::unique_ptr<Device> open_vulkan_device(const OpenOptions& options);

// A buffer of a Vulkan device that another API can import. Must not outlive the device.
class ExportedMemory {
 public:
  virtual ~ExportedMemory() = default;
  virtual uint64_t bytes() const = 0;  // of the allocation; the buffer lies at its start
  virtual int descriptor() const = 0;  // a new file descriptor, which the importer closes
  // Copy a buffer of the device into it, or all of it into such a buffer, and wait.
  virtual void copy(uint64_t buffer) = 0;
  virtual void copy_back(uint64_t buffer) = 0;
};

// For devices from open_vulkan_device.
bool exports_memory(const Device& vulkan);
std::unique_ptr<ExportedMemory> export_memory(Device& vulkan, uint64_t bytes);

}  // namespace spherepair
