#version 450
// SPDX-License-Identifier: MIT
#pragma optionNV(unroll none)  // a tenth faster; slower in other kernels
// One thread per cluster, or per one that was put off: it is listed to be drawn, or put off, unless it is out of view
// or hidden by what is drawn already. Where spheres are many, one thread per bundle comes before.
#include "shaders/draw/listing.glsl"

layout(std430, binding = SLOT_CLUSTER) restrict buffer ClusterBuffer { vec4 cluster[]; };
layout(std430, binding = SLOT_CLUSTER_LIST) restrict buffer ClusterListBuffer { uint cluster_list[]; };
layout(local_size_x = BLOCK) in;
shared uint apart[BLOCK];        // the bundles that are taken apart ...
shared uint deferred_of[BLOCK];  // ... and which of their clusters are put off
shared uint count_apart;

// The list for what is in such a box, or why it is in none. A bundle is looked up in coarser texels than a cluster, and
// one that was put off in the coarsest first.
uint list_for(vec4 low, vec4 high, bool bundled) {
  if (low.x > high.x) return OUT_OF_VIEW;  // there is nothing in it
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

// A bundle that was hidden when it was tested last, as the w of its lowest corner tells, most likely is again: it is
// put off untested.
uint list_for_bundle(uint bundle) {
  uint at = corners_of_bundle(bundle, v);
  vec4 low = cluster[at];
  bool was_hidden = low.w != 0.0f;
  if (was_hidden && v.phase == PHASE_NEAR) return LIST_DEFERRED;
  uint list = list_for(low, cluster[at + 1u], true);
  if (was_hidden != (list == HIDDEN)) cluster[at].w = list == HIDDEN ? 1.0f : 0.0f;
  return list;
}

// All threads of the group call it; `enters`: its entry does.
void enter(uint list, bool enters, uint entry) {
  uint sorted_index = index_in_list(DRAWN_CLUSTERS + list, enters);
  if (enters) cluster_list[list * v.clusters + sorted_index] = entry;
}

void count_in(uint word, uint more) {
  if (v.counting != 0u && more != 0u) atomicAdd(drawn[word], more);
}
void count_left_out(uint list, uint clusters) {
  if (list == OUT_OF_VIEW) count_in(DRAWN_CLUSTERS_OUTSIDE, clusters);
  if (list == HIDDEN) count_in(DRAWN_CLUSTERS_HIDDEN, clusters);
}

// All threads of the group call it; `meant`: its cluster c is tested. Whether that is put off.
bool cull_cluster(uint c, bool meant) {
  uint list = OUT_OF_VIEW;
  if (meant) list = list_for(cluster[2u * c], cluster[2u * c + 1u], false);
  count_left_out(list, meant ? 1u : 0u);
  count_in(DRAWN_CLUSTERS_DEFERRED, list == LIST_DEFERRED ? 1u : 0u);
  enter(list_of(v.phase), list == list_of(v.phase), c);
  return list == LIST_DEFERRED;
}

// All threads of the group call it; `exists`: it has an entry, a bundle and which of its clusters are meant. Those of
// them that are put off.
uint cull_bundle(uint entry, bool exists) {
  uint lane = gl_LocalInvocationID.x;
  uint own = list_of(v.phase);
  bool whole = entry == all_of_bundle(bundle_in(entry), v);  // else its near end was drawn, and the rest put off
  uint list = exists ? own : OUT_OF_VIEW;
  if (exists && whole) list = list_for_bundle(bundle_in(entry));
  if (exists && list != own) count_in(DRAWN_BUNDLES, 1u);
  count_left_out(list, uint(bitCount(bits_in(entry))));
  count_in(DRAWN_CLUSTERS_DEFERRED, list == LIST_DEFERRED ? uint(bitCount(bits_in(entry))) : 0u);
  if (lane == 0u) count_apart = 0u;
  barrier();
  uint sorted_index = list == own ? atomicAdd(count_apart, 1u) : 0u;
  if (list == own) apart[sorted_index] = entry;
  if (list == own) deferred_of[sorted_index] = 0u;
  barrier();
  for (uint from = 0u; from < count_apart * BUNDLE; from += BLOCK) {
    uint of = (from + lane) / BUNDLE;
    uint bit = lane % BUNDLE;
    bool meant = of < count_apart && (bits_in(apart[of]) >> bit & 1u) != 0u;
    uint c = meant ? bundle_in(apart[of]) * BUNDLE + bit : 0u;
    if (cull_cluster(c, meant)) atomicOr(deferred_of[of], 1u << bit);
  }
  barrier();
  return list == own ? deferred_of[sorted_index] : list == LIST_DEFERRED ? bits_in(entry) : 0u;
}

void main() {
  bool again = v.phase == PHASE_FAR;
  uint all = BUNDLES ? bundles_of(v) : v.clusters;
  uint total = again ? drawn[DRAWN_CLUSTERS + LIST_DEFERRED] : all;
  uint at_once = min(uint(BLOCK), total / group_count() + 1u);  // no group is left without
  for (uint first = group_index() * at_once; first < total; first += group_count() * at_once) {
    uint k = first + gl_LocalInvocationID.x;
    bool exists = gl_LocalInvocationID.x < at_once && k < total;
    uint entry = 0u;
    if (exists && again) entry = cluster_list[LIST_DEFERRED * v.clusters + k];
    if (exists && !again) entry = BUNDLES ? all_of_bundle(place_in_turn(k, all, v), v) : place_in_turn(k, all, v);
    uint deferred_count = BUNDLES ? cull_bundle(entry, exists) : uint(cull_cluster(entry, exists));
    uint rest = BUNDLES ? entry - bits_in(entry) + deferred_count : entry;
    if (v.phase == PHASE_NEAR) enter(LIST_DEFERRED, deferred_count != 0u, rest);
  }
}
