// SPDX-License-Identifier: MIT
// The backend of a GPU API: a device and the components that launch its kernels.
#pragma once

#include "common/backend/backend.h"
#include "common/simulation/contacts.h"
#include "common/simulation/probe.h"
#include "common/simulation/rasterizer.h"
#include "common/simulation/swept_search.h"

namespace spherepair {

class Simulation final : public Backend,
                         public Drawing,
                         public DevicePositions,
                         public PersistentSteps,
                         public PeakRateKernels {
 public:
  // open: opens OpenGL's pipeline, for a device without its own; none: only DrawMethod::compute draws.
  explicit Simulation(std::unique_ptr<Device> device, PipelineOpener open = {});

  const BackendInfo& info() const override { return device_->info(); }
  Device* device() override { return device_.get(); }
  void enter_thread() override { device_->enter_thread(); }
  void leave_thread() noexcept override { device_->leave_thread(); }
  Drawing* drawing() override { return this; }
  DevicePositions* device_positions() override { return this; }
  PersistentSteps* persistent_steps() override { return device_->capabilities().persistent_groups ? this : nullptr; }
  PeakRateKernels* peak_rates() override { return this; }
  std::vector<Method> methods() const override;

  void upload(const Scene& scene) override { begin(scene, nullptr); }
  void resume(const Scene& scene, const MotionState& saved) override { begin(scene, &saved); }
  void move() override;
  void set_event_driven(bool on) override { motion_.set_event_driven(on); }
  void keep_near_pairs(bool on) override { contacts_.keep_list(on); }
  void evaluate_positions() override;
  void evaluate_state() override;
  State state() override;
  MotionState save() override;
  const Memory& positions() override;
  void positions_changed() override;

  MethodChoice choice(const CollideOptions& options) const override;
  void collide(const CollideOptions& options) override;
  void enqueue_collide(const CollideOptions& options) override;
  void step(const CollideOptions& options) override;
  void enqueue_step(const CollideOptions& options) override;
  void run_steps(uint steps) override;
  void enqueue_steps(uint steps) override;
  Collisions collisions() override { return search_.totals(); }
  std::vector<uint> counts() override { return search_.counts(); }
  std::vector<Pair> pairs() override { return search_.pairs(); }

  void draw(const View& view, const DrawOptions& options) override;
  void enqueue_draw(const View& view, const DrawOptions& options) override;
  std::vector<DrawMethod> draw_methods() const override;
  std::vector<Transfer> transfers() const override;
  std::optional<Transfer> transfer_taken() const override;
  void transfer(Transfer way) override;
  std::vector<uint> image() override { return rasterizer_.image(); }
  std::vector<float> depths() override { return rasterizer_.depths(); }
  void set_classes(std::span<const uint> classes) override;
  std::vector<uvec2> visible() override { return rasterizer_.visible(); }
  bool show(uint texture) override;
  DrawStatistics draw_statistics() override { return rasterizer_.statistics(); }

  std::vector<uint> decide(std::span<const vec4> spheres) override { return probe_.decide(spheres); }
  void launch_empty(uint groups) override { probe_.launch_empty(groups); }
  void enqueue_empty_step(uint launches, const ApiOptions& api) override { probe_.enqueue_empty_step(launches, api); }
  void launch(PeakRate rate) override;
  void check(PeakRate rate) override;

  void finish() override;
  void check_guards() override { context_.buffers.check_guards(), contacts_.check_guards(), swept_.check_guards(); }
  WorkCounts work_counts() const override { return device_->work; }
  Preparations preparations() const override;
  std::vector<StageTime> compile_kernels() override { return device_->compile_kernels(); }
  void time_stages(bool on) override { device_->time_stages(on); }
  std::vector<StageTime> stage_times() override { return device_->stage_times(); }

 private:
  void begin(const Scene& scene, const MotionState* saved);
  void evaluate();        // computes positions of this step that the motion has deferred
  void complete_moves();  // completes steps with contacts, see Contacts::complete
  bool has_pipeline() const { return device_->pipeline() || context_.other_pipeline; }
  void require_scene(const char* what) const;
  void require_method(const DrawOptions& options) const;

  std::unique_ptr<Device> device_;
  DeviceContext context_;
  DeviceMotion motion_;
  CellSorter sorter_;
  PairSearch search_;
  Contacts contacts_;
  SweptSearch swept_;
  Rasterizer rasterizer_;
  Probe probe_;
};

}  // namespace spherepair
