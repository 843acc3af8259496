// SPDX-License-Identifier: MIT
// The backend of a GPU API: a device, and the components that launch its kernels.
#pragma once

#include "common/simulation/probe.h"
#include "common/simulation/rasterizer.h"

namespace spherepair {

class Simulation final : public Backend {
 public:
  explicit Simulation(std::unique_ptr<Device> device);

  const BackendInfo& info() const override { return device_->info(); }
  std::vector<Method> methods() const override { return device_methods(); }
  std::vector<DrawMethod> draw_methods() const override;

  void upload(const Scene& scene) override { begin(scene, nullptr); }
  void resume(const Scene& scene, const MotionState& saved) override { begin(scene, &saved); }
  void move() override;
  void set_event_driven(bool on) override { motion_.set_event_driven(on); }
  void evaluate_positions() override;
  void evaluate_state() override;
  State state() override;
  MotionState save() override;

  MethodChoice choice(const CollideOptions& options) const override;
  void collide(const CollideOptions& options) override;
  void enqueue_collide(const CollideOptions& options) override;
  Collisions collisions() override { return search_.totals(); }
  std::vector<uint> counts() override { return search_.counts(); }
  std::vector<Pair> pairs() override { return search_.pairs(); }

  void draw(const View& view, const DrawOptions& options) override;
  void enqueue_draw(const View& view, const DrawOptions& options) override;
  std::vector<uint> image() override { return rasterizer_.image(); }
  std::vector<uvec2> visible() override { return rasterizer_.visible(); }
  DrawStatistics draw_statistics() override { return rasterizer_.statistics(); }

  std::vector<uint> decide(std::span<const vec4> spheres) override { return probe_.decide(spheres); }
  void launch_empty(uint groups) override { probe_.launch_empty(groups); }
  void launch_peak_rate(PeakRate rate) override;
  void check_peak_rate(PeakRate rate) override;

  void finish() override { device_->wait(); }
  void check_guards() override { context_.buffers.check_guards(); }
  WorkCounts work_counts() const override { return device_->work; }
  std::vector<StageTime> compile_kernels() override { return device_->compile_kernels(); }
  void time_stages(bool on) override { device_->time_stages(on); }
  std::vector<StageTime> stage_times() override { return device_->stage_times(); }

  // For interop: positions and contact counts by sphere index stand in SLOT_POSITION and SLOT_COUNT.
  void prepare_to_share();
  Device& device() { return *device_; }
  uint64_t spheres() const { return context_.n; }

 private:
  void begin(const Scene& scene, const MotionState* saved);
  void require_scene(const char* what) const;
  void require_method(DrawMethod method) const;

  std::unique_ptr<Device> device_;
  DeviceContext context_;
  DeviceMotion motion_;
  CellSorter sorter_;
  PairSearch search_;
  Rasterizer rasterizer_;
  Probe probe_;
};

}  // namespace spherepair
