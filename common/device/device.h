// SPDX-License-Identifier: MIT
// What the components need of a GPU API: memory by slot, launches, waiting, timers. GlDevice and CudaDevice are it.
#pragma once

#include "common/backend/graphics_pipeline.h"
#include "common/device/launch.h"

namespace spherepair {

struct DeviceCapabilities {
  uint64_t largest_buffer = 0;   // bytes that a kernel can reach in one buffer
  bool atomics_64 = false;       // 64-bit atomic minimum on buffers
  bool float_atomics = false;    // atomic addition of float32 on buffers
  bool overlaps_images = false;  // the spheres of one image can be drawn while the last is still resolved
  uint bounds_block = 0;         // group size of grid_bounds
  uint tensor_groups = 0;        // groups of collide_tensor that run at once; 0: the device has no such kernel
  uint persistent_groups = 0;    // groups of persistent_steps that run at once; 0: the device has no such kernel
};

// A library's sorts with our kernels (CUDA: Thrust).
class DeviceLibrary {
 public:
  virtual ~DeviceLibrary() = default;
  virtual void sort_spheres(const Params& params) = 0;  // SLOT_POSITION into cell order: SLOT_CELL, SLOT_SORTED,
                                                        // SLOT_ID; counts 0
  virtual void sort_pairs(uint64_t count) = 0;          // SLOT_PAIR into canonical order
};

class Device {
 public:
  virtual ~Device() = default;
  virtual const BackendInfo& info() const = 0;
  virtual const DeviceCapabilities& capabilities() const = 0;

  // A buffer of so many bytes at a slot, in place of what was there. Throws BackendError with the bytes asked and free.
  virtual void allocate(uint slot, uint64_t bytes) = 0;
  virtual void write(uint slot, const void* data, uint64_t offset, uint64_t bytes) = 0;
  virtual void read(uint slot, void* data, uint64_t offset, uint64_t bytes) = 0;  // waits for the device
  virtual void clear(uint slot, uint64_t bytes) = 0;                              // to 0, by the API's own function
  virtual void swap(uint a, uint b) = 0;                                          // two buffers

  virtual void launch(const Launch& launch, const Params& params) = 0;
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
  virtual GraphicsPipeline* pipeline() { return nullptr; }  // its own, which draws SLOT_POSITION and SLOT_COUNT

  // The address of a buffer, until it is allocated again; null for an API without addresses.
  virtual const void* address(uint) { return nullptr; }

  Preparations prepared;  // counted by the device, its pipeline's apart

  WorkCounts work;  // launches are counted by the device, steps and sorts by the components
};

}  // namespace spherepair
