// SPDX-License-Identifier: MIT
// The GPU interface of the components: memory, launches, waiting, timers. Implemented by GlDevice, VulkanDevice and
// CudaDevice.
#pragma once

#include "common/backend/graphics_pipeline.h"
#include "common/device/device_arrays.h"
#include "common/device/launch.h"
#include "common/device/memory.h"

namespace spherepair {

struct DeviceCapabilities {
  uint64_t largest_buffer = 0;   // bytes that a kernel can reach in one buffer
  bool atomics_64 = false;       // 64-bit atomic minimum on buffers
  bool overlaps_images = false;  // can draw the spheres of one image while the previous one is still resolved
  bool makes_lists = false;      // kernels make lists of pairs: CUDA, and Vulkan on a GPU; see docs/NOTES/lists.md
  uint bounds_block = 0;         // group size of grid_bounds
  uint tensor_groups = 0;        // groups of collide_tensor that run at once; 0: no such kernel
  uint tensor_block = 0;         // group size of that kernel
  uint persistent_groups = 0;    // groups of persistent_steps that run at once; 0: no such kernel
};

// Sorts by a library (CUDA: Thrust), which can replace our kernels.
class DeviceLibrary {
 public:
  virtual ~DeviceLibrary() = default;
  // Sorts SLOT_POSITION into cell order: SLOT_CELL, SLOT_SORTED, SLOT_ID. Sets the counts to 0.
  virtual void sort_spheres(const Params& params, const BufferHandles& buffers) = 0;
  virtual void sort_pairs(const Memory& pairs, uint64_t count) = 0;  // into canonical order
};

class Device {
 public:
  virtual ~Device() = default;
  virtual const BackendInfo& info() const = 0;
  virtual const DeviceCapabilities& capabilities() const = 0;
  virtual void enter_thread() {}  // see Backend::enter_thread
  virtual void leave_thread() noexcept {}

  // Frees `replaced`, then returns a buffer of this many bytes. Throws BackendError with the bytes asked and free.
  virtual Memory allocate(uint64_t bytes, Memory replaced) = 0;
  virtual void write(const Memory& memory, const void* data, uint64_t offset, uint64_t bytes) = 0;
  virtual void read(const Memory& memory, void* data, uint64_t offset, uint64_t bytes) = 0;  // waits for the device
  // Host memory for reads and writes. CUDA's is pinned, so that copies run at the bus's rate.
  virtual std::shared_ptr<char[]> host_memory(uint64_t bytes) { return std::make_shared<char[]>(bytes); }
  virtual void clear(const Memory& memory, uint64_t bytes) = 0;  // sets to 0, by the API's own function

  virtual void launch(const Launch& launch, const Params& params, const BufferHandles& buffers) = 0;
  virtual void wait() = 0;

  // Bracket the launches of one collision step, which may be submitted together. check() throws std::invalid_argument,
  // which names an option that this API lacks.
  virtual void check(const CollideOptions& options) const = 0;
  virtual void begin_step(const ApiOptions& options) = 0;
  virtual void end_step() = 0;

  // Whether the kernel reads this many elements through a buffer texture. `wanted` is the option; throws BackendError
  // if it is true and they do not fit.
  virtual bool reads_texture(Kernel, const Params&, uint64_t /*texels*/, std::optional<bool> /*wanted*/) const {
    return false;
  }

  virtual void time_stages(bool on) = 0;
  virtual std::vector<StageTime> stage_times() = 0;
  virtual std::vector<StageTime> compile_kernels() { return {}; }

  virtual DeviceLibrary* library() { return nullptr; }
  virtual DeviceArrays* arrays() { return nullptr; }        // callers' arrays; null: not supported
  virtual GraphicsPipeline* pipeline() { return nullptr; }  // its own pipeline, or null

  // Submits the launches that are held back, before another API uses a buffer.
  virtual void flush() {}

  Preparations prepared;  // counts of the device, without its pipeline's

  WorkCounts work;  // the device counts launches, the components count steps and sorts
};

}  // namespace spherepair
