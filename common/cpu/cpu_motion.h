// SPDX-License-Identifier: MIT
// The CPU's spheres and their motion.
#pragma once

#include "common/cpu/cpu_contacts.h"
#include "common/shared/anchor.h"

namespace spherepair {

template <typename Real>
Anchor<Real> anchor_of(const MotionState& kept, const vec4& velocity, uint64_t i) {
  const uint64_t n = kept.anchors.size();
  return {kept.anchors[i],
          snap(velocity.x),
          snap(velocity.z),
          load_real<Real>(kept.flights, i),
          load_real<Real>(kept.flights, n + i),
          kept.since[i]};
}

class CpuMotion {
 public:
  CpuMotion(const BackendInfo& info, int threads) : contacts_(info, threads) {}

  void upload(const Scene& scene);
  MotionOptions options() const { return motion_; }
  void move(int threads);
  void require_movable() const;
  void require_sound() const { contacts_.require_sound(); }
  void set_event_driven(bool on) { event_driven_ = on; }
  bool periodic() const { return contacts_.periodic(); }
  const std::vector<Pair>& near_pairs() { return contacts_.near_pairs(kept_.wide, positions_); }
  void keep_near_pairs(bool on) { contacts_.keep_list(on); }
  uint64_t contact_searches() const { return contacts_.searches(); }

  // Returns the current positions; for `anchored` this call evaluates them.
  const std::vector<vec4>& positions(int threads);
  void evaluate_state(int threads);
  const std::vector<vec4>& velocities() const { return velocities_; }  // as last evaluated
  Motion::State state() const;  // throws BackendError if not evaluated since the last move

  MotionState save(int threads);
  // Restores a saved state. Call it after the upload of the same scene.
  void resume(const Scene& scene, const MotionState& saved);

 private:
  template <typename Real>
  Moving<Real> load(uint64_t i) const;
  template <typename Real>
  void store(uint64_t i, const Moving<Real>& sphere, bool whole);
  template <typename Real>
  Anchor<Real> load_anchor(uint64_t i) const {
    return anchor_of<Real>(kept_, velocities_[i], i);
  }
  template <typename Real>
  void step_all(int threads);
  template <typename Real>
  void bounce_all(int threads);
  void evaluate(int threads, bool whole);

  MotionOptions motion_;
  std::string unmovable_;  // why the scene cannot be moved
  MotionParams params_{};
  CpuContacts contacts_;
  std::vector<vec4> positions_, velocities_;
  MotionState kept_;
  bool evaluated_ = true;      // positions are the current ones ...
  bool state_current_ = true;  // ... and so is all else that state() reads
  bool event_driven_ = true;
};

}  // namespace spherepair
