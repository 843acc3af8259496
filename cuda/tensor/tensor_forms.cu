// SPDX-License-Identifier: MIT
// One thread per sphere writes its form. Threads past the last sphere fill its block of rows with forms that are near
// no other.
#include "common/shared/tensor_form.h"
#include "cuda/tensor/box.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;
static_assert(2 * TENSOR_BOUNDS_GROUPS == BLOCK && TENSOR_ROWS % BLOCK == 0);

__global__ void __launch_bounds__(BLOCK) tensor_forms(Params p, KernelBuffers buf) {
  uint lane = threadIdx.x;
  // CUDA only from here: the low corners that tensor_bounds wrote, then the high ones
  __shared__ vec4 boxes[BLOCK];
  boxes[lane] = reinterpret_cast<const vec4*>(buf.tile_sum)[lane];
  widen_first<TENSOR_BOUNDS_GROUPS>(boxes, boxes + TENSOR_BOUNDS_GROUPS);
  vec4 frame = tensor_frame(boxes[0], boxes[TENSOR_BOUNDS_GROUPS]);
  // until here
  uint i = group_index(p) * BLOCK + lane;
  if (i >= (p.n + TENSOR_ROWS - 1u) / TENSOR_ROWS * TENSOR_ROWS) return;
  TensorForm form = i < p.n ? tensor_form(buf.position[i], frame) : never_near_form();
  uvec4* forms = reinterpret_cast<uvec4*>(buf.sorted);
  // CUDA only from here: in the order of matrix B, the first eight halves of eight spheres, then the other eight
  uint at = i / 8u * 16u + i % 8u;
  forms[at] = form.low;
  forms[at + 8u] = form.high;
  // until here
}

Entry tensor_forms_kernel(uint, Variant) { return reinterpret_cast<Entry>(&tensor_forms); }

}  // namespace spherepair
