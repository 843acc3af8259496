// SPDX-License-Identifier: MIT
// State that the components of one simulation share: the device, their buffers, and the parameters of the current step.
#pragma once

#include "common/device/buffers.h"
#include "common/scene/scene_params.h"

namespace spherepair {

// Pairs i < j in any order. The memory belongs to the search that made the list, too.
struct PairList {
  Memory pairs;  // uvec2[count]
  uint count = 0;
};

struct DeviceContext {
  explicit DeviceContext(Device& device, PipelineOpener open = {})
      : device(device), buffers(device), other_pipeline(std::move(open)) {}

  Device& device;
  Buffers buffers;
  LazyPipeline other_pipeline;  // for an API without its own pipeline
  Params params{};              // each component sets its struct; sent to the device when it changes
  uint64_t n = 0;               // spheres
  uint64_t room = 0;            // spheres that buffers have room for, at least n
  bool equal_radii = true;
  uint near_pairs = 0;   // pairs in SLOT_NEAR
  uint64_t moves = 0;    // number of moves; results record it, and are current while it stays the same
  uint64_t version = 0;  // of the spheres and their contacts: grows with every move and search

  // Sets the number of spheres and their radii, from a scene or for a search beside it.
  void set_spheres(const Scene& scene) {
    n = room = scene.size();
    equal_radii = scene.equal_radii;
    buffers.set_spheres(n);
    params.n = uint(n);
    params.radius = common_radius(scene);
  }
  void set_near(const PairList& list) {
    buffers.share(SLOT_NEAR, list.pairs);
    near_pairs = list.count;
  }

  void moved() { ++moves, ++version; }

  const std::string& name() const { return device.info().name; }
  bool software() const { return device.info().software; }
  WorkCounts& work() { return device.work; }

  GraphicsPipeline& pipeline() { return device.pipeline() ? *device.pipeline() : other_pipeline.get(); }
  SphereArrays sphere_arrays(uint colours) const {
    device.flush();
    return {buffers.handles()[SLOT_POSITION], buffers.handles()[colours], n};
  }

  void launch(const Launch& launch) { this->launch(launch, params); }
  void launch(const Launch& launch, const Params& with) { device.launch(launch, with, buffers.handles()); }
};

// Groups for a thread a sphere, and at least one a word of the summary, which the same kernels clear.
inline std::array<uint, 3> groups_per_sphere(const DeviceContext& context) {
  return folded(ceil_div(std::max<uint64_t>(context.n, SUMMARY_SLOTS * SUMMARY_WORDS), SERVICE_BLOCK));
}

// Clears the contact counts in this order, and the totals.
inline void clear_results(DeviceContext& context, Order order) {
  const uint64_t threads = std::max<uint64_t>(context.n, SUMMARY_SLOTS * SUMMARY_WORDS);
  context.launch(
      {Kernel::clear, SERVICE_BLOCK, {}, folded(ceil_div(threads, SERVICE_BLOCK * SPHERES_PER_SORTER)), order});
}

}  // namespace spherepair
