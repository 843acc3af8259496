// SPDX-License-Identifier: MIT
// Prefix sums over the threads of a group, through registers within each subgroup.

// Returns the inclusive prefix sum of `own`. Every thread of the group must call it, with a barrier between two calls.
// GLSL only from here: sums of subgroups where the extension exists, else shared memory. The language leaves open which
// invocations form a subgroup; here they must be consecutive, the first ones subgroup 0, so SUBGROUPS is defined only
// where that is known (glsl/device_limits.cpp).
#ifdef SUBGROUPS
// Of each subgroup: a word a thread would cost grid_split one of the two groups that share a multiprocessor's 48 KiB.
shared uint group_sums[(BLOCK + 31) / 32];
uint sum_up_to(uint own) {
  uint upto = subgroupInclusiveAdd(own);
  if (gl_SubgroupInvocationID == gl_SubgroupSize - 1u) group_sums[gl_SubgroupID] = upto;
  barrier();
  uint of_subgroup = gl_SubgroupInvocationID < BLOCK / gl_SubgroupSize ? group_sums[gl_SubgroupInvocationID] : 0u;
  uint before = subgroupAdd(gl_SubgroupInvocationID < gl_SubgroupID ? of_subgroup : 0u);
  return before + upto;
}
#else
shared uint group_sums[BLOCK];
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
// until here
