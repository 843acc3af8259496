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
  bool float_atomics = false;    // atomic addition of float32 on buffers
  bool overlaps_images = false;  // the spheres of one image can be drawn while the last is still resolved
  bool makes_lists = false;      // lists of pairs are made by kernels: in CUDA, see docs/NOTES/lists.md
  uint bounds_block = 0;         // group size of grid_bounds
  uint tensor_groups = 0;        // groups of collide_tensor that run at once; 0: the device has no such kernel
  uint tensor_block = 0;         // group size of that kernel
  uint persistent_groups = 0;    // groups of persistent_steps that run at once; 0: the device has no such kernel
};

// A library's sorts with our kernels (CUDA: Thrust).
class DeviceLibrary {
 public:
  virtual ~DeviceLibrary() = default;
  // SLOT_POSITION into cell order: SLOT_CELL, SLOT_SORTED, SLOT_ID; counts 0.
  virtual void sort_spheres(const Params& params, const BufferHandles& buffers) = 0;
  virtual void sort_pairs(const Memory& pairs, uint64_t count) = 0;  // into canonical order
};

class Device {
 public:
  virtual ~Device() = default;
  virtual const BackendInfo& info() const = 0;
  virtual const DeviceCapabilities& capabilities() const = 0;
  virtual void enter_thread() {}  // as of a backend
  virtual void leave_thread() noexcept {}

  // A buffer of so many bytes, after giving back the one that it replaces. Throws BackendError with the bytes asked and
  // free.
  virtual Memory allocate(uint64_t bytes, Memory replaced) = 0;
  virtual void write(const Memory& memory, const void* data, uint64_t offset, uint64_t bytes) = 0;
  virtual void read(const Memory& memory, void* data, uint64_t offset, uint64_t bytes) = 0;  // waits for the device
  virtual void clear(const Memory& memory, uint64_t bytes) = 0;  // to 0, by the API's own function

  virtual void launch(const Launch& launch, const Params& params, const BufferHandles& buffers) = 0;
  virtual void wait() = 0;

  // Around the launches of one collision step, which may go out together. `check` throws std::invalid_argument that
  // names the option which this API lacks.
  virtual void check(const CollideOptions& options) const = 0;
  virtual void begin_step(const ApiOptions& options) = 0;
  virtual void end_step() = 0;

  // Whether a kernel reads so many elements through a buffer texture. `wanted`: as the options ask for it; throws
  // BackendError when that is true and they do not fit.
  virtual bool reads_texture(Kernel, const Params&, uint64_t /*texels*/, std::optional<bool> /*wanted*/) const {
    return false;
  }

  virtual void time_stages(bool on) = 0;
  virtual std::vector<StageTime> stage_times() = 0;
  virtual std::vector<StageTime> compile_kernels() { return {}; }

  virtual DeviceLibrary* library() { return nullptr; }
  virtual DeviceArrays* arrays() { return nullptr; }        // callers' own, of an API that has such
  virtual GraphicsPipeline* pipeline() { return nullptr; }  // its own

  // Launches what is held back: another API is about to use a buffer.
  virtual void flush() {}

  Preparations prepared;  // counted by the device, its pipeline's apart

  WorkCounts work;  // launches are counted by the device, steps and sorts by the components
};

}  // namespace spherepair
