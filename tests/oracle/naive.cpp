// SPDX-License-Identifier: MIT
// Compiled with different flags, so nothing inline from a shared header may be called here: the linker keeps one copy.
#include "tests/oracle/naive.h"

namespace spherepair {
namespace {

bool collide(vec4 a, vec4 b) {
  const float dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z, r = a.w + b.w;
  return dx * dx + dy * dy + dz * dz < r * r;
}

float advance(float position, float velocity, float dt) { return position + velocity * dt; }

}  // namespace

extern const Naive NAIVE = {collide, advance};

}  // namespace spherepair
