// SPDX-License-Identifier: MIT
// One thread per sphere: sums the impulses of its near spheres in a step, in float32 and in the order of its row.
// Replaces contact_pairs for sums in order: each pair is evaluated from both sides, without atomics.
#include "cuda/contact/contact_state.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__device__ inline void put_impulse(const KernelBuffers& buf, uint i, Push sum) {
  if (sum.x != 0l) put_in_impulse(buf, 0u, i, sum.x);
  if (sum.y != 0l) put_in_impulse(buf, 1u, i, sum.y);
  if (sum.z != 0l) put_in_impulse(buf, 2u, i, sum.z);
}

__global__ void __launch_bounds__(BLOCK) contact_gather(Params p, KernelBuffers buf) {
  bool stopped = buf.fault[LEFT_SKIN] != 0xFFFFFFFFu;
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (i == 0u) buf.fault[STOPPED] = stopped ? 1u : 0u;
  if (i == 0u && !stopped) ++buf.fault[STEPS_DONE];
  if (stopped || i >= p.n) return;
  FloatPush sum = FloatPush{0.0f, 0.0f, 0.0f, FAULTS};
  Body a = load_body(p, buf, i);  // momenta come with positions
  uint length = buf.row_length[i];
  for (uint k = 0u; k < length; ++k) {
    uint j = buf.row[k * p.n + i];
    if (is_apart(buf.position[i], buf.position[j])) continue;
    Body b = load_place(p, buf, j);
    if (!in_contact(gap_between(a, b, p.contact))) continue;
    if (p.contact.damping != 0.0f) b = load_body(p, buf, j);
    sum = sum_of_pushes(sum, float_push_of_pair(a, b, p.contact));
  }
  record_fault(buf, sum.fault, i);
  put_impulse(buf, i, rounded_push(sum));
}

Entry contact_gather_kernel(uint, Variant) { return reinterpret_cast<Entry>(&contact_gather); }

}  // namespace spherepair
