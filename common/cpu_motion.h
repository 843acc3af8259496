// SPDX-License-Identifier: MIT
// The CPU's spheres and how they move.
#pragma once

#include "anchor.h"
#include "backend.h"

namespace spherepair {

class CpuMotion {
 public:
  void upload(const Scene& scene);
  MotionOptions options() const { return motion_; }
  void move(int threads);
  void look_at_due_only(bool on) { due_only_ = on; }

  // As they stand now; of `anchored` they are evaluated when they are asked for.
  const std::vector<vec4>& positions(int threads);
  Backend::State state(int threads);

  MotionState save(int threads);
  void resume(const MotionState& saved) { kept_ = saved, placed_ = motion_.method != MotionMethod::anchored; }

 private:
  template <typename Real>
  Moving<Real> load(uint64_t i) const;
  template <typename Real>
  void store(uint64_t i, const Moving<Real>& sphere, bool whole);
  template <typename Real>
  Anchor<Real> load_anchor(uint64_t i) const;
  template <typename Real>
  void step_all(int threads);
  template <typename Real>
  void bounce_all(int threads);
  void place(int threads, bool whole);

  MotionOptions motion_;
  Params params_{};
  std::vector<vec4> positions_, velocities_;
  MotionState kept_;
  bool placed_ = true;  // positions are those of this step
  bool due_only_ = true;
};

// Throws std::invalid_argument when swept contacts are asked for of a method or state that has none.
void check_swept(const std::string& backend, const CollideOptions& options, MotionOptions motion);

// Throws BackendError when `anchored` has done so many steps that their count would be lost.
void check_steps(const std::string& backend, uint steps);

}  // namespace spherepair
