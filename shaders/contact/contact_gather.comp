#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: sums the impulses of its near spheres in a step, in float32 and in the order of its row.
// Replaces contact_pairs for sums in order: each pair is evaluated from both sides, without atomics.
#include "shaders/contact/contact_state.glsl"

layout(local_size_x = BLOCK) in;
layout(std430, binding = SLOT_ROW) restrict buffer RowBuffer { uint row[]; };
layout(std430, binding = SLOT_ROW_LENGTH) restrict buffer RowLengthBuffer { uint row_length[]; };

void put_impulse(uint i, Push sum) {
  if (sum.x != 0l) put_in_impulse(0u, i, sum.x);
  if (sum.y != 0l) put_in_impulse(1u, i, sum.y);
  if (sum.z != 0l) put_in_impulse(2u, i, sum.z);
}

void main() {
  bool stopped = fault[LEFT_SKIN] != 0xFFFFFFFFu;
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i == 0u) fault[STOPPED] = stopped ? 1u : 0u;
  if (i == 0u && !stopped) ++fault[STEPS_DONE];
  if (stopped || i >= p.n) return;
  FloatPush sum = FloatPush(0.0f, 0.0f, 0.0f, FAULTS);
  Body a = load_body(i);  // momenta come with positions
  uint length = row_length[i];
  for (uint k = 0u; k < length; ++k) {
    uint j = row[k * p.n + i];
    if (is_apart(position[i], position[j])) continue;
    Body b = load_place(j);
    if (!in_contact(gap_between(a, b, p.contact))) continue;
    if (p.contact.damping != 0.0f) b = load_body(j);
    sum = sum_of_pushes(sum, float_push_of_pair(a, b, p.contact));
  }
  record_fault(sum.fault, i);
  put_impulse(i, rounded_push(sum));
}
