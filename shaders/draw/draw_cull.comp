#version 450
// SPDX-License-Identifier: MIT
#pragma optionNV(unroll none)  // GLSL only: a tenth faster; slower in other kernels
// One thread per cluster, or per deferred cluster: culls it by frustum and occlusion. A cluster that passes is listed
// to be drawn, or deferred. With many spheres, one thread per bundle of clusters comes first.
#include "shaders/draw/append.glsl"

layout(std430, binding = SLOT_CLUSTER) restrict buffer ClusterBuffer { vec4 cluster[]; };
layout(std430, binding = SLOT_CLUSTER_LIST) restrict buffer ClusterListBuffer { uint cluster_list[]; };
layout(local_size_x = BLOCK) in;
shared uint bundle_entries[BLOCK];  // the bundles whose clusters are tested ...
shared uint deferred_of[BLOCK];     // ... and which of these are deferred
shared uint bundles_listed;

// Returns the list for the contents of a box, or why it is culled. A bundle is tested at a coarser level than a
// cluster, a deferred bundle at the coarsest first.
uint list_for(vec4 low, vec4 high, bool bundled) {
  if (low.x > high.x) return OUT_OF_VIEW;  // empty
  Solid solid = solid_of(low, high, v);
  if (outside(solid, v)) return OUT_OF_VIEW;
  if (v.occlusion == 0u || reaches_eye_plane(solid)) return list_of(v.phase);
  Box box = box_of_solid(solid, v);
  if (box.width == 0u || box.height == 0u) return HIDDEN;
  uint nearest = least_depth(solid, box, v);
  if (bundled && v.phase == PHASE_FAR && texel_of_box(box, nearest, 2u).x < nearest) return HIDDEN;
  bool large = !BUNDLES && v.width * v.height >= LARGE_IMAGE;
  uint level = bundled || (large && texels_of(box, 0u) > uint(TEXELS_FEW)) ? 1u : level_for(box);
  if (texels_of(box, level) > uint(TEXELS_TO_SEARCH)) level = 2u;
  uvec2 texel = texel_of_box(box, nearest, level);
  if (texel.x < nearest) return HIDDEN;
  if (v.phase != PHASE_NEAR || texel.y >= nearest) return list_of(v.phase);
  return texel.y < least_depth(brought_nearer(solid, low, high), box, v) ? LIST_DEFERRED : LIST_DRAWN;
}

// Returns the list for a bundle. One that was hidden at its last test (w of its lowest corner) most likely is again, so
// it is deferred untested.
uint list_for_bundle(uint bundle) {
  uint at = corners_of_bundle(bundle, v);
  vec4 low = cluster[at];
  bool was_hidden = low.w != 0.0f;
  if (was_hidden && v.phase == PHASE_NEAR) return LIST_DEFERRED;
  uint list = list_for(low, cluster[at + 1u], true);
  if (was_hidden != (list == HIDDEN)) cluster[at].w = list == HIDDEN ? 1.0f : 0.0f;
  return list;
}

// Appends the entries of threads with `appends`. All threads of the group must call it.
void append(uint list, bool appends, uint entry) {
  uint at = append_index(DRAWN_CLUSTERS + list, appends);
  if (appends) cluster_list[list * v.clusters + at] = entry;
}

void count_in(uint word, uint more) {
  if (v.counting != 0u && more != 0u) atomicAdd(drawn[word], more);
}
void count_left_out(uint list, uint clusters) {
  if (list == OUT_OF_VIEW) count_in(DRAWN_CLUSTERS_OUTSIDE, clusters);
  if (list == HIDDEN) count_in(DRAWN_CLUSTERS_HIDDEN, clusters);
}

// Tests cluster c for each thread with `selected`; returns whether it is deferred. All threads of the group must call
// it.
bool cull_cluster(uint c, bool selected) {
  uint list = OUT_OF_VIEW;
  if (selected) list = list_for(cluster[2u * c], cluster[2u * c + 1u], false);
  count_left_out(list, selected ? 1u : 0u);
  count_in(DRAWN_CLUSTERS_DEFERRED, list == LIST_DEFERRED ? 1u : 0u);
  append(list_of(v.phase), list == list_of(v.phase), c);
  return list == LIST_DEFERRED;
}

// Tests an entry for each thread with `exists`: a bundle and its selected clusters. Returns which of these are
// deferred. All threads of the group must call it.
uint cull_bundle(uint entry, bool exists) {
  uint lane = gl_LocalInvocationID.x;
  uint own = list_of(v.phase);
  bool whole = entry == all_of_bundle(bundle_in(entry), v);  // else its near clusters were drawn, and the rest deferred
  uint list = exists ? own : OUT_OF_VIEW;
  if (exists && whole) list = list_for_bundle(bundle_in(entry));
  if (exists && list != own) count_in(DRAWN_BUNDLES, 1u);
  count_left_out(list, count_bits(bits_in(entry)));
  count_in(DRAWN_CLUSTERS_DEFERRED, list == LIST_DEFERRED ? count_bits(bits_in(entry)) : 0u);
  if (lane == 0u) bundles_listed = 0u;
  barrier();
  uint slot = list == own ? atomicAdd(bundles_listed, 1u) : 0u;
  if (list == own) bundle_entries[slot] = entry;
  if (list == own) deferred_of[slot] = 0u;
  barrier();
  for (uint from = 0u; from < bundles_listed * BUNDLE; from += BLOCK) {
    uint of = (from + lane) / BUNDLE;
    uint bit = lane % BUNDLE;
    bool selected = of < bundles_listed && (bits_in(bundle_entries[of]) >> bit & 1u) != 0u;
    uint c = selected ? bundle_in(bundle_entries[of]) * BUNDLE + bit : 0u;
    if (cull_cluster(c, selected)) atomicOr(deferred_of[of], 1u << bit);
  }
  barrier();
  return list == own ? deferred_of[slot] : list == LIST_DEFERRED ? bits_in(entry) : 0u;
}

void main() {
  bool again = v.phase == PHASE_FAR;
  uint all = BUNDLES ? bundles_of(v) : v.clusters;
  uint total = again ? drawn[DRAWN_CLUSTERS + LIST_DEFERRED] : all;
  uint at_once = min(uint(BLOCK), total / group_count() + 1u);  // few clusters are spread over all groups
  for (uint first = group_index() * at_once; first < total; first += group_count() * at_once) {
    uint k = first + gl_LocalInvocationID.x;
    bool exists = gl_LocalInvocationID.x < at_once && k < total;
    uint entry = 0u;
    if (exists && again) entry = cluster_list[LIST_DEFERRED * v.clusters + k];
    if (exists && !again) entry = BUNDLES ? all_of_bundle(front_to_back(k, all, v), v) : front_to_back(k, all, v);
    uint deferred_count = BUNDLES ? cull_bundle(entry, exists) : uint(cull_cluster(entry, exists));
    uint rest = BUNDLES ? entry - bits_in(entry) + deferred_count : entry;
    if (v.phase == PHASE_NEAR) append(LIST_DEFERRED, deferred_count != 0u, rest);
  }
}
