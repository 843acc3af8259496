// SPDX-License-Identifier: MIT
// Antialiased images: the mean of images with subpixel offsets; and cameras from their options.
#pragma once

#include <optional>

#include "bench/io/report.h"
#include "common/backend/backend.h"
#include "common/scene/camera.h"

namespace spherepair {

struct ImageOptions {
  Camera camera;
  Look look;
  uint width, height, samples;
  DrawMethod method = DrawMethod::compute;
  std::optional<Bounds> box = {};  // its edges are drawn
};

struct DrawnImage {
  std::vector<uint> pixels;  // in the format of Backend::image()
  bool blank;                // no pixel shows a sphere
};

// With `eye`, that camera; otherwise one from a direction with all spheres in view.
struct CameraOptions {
  std::vector<double> eye, target, up = {0, 1, 0};  // metres; no target: the centre of the spheres
  double azimuth = 30, elevation = 15, field = 30;  // degrees
  double near = 0;
};

Camera camera_of(const CameraOptions& options, const Bounds& bounds, double aspect);

// The offset of sample k in pixels: evenly distributed over a pixel; 0 for a single sample.
std::array<double, 2> jitter(uint k, uint samples);

// Draws the uploaded spheres as they stand. What OpenGL draws gets the box's edges and the ground, with their shadows
// on it, from the same view by compute; occlusion and shadows on the spheres themselves are compute's alone.
DrawnImage draw_image(Backend& backend, const ImageOptions& options);
DrawnImage draw_sample(Backend& backend, const ImageOptions& options, uint k);  // one of its samples

json to_json(const Camera& camera);
json to_json(const View& view);  // all parameters of the draw

}  // namespace spherepair
