// SPDX-License-Identifier: MIT
// A row for every buffer of layout.h, in the order of the slots: its type and name in kernels, and its name in
// messages. `three` stands for one buffer each for x, y and z. A Launch can show a kernel another buffer in a slot.
#pragma once

struct ListState;  // of common/shared/list.h
struct ListSystem;
struct ListLook;

// clang-format off
#define SPHEREPAIR_BUFFERS(one, three)                                        \
  one(POSITION, vec4*, position, "positions")                                 \
  one(VELOCITY, vec4*, velocity, "velocities")                                \
  one(COUNT, uint*, count, "counts")                                          \
  one(SUMMARY, uint*, summary, "summary")                                     \
  one(DEFERRED, uvec2*, deferred, "deferred pairs")                           \
  one(PAIR, uvec2*, listed, "pairs")                                          \
  one(SPHERES, const vec4*, spheres, "spheres to decide")                     \
  one(VERDICT, uint*, verdict, "verdicts")                                    \
  one(CELL, uint*, cell, "cells")                                             \
  one(SPLIT_ID, const uint*, from_id, "sphere indices in buckets")            \
  one(SORTED, vec4*, sorted, "spheres in cell order")                         \
  one(ID, uint*, id, "sphere indices")                                        \
  one(SORTED_COUNT, uint*, sorted_count, "counts in cell order")              \
  one(SCAN, uint*, tile_sum, "tiles of the scan")                             \
  one(SPLIT, vec4*, split, "spheres in buckets")                              \
  one(BUCKET, uint*, bucket_cursor, "buckets")                                \
  one(VISIBLE, uvec2*, visible, "visible spheres")                            \
  one(IMAGE, uint*, image, "image")                                           \
  one(TILE, uvec2*, tile, "tiles of large spheres")                           \
  one(DRAWN, uint*, drawn, "counts of drawing")                               \
  one(CLUSTER, vec4*, cluster, "clusters")                                    \
  one(SEEN_LEFT, uint*, seen_left, "ages of visible spheres")                 \
  one(CLUSTER_LIST, uint*, cluster_list, "list of clusters")                  \
  one(PYRAMID, uvec2*, pyramid, "depth pyramid")                              \
  one(WIDE, void*, wide, "wide state")                                        \
  one(ANCHOR, const vec4*, anchor, "anchors")                                 \
  one(FLIGHT, void*, flight, "flights")                                       \
  one(SINCE, uint*, since, "steps of the anchors")                            \
  one(NEXT_EVENT, uint*, next_event, "steps of the next events")              \
  one(SEEN_LIST, uint*, seen_list, "list of visible spheres")                 \
  one(VISIBLE_ODD, uvec2*, visible_odd, "visible spheres of every other image") \
  one(COLOUR, uint*, colour, "colours")                                       \
  three(AXIS, AxisBuffer, axis, "state")                                      \
  three(IMPULSE, int64_t*, impulse, "impulses")                               \
  one(GROWN, vec4*, grown, "grown spheres")                                   \
  one(NEAR, uvec2*, near, "near pairs")                                       \
  one(FAULT, uint*, fault, "faults")                                          \
  one(ROW_LENGTH, uint*, row_length, "lengths of rows")                       \
  one(REST, uint*, rest, "rest of the spheres")                               \
  one(LIST_STATE, ListState*, list_state, "state of a list")                  \
  one(LIST_SYSTEM, ListSystem*, list_system, "systems of a list")             \
  one(LIST_GIVEN, const dvec4*, list_given, "points of a list")               \
  one(LIST_PLACE, ivec4*, list_place, "places of points")                     \
  one(LIST_BEGIN, int64_t*, list_begin, "begins of rows")                     \
  one(LIST_SUM, uint64_t*, list_sum, "tiles of rows")                         \
  one(LIST_FIRST, uint*, list_first, "first points of pairs")                 \
  one(LIST_SECOND, uint*, list_second, "second points of pairs")              \
  one(LIST_SHIFT, int*, list_shift, "shifts of pairs")                        \
  one(LIST_LOOK, ListLook*, list_look, "what points look through")            \
  one(LIST_EXCLUDED, const uvec2*, list_excluded, "pairs that are left out")  \
  one(LIST_KEY, uint*, list_keys, "keys of pairs")                     \
  one(LIST_BIN, uvec2*, list_bins, "bins of points")                          \
  one(LIST_LONG, uint*, list_long, "groups with long rows")                   \
  one(IMAGE_OF, uint*, image_of, "spheres of images")
// clang-format on
