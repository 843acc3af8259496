// SPDX-License-Identifier: MIT
// The naive float32 predicate and step, compiled twice: as written, and with multiplications and additions fused.
#pragma once

#include "common/shared/portable.h"

namespace spherepair {

struct Naive {
  bool (*collide)(vec4 a, vec4 b);
  float (*advance)(float position, float velocity, float dt);
};
extern const Naive naive_plain, naive_contracted;

// Whether this CPU can run naive_contracted.
inline bool can_contract() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("fma");
#else
  return true;
#endif
}

}  // namespace spherepair
