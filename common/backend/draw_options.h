// SPDX-License-Identifier: MIT
// How an image is drawn, and what of it was left out.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "common/shared/draw.h"

namespace spherepair {

// compute: the rasteriser that CPU, GLSL and CUDA mirror: the exact sphere. The others go through OpenGL's pipeline.
enum class DrawMethod {
  compute,
  mesh_each,  // the paper's sphere of 80 triangles, one draw a sphere
  mesh,       // the same with one instanced draw for all
  quadric,    // glutSolidSphere's sphere of 10 slices and 10 stacks, one draw a sphere: what the paper compares with
  points,     // a disc a sphere
  impostor    // the exact sphere on two triangles
};
const char* draw_method_name(DrawMethod method);
DrawMethod draw_method_from_name(const std::string& name);  // throws std::invalid_argument with the known names
std::span<const DrawMethod> all_draw_methods();

// How spheres that are not OpenGL's own come to its pipeline.
enum class Transfer {
  host,        // read back, written again by OpenGL
  registered,  // CUDA only: copied into OpenGL's buffers, which CUDA maps once a frame, both in one call
  imported     // CUDA only: copied into memory of CUDA's that OpenGL has imported for good
};
const char* transfer_name(Transfer way);

struct DrawOptions {
  DrawMethod method = DrawMethod::compute;
  std::optional<Transfer> transfer = {};  // through OpenGL's pipeline; none: the fastest that the driver has

  // What the rasteriser may leave out; never changes a bit of the image. Consecutive spheres of the cell order (of
  // the scene's, without one) form clusters, which are culled as a whole.
  bool frustum_culling = true;        // clusters out of view
  bool occlusion_culling = true;      // clusters behind what is drawn already; implies the above
  bool reuse_unchanged = true;        // the whole image, when nothing has changed since the last
  bool skip_tile_launches = true;     // the launches for large spheres, where none as uploaded can look large
  bool overlap = true;                // GLSL: few spheres are drawn while the last image is still resolved
  uint64_t clusters_from = 1u << 17;  // clusters are made of so many spheres or more

  // Of so many spheres or more, clusters are tested before their spheres; of fewer that costs more than it saves.
  uint64_t cull_from = 1u << 21;

  // Of so many spheres or more, clusters far behind what the last images showed wait until the near ones are drawn.
  uint64_t defer_from = 1u << 22;

  // Of so many spheres or more, BUNDLE clusters in a row are tested as a whole first.
  uint64_t bundles_from = 1u << 25;

  // Of fewer spheres, which then are large on the screen, each is drawn by LANES threads; without clusters only.
  uint64_t share_below = 1u << 17;

  bool count = false;         // fill all of DrawStatistics, which costs an atomic operation a sphere
  bool keep_visible = false;  // the sphere and the depth of each pixel, for visible()
  auto operator<=>(const DrawOptions&) const = default;
  uint lanes(uint64_t n) const { return n < share_below ? LANES : 1; }
};

// Of one draw(), in spheres; `drawn` are those with a pixel's centre in their box, whether seen in the end or
// not.
struct DrawStatistics {
  uint64_t drawn = 0, unseen = 0;  // out of view, or between the centres of the pixels
  uint64_t large = 0, tiles = 0;   // of those drawn, the ones cut into tiles; their tiles
  uint64_t hidden = 0;             // behind what is drawn already
  uint64_t undrawable = 0;         // numbers beyond those that can be drawn (draw.h, in_camera)
  uint64_t clusters = 0, clusters_outside = 0, clusters_hidden = 0;  // their spheres are in none of the above
  uint64_t clusters_deferred = 0;  // that waited for others to be drawn, whatever became of them then
  uint64_t bundles_left_out = 0;   // of clusters that are hidden, out of view or deferred together
  uint64_t images_kept = 0;        // calls of draw() since upload() that had nothing to do
};

}  // namespace spherepair
