// SPDX-License-Identifier: MIT
// Sums over the threads of a group. With subgroups they go through registers, without through shared memory.
#ifdef SUBGROUPS
shared uint group_sums[(BLOCK + 31) / 32];  // of each subgroup; a word a thread would cost grid_split one of the
                                            // two groups that share a multiprocessor's 48 KiB
#else
shared uint group_sums[BLOCK];
#endif

// The sum of `own` over this thread and those before it. Every thread of the group must call it, and a barrier must
// stand between two calls. The language leaves open which invocations form a subgroup; here they must be consecutive,
// the first ones subgroup 0, so that SUBGROUPS is defined only where that is known (glsl/device_limits.cpp).
#ifdef SUBGROUPS
uint sum_up_to(uint own) {
  uint upto = subgroupInclusiveAdd(own);
  if (gl_SubgroupInvocationID == gl_SubgroupSize - 1u) group_sums[gl_SubgroupID] = upto;
  barrier();
  uint of_subgroup = gl_SubgroupInvocationID < BLOCK / gl_SubgroupSize ? group_sums[gl_SubgroupInvocationID] : 0u;
  uint before = subgroupAdd(gl_SubgroupInvocationID < gl_SubgroupID ? of_subgroup : 0u);
  return before + upto;
}
#else
uint sum_up_to(uint own) {
  uint lane = gl_LocalInvocationID.x;
  uint upto = own;
  for (uint distance = 1u; distance < BLOCK; distance *= 2u) {
    group_sums[lane] = upto;
    barrier();
    if (lane >= distance) upto += group_sums[lane - distance];
    barrier();
  }
  return upto;
}
#endif
