// SPDX-License-Identifier: MIT
// Moves the spheres on a device: positions, velocities and the method's own state.
#pragma once

#include "common/device/context.h"

namespace spherepair {

class DeviceMotion {
 public:
  explicit DeviceMotion(DeviceContext& context) : context_(context) {}

  // Fills the buffers and the scene's part of the parameters. saved: continue from this state.
  void upload(const Scene& scene, const MotionState* saved);

  void set_event_driven(bool on) { event_driven_ = on; }
  MotionOptions options() const { return motion_; }

  void require_movable() const;  // throws std::invalid_argument for a scene that cannot be moved
  void begin_step();             // checks likewise, before each step

  // Makes one step of a method without contacts. If `clear_results` and the method's kernel visits all spheres, it also
  // clears the counts and totals of the last search and returns true.
  bool step(bool clear_results);

  // Leaves the next steps to the search's kernel. Throws std::invalid_argument unless the motion is `paper` in float32.
  void leave_steps_to_search();

  // For `anchored`, computes the positions of this step, clears the results and returns true if they were not yet
  // computed. Other methods always have their positions.
  bool evaluate_positions();
  void evaluate_state();  // positions, velocities and the wide state

  bool moved() const { return moved_; }            // since the scene's start; true after a resume
  bool state_current() const { return current_; }  // state() may be called
  Motion::State state();
  MotionState save();

 private:
  void write_state(const MotionState& state);
  std::vector<uint> read_wide();
  void launch(Kernel kernel, bool whole_state, bool clear_results);

  DeviceContext& context_;
  MotionOptions motion_;
  std::string unmovable_;  // why the scene cannot be moved, or empty
  uint steps_ = 0;         // of `anchored`
  bool evaluated_ = true;  // positions are the current ones ...
  bool current_ = true;    // ... and so is all else that state() reads
  bool event_driven_ = true;
  bool moved_ = false;
};

}  // namespace spherepair
