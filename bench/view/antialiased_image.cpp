// SPDX-License-Identifier: MIT
#include "bench/view/antialiased_image.h"

#include <fmt/format.h>

#include <cmath>

#include "bench/view/box_edges.h"
#include "bench/view/image_samples.h"

namespace spherepair {
namespace {

Vector vector_of(const std::vector<double>& values) { return {values[0], values[1], values[2]}; }
json to_json(vec4 v) { return {v.x, v.y, v.z, v.w}; }
json to_json(uvec4 v) {
  json list = json::array();
  for (const uint colour : {v.x, v.y, v.z, v.w}) list.push_back(fmt::format("{:06X}", colour));
  return list;
}

}  // namespace

Camera camera_of(const CameraOptions& options, const Bounds& bounds, double aspect) {
  Camera camera = frame(bounds, options.azimuth, options.elevation, options.field, aspect);
  if (!options.target.empty()) camera.target = vector_of(options.target);
  if (!options.eye.empty()) camera.eye = vector_of(options.eye);
  camera.up = vector_of(options.up);
  camera.near = options.near;
  return camera;
}

// A rank-1 lattice with the golden ratio.
std::array<double, 2> jitter(uint k, uint samples) {
  if (samples == 1) return {0, 0};
  const double golden = (k + 0.5) * 0.6180339887498949;
  return {(k + 0.5) / samples - 0.5, golden - std::floor(golden) - 0.5};
}

std::vector<uint> draw_sample(Backend& backend, const ImageOptions& options, uint k) {
  const View view = make_view(options.camera, options.look, options.width, options.height, jitter(k, options.samples));
  backend.draw(view, {.method = options.method, .keep_visible = options.box.has_value()});
  std::vector<uint> image = backend.image();
  if (options.box) draw_edges(image, backend.visible(), view, *options.box, options.ground);
  return image;
}

std::vector<uint> draw_image(Backend& backend, const ImageOptions& options) {
  if (options.samples == 1) return draw_sample(backend, options, 0);
  ImageSamples samples;
  while (samples.count() < options.samples) samples.add(draw_sample(backend, options, samples.count()));
  return samples.mean();
}

json to_json(const Camera& camera) {
  return {{"eye", camera.eye},
          {"target", camera.target},
          {"up", camera.up},
          {"field_degrees", camera.field},
          {"near", camera.near}};
}

json to_json(const View& view) {
  return {{"eye_and_near", to_json(view.eye)},
          {"right", to_json(view.right)},
          {"up", to_json(view.up)},
          {"forward", to_json(view.forward)},
          {"light_and_ambient", to_json(view.light)},
          {"focal", view.focal},
          {"centre", {view.centre_x, view.centre_y}},
          {"palette", {to_json(view.palette_0), to_json(view.palette_4)}},
          {"background", fmt::format("{:06X}", view.background)}};
}

}  // namespace spherepair
