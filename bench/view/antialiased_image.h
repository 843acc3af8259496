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
  std::optional<Bounds> box = {};    // its edges are drawn, by the method compute only
  std::optional<float> ground = {};  // height of the plane, if it is drawn, metres
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

// Draws the uploaded spheres, coloured by the contacts of the last collide(), in the format of Backend::image().
std::vector<uint> draw_image(Backend& backend, const ImageOptions& options);
std::vector<uint> draw_sample(Backend& backend, const ImageOptions& options, uint k);  // one of them

json to_json(const Camera& camera);
json to_json(const View& view);  // all parameters of the draw

}  // namespace spherepair
