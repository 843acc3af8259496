#version 450
// SPDX-License-Identifier: MIT
// One thread per cluster, or per one that was put off: it is listed to be drawn, or put off, unless it is out of view
// or hidden by what is drawn already. The parts of those that would be drawn are tested too, one thread a part.
#include "listing.glsl"

layout(std430, binding = SLOT_CLUSTER) restrict readonly buffer ClusterBuffer { vec4 cluster[]; };
layout(std430, binding = SLOT_CLUSTER_LIST) restrict buffer ClusterListBuffer { uint cluster_list[]; };
layout(local_size_x = BLOCK) in;
shared uint in_parts[BLOCK];    // the clusters whose parts are tested ...
shared uint parts_list[BLOCK];  // ... and the lists for them
shared uint in_parts_count;

// The list for what is in such a box, by texels of level 1 or of the level that suits it, or why it is in none.
uint list_for(vec4 low, vec4 high, bool coarsely) {
  Solid solid = solid_of(low, high, v);
  if (outside(solid, v)) return OUT_OF_VIEW;
  if (v.occlusion == 0u || reaches_eye_plane(solid)) return list_of(v.phase);
  Box box = box_of_solid(solid, v);
  if (box.width == 0u || box.height == 0u) return HIDDEN;
  uint nearest = least_depth(solid, box, v);
  uvec2 texel = texel_of_box(box, nearest, coarsely ? 1u : level_for(box));
  if (texel.x < nearest) return HIDDEN;
  if (v.phase != PHASE_NEAR || texel.y >= nearest) return list_of(v.phase);
  return texel.y < least_depth(brought_nearer(solid, low, high), box, v) ? LIST_PUT_OFF : LIST_DRAWN;
}

// All threads of the group call it; `enters`: its cluster c does.
void enter(uint list, bool enters, uint c) {
  uint place = place_in_list(DRAWN_CLUSTERS + list, enters);
  if (enters) cluster_list[list * v.clusters + place] = c;
}

void count_clusters(uint word) {
  if (v.counting != 0u) atomicAdd(drawn[word], 1u);
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  bool again = v.phase == PHASE_FAR;
  uint own = list_of(v.phase);
  uint total = again ? drawn[DRAWN_CLUSTERS + LIST_PUT_OFF] : v.clusters;
  for (uint first = group_index() * BLOCK; first < total; first += group_count() * BLOCK) {
    uint k = first + lane;
    uint c = 0u;
    uint list = OUT_OF_VIEW;
    if (k < total) c = again ? cluster_list[LIST_PUT_OFF * v.clusters + k] : place_in_turn(k, v.clusters, v);
    bool exists = k < total && cluster[2u * c].x <= cluster[2u * c + 1u].x;
    if (exists) list = list_for(cluster[2u * c], cluster[2u * c + 1u], true);
    if (lane == 0u) in_parts_count = 0u;
    barrier();
    bool asks = v.occlusion != 0u && list == own;
    uint place = asks ? atomicAdd(in_parts_count, 1u) : 0u;
    if (asks) in_parts[place] = c;
    if (asks) parts_list[place] = OUT_OF_VIEW;
    barrier();
    for (uint q = lane; q < in_parts_count * CLUSTER_PARTS; q += BLOCK) {
      uint of = in_parts[q / CLUSTER_PARTS];
      Corners part = part_of(cluster[2u * of], cluster[2u * of + 1u], q % CLUSTER_PARTS);
      atomicMin(parts_list[q / CLUSTER_PARTS], list_for(part.low, part.high, false));
    }
    barrier();
    if (asks) list = parts_list[place];
    if (k < total && list == OUT_OF_VIEW) count_clusters(DRAWN_CLUSTERS_OUTSIDE);
    if (k < total && list == HIDDEN) count_clusters(DRAWN_CLUSTERS_HIDDEN);
    enter(own, list == own, c);
    if (v.phase == PHASE_NEAR) enter(LIST_PUT_OFF, list == LIST_PUT_OFF, c);
  }
}
