// SPDX-License-Identifier: MIT
// Makes one step of one sphere by any method but anchored (anchor.h), for every backend: the same bits on every
// machine. Callers pass a compile-time constant as `method`.
#ifndef SPHEREPAIR_MOTION_H
#define SPHEREPAIR_MOTION_H

#include "common/shared/impact.h"

ANY_REAL FN Moving OF_REAL take_step(uint method, Moving OF_REAL from, MotionParams m) {
  if (method == MOTION_EULER) return move_euler(from, m);
  if (method == MOTION_SYMPLECTIC) return move_symplectic(from, m);
  if (method == MOTION_PAPER_CLAMP) return move_clamped(from, m);
  if (method == MOTION_IMPACT_LINEAR) return move_impact_linear(from, m);
  if (method == MOTION_IMPACT) return move_impact(from, m);
  return move_paper(from, m);
}

#endif
