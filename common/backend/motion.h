// SPDX-License-Identifier: MIT
// Moves a scene's spheres.
#pragma once

#include "common/backend/scene_holder.h"
#include "common/scene/motion_state.h"

namespace spherepair {

class Motion : public virtual SceneHolder {
 public:
  // Enqueues one step. Throws std::invalid_argument for a scene that cannot be moved.
  virtual void move() = 0;
  // Steps skip work that cannot change a bit of the state. With `false` every step does that work:
  // set_event_driven(false) tests all spheres (anchored), keep_near_pairs(false) lists the near pairs anew (contacts).
  virtual void set_event_driven(bool on) = 0;
  virtual void keep_near_pairs(bool on) = 0;

  // Computes what `anchored` keeps in another form; other methods always have it. Searching and drawing evaluate the
  // positions themselves; state() needs evaluate_state().
  virtual void evaluate_positions() = 0;
  virtual void evaluate_state() = 0;

  // Positions and velocities rounded to float32, and for wider precisions the words of SLOT_WIDE. state() throws
  // BackendError if they have not been evaluated since the last move.
  struct State {
    std::vector<vec4> positions, velocities;
    std::vector<uint> wide;
  };
  virtual State state() = 0;

  // save() returns all that later steps depend on. resume() replaces upload() and continues from that state, on any
  // backend, with the same bits as an uninterrupted run. The scene must be the one that was uploaded, with the state's
  // positions and velocities.
  virtual MotionState save() = 0;
  virtual void resume(const Scene& scene, const MotionState& saved) = 0;
};

// Evaluates the state and returns it.
inline Motion::State current_state(Motion& motion) {
  motion.evaluate_state();
  return motion.state();
}

}  // namespace spherepair
