// SPDX-License-Identifier: MIT
#include "tests/support/images.h"

#include <fmt/format.h>

#include "common/shared/draw.h"

namespace spherepair {

Image brute_force_image(const std::vector<vec4>& spheres, const std::vector<uint>& contacts, const View& view) {
  Image image;
  std::vector<vec4> seen;
  for (const vec4& sphere : spheres) seen.push_back(in_camera(sphere, view));
  for (uint y = 0; y < view.height; ++y)
    for (uint x = 0; x < view.width; ++x) {
      const Ray ray = ray_through(x, y, view);
      uvec2 nearest = {~0u, ~0u};
      for (uint i = 0; i < seen.size(); ++i) {
        const float depth = seen[i].w > 0 ? depth_of_hit(seen[i], ray, view) : 0;
        if (depth > 0 && float_bits(depth) < nearest.y) nearest = {i, float_bits(depth)};
      }
      image.visible.push_back(nearest);
      image.image.push_back(nearest.y == ~0u
                                ? lit(view.background, 1)
                                : shade(seen[nearest.x], ray, bits_float(nearest.y), contacts[nearest.x], view));
    }
  return image;
}

std::string why_no_pipeline(Backend& backend) {
  if (drawing_of(backend).draw_methods().size() == 1) return "no pipeline of OpenGL's draws its spheres";
  const auto& all = all_backends();
  const auto opengl = std::ranges::find(all, "opengl", &OpenedBackend::name);
  if (opengl == all.end() || !opengl->backend) return "no OpenGL here";
  return is_gpu(backend) && !is_gpu(*opengl->backend) ? "OpenGL runs in software, next to a GPU" : "";
}

void DeviceImages::SetUp() {
  KernelTest::SetUp();
  if (IsSkipped() || HasFatalFailure()) return;
  if (backend().info().on_host) GTEST_SKIP() << "the CPU draws every sphere anew";
}

Image image_of(Backend& backend, const View& view, const DrawOptions& options) {
  Drawing& drawing = drawing_of(backend);
  drawing.draw(view, options);
  Image image{drawing.image(), {}};
  DrawOptions keeping = options;  // draws it on another path
  keeping.keep_visible = true;
  drawing.draw(view, keeping);
  image.visible = drawing.visible();
  if (drawing.image() != image.image) image.image.clear();  // equal to none
  backend.check_guards();
  return image;
}

std::string first_mismatch(const Image& given, const Image& expected, const View& view) {
  if (given.image.size() != expected.image.size() || given.visible.size() != expected.visible.size())
    return fmt::format("{} pixels, not {}", given.image.size(), expected.image.size());
  for (size_t k = 0; k < given.image.size(); ++k) {
    const uvec2 mine = given.visible[k], wanted = expected.visible[k];
    if (mine.x == wanted.x && mine.y == wanted.y && given.image[k] == expected.image[k]) continue;
    return fmt::format("pixel ({}, {}): sphere {} at depth {:08X} in {:08X}, not sphere {} at {:08X} in {:08X}",
                       k % view.width, k / view.width, mine.x, mine.y, given.image[k], wanted.x, wanted.y,
                       expected.image[k]);
  }
  return {};
}

}  // namespace spherepair
