// SPDX-License-Identifier: MIT
// A backend that passes every call on to another one; backends of tests override some calls.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/backend/backend.h"

namespace spherepair {

// Forwards every call to another backend, which draws.
class ForwardingBackend : public Backend, public Drawing {
 public:
  ForwardingBackend(const std::string& name, std::unique_ptr<Backend> real)
      : info_(real->info()), real_(std::move(real)), drawn_(drawing_of(*real_)) {
    info_.name = name;
    info_.on_host = name == "cpu";
    info_.software = !info_.on_host;
  }
  const BackendInfo& info() const override { return info_; }
  std::vector<Method> methods() const override { return real_->methods(); }
  Drawing* drawing() override { return this; }
  void upload(const Scene& scene) override { real_->upload(scene); }
  void move() override { real_->move(); }
  void set_event_driven(bool on) override { real_->set_event_driven(on); }
  void keep_near_pairs(bool on) override { real_->keep_near_pairs(on); }
  void evaluate_positions() override { real_->evaluate_positions(); }
  void evaluate_state() override { real_->evaluate_state(); }
  void collide(const CollideOptions& options) override { real_->collide(options); }
  void enqueue_collide(const CollideOptions& options) override { real_->enqueue_collide(options); }
  void finish() override { real_->finish(); }
  MethodChoice choice(const CollideOptions& options) const override { return real_->choice(options); }
  Collisions collisions() override { return real_->collisions(); }
  std::vector<uint> counts() override { return real_->counts(); }
  std::vector<Pair> pairs() override { return real_->pairs(); }
  State state() override { return real_->state(); }
  MotionState save() override { return real_->save(); }
  void resume(const Scene& scene, const MotionState& saved) override { real_->resume(scene, saved); }
  void draw(const View& view, const DrawOptions& options) override { drawn_.draw(view, options); }
  void enqueue_draw(const View& view, const DrawOptions& options) override { drawn_.enqueue_draw(view, options); }
  std::vector<DrawMethod> draw_methods() const override { return drawn_.draw_methods(); }
  std::vector<Transfer> transfers() const override { return {}; }
  std::optional<Transfer> transfer_taken() const override { return {}; }
  void transfer(Transfer way) override { drawn_.transfer(way); }
  std::vector<uint> image() override { return drawn_.image(); }
  std::vector<uvec2> visible() override { return drawn_.visible(); }
  std::vector<float> depths() override { return drawn_.depths(); }
  void set_classes(std::span<const uint> classes) override { drawn_.set_classes(classes); }
  bool show(uint texture) override { return drawn_.show(texture); }
  DrawStatistics draw_statistics() override { return drawn_.draw_statistics(); }
  std::vector<uint> decide(std::span<const vec4> spheres) override { return real_->decide(spheres); }
  void launch_empty(uint groups) override { real_->launch_empty(groups); }
  void enqueue_empty_step(uint launches, const ApiOptions& api) override { real_->enqueue_empty_step(launches, api); }
  void check_guards() override { real_->check_guards(); }
  WorkCounts work_counts() const override { return real_->work_counts(); }
  Preparations preparations() const override { return real_->preparations(); }
  void time_stages(bool on) override { real_->time_stages(on); }
  std::vector<StageTime> stage_times() override { return real_->stage_times(); }

 protected:
  Backend& forwarded() { return *real_; }
  BackendInfo info_;

 private:
  std::unique_ptr<Backend> real_;
  Drawing& drawn_;
};

}  // namespace spherepair
