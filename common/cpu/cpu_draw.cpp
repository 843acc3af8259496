// SPDX-License-Identifier: MIT
#include "common/cpu/cpu_draw.h"

#include <algorithm>
#include <optional>

#include "common/cpu/cpu_light.h"

namespace spherepair {
namespace {

constexpr uint none = ~0u;

// Returns the part of a box in the rows from `first` to before `last`.
Box within_rows(Box box, uint first, uint last) {
  const uint begin = std::max(box.y, first), end = std::min(box.y + box.height, last);
  return {box.x, begin, box.width, end > begin ? end - begin : 0};
}

void put(std::vector<uvec2>& visible, const Box& box, vec4 seen, uint sphere, const View& v) {
  for (uint y = box.y; y < box.y + box.height; ++y)
    for (uint x = box.x; x < box.x + box.width; ++x) {
      const float depth = depth_of_hit(seen, ray_through(x, y, v), v);
      uvec2& there = visible[size_t(y) * v.width + x];
      if (depth != 0 && float_bits(depth) < there.y) there = {sphere, float_bits(depth)};  // tie: lowest index
    }
}

void count(DrawStatistics& counts, vec4 seen, const Box& box, const View& v) {
  const bool unseen = box.width == 0 || box.height == 0;
  const bool large = !unseen && is_large(box, v);
  counts.undrawable += seen.w == 0;
  counts.unseen += seen.w != 0 && unseen;
  counts.drawn += !unseen;
  counts.large += large;
  if (large) counts.tiles += tiles_along(box.width) * tiles_along(box.height);
}

uint colour_of(uvec2 there, uint pixel, std::span<const vec4> spheres, std::span<const uint> contacts, const View& v) {
  if (there.y == none) return lit(v.background, 1.0f);
  const Ray ray = ray_through(pixel % v.width, pixel / v.width, v);
  return shade(in_camera(spheres[there.x], v), ray, bits_float(there.y), contacts[there.x], v);
}

}  // namespace

// Draws the image in bands of rows. Each thread goes through all spheres for its band.
CpuImage draw_image(std::span<const vec4> spheres, std::span<const uint> contacts, const View& view, const Params& p,
                    int threads) {
  std::optional<CpuLight> light;
  if (view.lighting != 0) light.emplace(spheres, p);
  const size_t pixels = size_t(view.width) * view.height;
  CpuImage image{std::vector<uint>(pixels), std::vector<uvec2>(pixels, uvec2{none, none}), {}};
#pragma omp parallel for num_threads(threads) schedule(static, 1)
  for (int band = 0; band < threads; ++band) {
    const uint first = uint(uint64_t(view.height) * uint(band) / uint(threads));
    const uint last = uint(uint64_t(view.height) * (uint(band) + 1) / uint(threads));
    for (size_t i = 0; i < spheres.size(); ++i) {
      const vec4 seen = in_camera(spheres[i], view);
      const Box box = in_frustum(seen, view) ? box_of(seen, view) : Box{};
      if (band == 0) count(image.counts, seen, box, view);
      put(image.visible, within_rows(box, first, last), seen, uint(i), view);
    }
    for (size_t pixel = size_t(first) * view.width; pixel < size_t(last) * view.width; ++pixel)
      image.image[pixel] = light ? light->colour(image.visible[pixel], uint(pixel), contacts, view)
                                 : colour_of(image.visible[pixel], uint(pixel), spheres, contacts, view);
  }
  return image;
}

}  // namespace spherepair
