// SPDX-License-Identifier: MIT
// The motion of the spheres on a device: positions, velocities and what the method keeps with them.
#pragma once

#include "common/device/context.h"

namespace spherepair {

class DeviceMotion {
 public:
  explicit DeviceMotion(DeviceContext& context) : context_(context) {}

  // Into the buffers, and the scene's part of the parameters; with `saved` as a run left it.
  void upload(const Scene& scene, const MotionState* saved);

  void set_event_driven(bool on) { event_driven_ = on; }
  MotionOptions options() const { return motion_; }

  void require_movable() const;  // throws std::invalid_argument for a scene that cannot be moved
  void begin_step();             // the same, before each step

  // One step of a method without contacts. Where `clear_results`, and the method has a kernel that goes through all
  // spheres, the counts and totals of the last search are cleared by it: true.
  bool step(bool clear_results);

  // The search's kernel takes the next steps, which it can of `paper` in float32: std::invalid_argument for others.
  void leave_steps_to_search();

  // Of `anchored`, which keeps anchors: the positions of this step, and the results cleared (true where anything was
  // done). Other methods have their positions always.
  bool evaluate_positions();
  void evaluate_state();  // positions, velocities and the wide state

  bool moved() const { return moved_; }            // since the upload of a scene at its start
  bool state_current() const { return current_; }  // state() has something to read
  Backend::State state();
  MotionState save();

 private:
  void write_state(const MotionState& state);
  std::vector<uint> read_wide();
  void launch(Kernel kernel, bool whole_state, bool clear_results);

  DeviceContext& context_;
  MotionOptions motion_;
  std::string unmovable_;  // why the scene cannot be moved
  uint steps_ = 0;         // of `anchored`
  bool evaluated_ = true;  // positions are those of this step ...
  bool current_ = true;    // ... and so is all that state() reads
  bool event_driven_ = true;
  bool moved_ = false;
};

}  // namespace spherepair
