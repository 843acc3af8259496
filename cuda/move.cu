// SPDX-License-Identifier: MIT
// One thread per sphere: one step of motion and the plane (the paper's code 1), and the results of the last step
// cleared.
#include "kernels.cuh"
#include "motion.h"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) move(Params p, World w) {
  uint i = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  clear_results(p, w, i);
  if (i >= p.n) return;
  Moving next = move_paper(w.position[i], w.velocity[i], p);
  w.position[i] = next.position;
  w.velocity[i] = next.velocity;
}

Entry move_kernel() { return reinterpret_cast<Entry>(&move); }

}  // namespace spherepair
