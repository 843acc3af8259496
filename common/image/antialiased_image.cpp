// SPDX-License-Identifier: MIT
#include "common/image/antialiased_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/image/box_edges.h"
#include "common/image/image_samples.h"
#include "common/shared/light.h"

namespace spherepair {
namespace {

Vector vector_of(const std::vector<double>& values) { return {values[0], values[1], values[2]}; }

constexpr double nothing = std::numeric_limits<double>::infinity();

// The distance of each pixel's sphere along forward, metres.
std::vector<double> spheres_ahead(Drawing& drawing, const View& view, DrawMethod method) {
  std::vector<double> ahead(size_t(view.width) * view.height, nothing);
  if (method == DrawMethod::compute) {
    const std::vector<uvec2> visible = drawing.visible();
    for (uint k = 0; k < ahead.size(); ++k)
      if (visible[k].y != ~0u)  // a depth is the distance times the square of the ray's length
        ahead[k] = double(bits_float(visible[k].y)) / double(ray_through(k % view.width, k / view.width, view).a);
  } else {
    const std::vector<float> depths = drawing.depths();
    for (size_t k = 0; k < ahead.size(); ++k)
      if (depths[k] > 0) ahead[k] = double(view.eye.w) / double(depths[k]);
  }
  return ahead;
}

// Adds the separately drawn ground where no sphere is nearer.
void add_ground(std::vector<uint>& image, std::vector<double>& ahead, const std::vector<uint>& ground,
                const View& view) {
  for (uint k = 0; k < ahead.size(); ++k) {
    const Ray ray = ray_through(k % view.width, k / view.width, view);
    const float depth = depth_of_ground(ray, view);
    const double distance = double(depth) / double(ray.a);
    if (depth == 0 || distance >= ahead[k]) continue;
    ahead[k] = distance;
    if (!ground.empty()) image[k] = ground[k];
  }
}

}  // namespace

Camera camera_of(const CameraOptions& options, const Bounds& bounds, double aspect) {
  const Vector up = vector_of(options.up);
  Camera camera = frame(bounds, options.azimuth, options.elevation, options.field, aspect, up);
  if (!options.target.empty()) camera.target = vector_of(options.target);
  if (!options.eye.empty()) camera.eye = vector_of(options.eye);
  camera.near = options.near;
  return camera;
}

// A rank-1 lattice with the golden ratio.
std::array<double, 2> jitter(uint k, uint samples) {
  if (samples == 1) return {0, 0};
  const double golden = (k + 0.5) * 0.6180339887498949;
  return {(k + 0.5) / samples - 0.5, golden - std::floor(golden) - 0.5};
}

DrawnImage draw_sample(Drawing& drawing, const ImageOptions& options, uint k) {
  const bool compute = options.method == DrawMethod::compute;
  View view = make_view(options.camera, options.look, options.width, options.height, jitter(k, options.samples));
  const bool on_ground = view.lighting & LIGHT_GROUND;
  std::vector<uint> ground;
  if (!compute && on_ground) {
    view.lighting |= LIGHT_ALONE;
    drawing.draw(view, {});
    ground = drawing.image();
  }
  drawing.draw(view, {.method = options.method, .keep_visible = compute});
  DrawnImage drawn{drawing.image(), false};
  std::vector<double> ahead = spheres_ahead(drawing, view, options.method);
  drawn.blank = std::ranges::all_of(ahead, [](double distance) { return distance == nothing; });
  if (on_ground) add_ground(drawn.pixels, ahead, ground, view);
  if (options.box) draw_edges(drawn.pixels, ahead, view, *options.box);
  return drawn;
}

DrawnImage draw_image(Drawing& drawing, const ImageOptions& options) {
  if (options.samples == 1) return draw_sample(drawing, options, 0);
  ImageSamples samples;
  bool blank = true;
  while (samples.count() < options.samples) {
    const DrawnImage sample = draw_sample(drawing, options, samples.count());
    blank = blank && sample.blank;
    samples.add(sample.pixels);
  }
  return {samples.mean(), blank};
}

void put_ground(Look& look, const Vector& normal, double height) {
  look.lighting |= LIGHT_GROUND;
  look.ground_normal = normal;
  look.ground = height;
}

}  // namespace spherepair
