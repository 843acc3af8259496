// SPDX-License-Identifier: MIT
// The options of an image, and counts of what was drawn and what was culled.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "common/shared/draw.h"

namespace spherepair {

// `compute` is the rasteriser that CPU, GLSL and CUDA share; it draws exact spheres. All others use OpenGL's pipeline.
enum class DrawMethod {
  compute,
  mesh_each,  // the paper's sphere of 80 triangles, one draw call a sphere
  mesh,       // the same, one instanced draw call for all
  quadric,    // glutSolidSphere's sphere, 10 slices and 10 stacks, one draw call a sphere: the paper's comparison
  points,     // one disc a sphere
  impostor    // the exact sphere on two triangles
};
const char* draw_method_name(DrawMethod method);
DrawMethod draw_method_from_name(const std::string& name);  // throws std::invalid_argument with the known names
std::span<const DrawMethod> all_draw_methods();

// How spheres that are not OpenGL's own reach its pipeline.
enum class Transfer {
  host,        // read to the host, uploaded again through OpenGL
  registered,  // CUDA only: copied into OpenGL's buffers, which CUDA maps once a frame, both in one call
  imported     // CUDA only: copied into memory of CUDA's that OpenGL has imported for good
};
const char* transfer_name(Transfer way);

struct DrawOptions {
  DrawMethod method = DrawMethod::compute;
  std::optional<Transfer> transfer = {};  // to OpenGL's pipeline; none: the driver's fastest

  // What the rasteriser may skip; never changes a bit of the image. Clusters are consecutive spheres in cell order (or
  // in the scene's order, if there is no cell order); each is culled as a whole.
  bool frustum_culling = true;        // clusters out of view
  bool occlusion_culling = true;      // clusters behind what is drawn already; includes frustum culling
  bool reuse_unchanged = true;        // the whole image, if nothing has changed since the last one
  bool skip_tile_launches = true;     // the launches for large spheres, if no uploaded sphere can look large
  bool overlap = true;                // GLSL: few spheres are drawn while the previous image is still resolved
  uint64_t clusters_from = 1u << 17;  // number of spheres from which on there are clusters

  // From this many spheres on, clusters are tested before their spheres; for fewer the test costs more than it saves.
  uint64_t cull_from = 1u << 21;

  // From this many spheres on, clusters far behind the surfaces of the last images wait until the near ones are drawn.
  uint64_t defer_from = 1u << 22;

  // From this many spheres on, bundles of BUNDLE consecutive clusters are tested first.
  uint64_t bundles_from = 1u << 25;

  // Below this many spheres, which then look large, LANES threads draw each sphere; only without clusters.
  uint64_t share_below = 1u << 17;

  bool count = false;         // fill all of DrawStatistics, which costs an atomic operation a sphere
  bool keep_visible = false;  // the sphere and the depth of each pixel, for visible()
  auto operator<=>(const DrawOptions&) const = default;
  uint lanes(uint64_t n) const { return n < share_below ? LANES : 1; }
};

// Counts of one draw(), in spheres. `drawn` spheres have a pixel's centre in their box of pixels, whether or not they
// are visible in the end.
struct DrawStatistics {
  uint64_t drawn = 0, unseen = 0;  // unseen: out of view, or between the centres of the pixels
  uint64_t large = 0, tiles = 0;   // large: drawn spheres that were cut into tiles; tiles: how many
  uint64_t hidden = 0;             // behind what is drawn already
  uint64_t undrawable = 0;         // numbers too large or too small to draw (draw.h, in_camera)
  uint64_t clusters = 0, clusters_outside = 0, clusters_hidden = 0;  // spheres in culled clusters count nowhere above
  uint64_t clusters_deferred = 0;                                    // clusters that waited for nearer ones to be drawn
  uint64_t bundles_left_out = 0;  // bundles whose clusters were culled or deferred as a whole
  uint64_t images_kept = 0;       // calls of draw() since upload() that kept the image
};

}  // namespace spherepair
