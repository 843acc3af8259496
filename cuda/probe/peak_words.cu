// SPDX-License-Identifier: MIT
// One thread per sphere copies 16 bytes a word at a time: measures what loads and stores of whole vectors save.
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) peak_words(Params p, KernelBuffers buf) {
  const uint* position_word = reinterpret_cast<const uint*>(buf.position);
  uint* velocity_word = reinterpret_cast<uint*>(buf.velocity);
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (i >= p.n) return;
  for (uint k = 0u; k < 4u; ++k) velocity_word[4u * i + k] = position_word[4u * i + k];
}

Entry peak_words_kernel(uint, Variant) { return reinterpret_cast<Entry>(&peak_words); }

}  // namespace spherepair
