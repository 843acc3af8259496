// SPDX-License-Identifier: MIT
// Draws antialiased images, the mean of images with subpixel offsets, and makes cameras from their options.
#pragma once

#include <optional>

#include "common/backend/drawing.h"
#include "common/scene/camera.h"

namespace spherepair {

struct ImageOptions {
  Camera camera;
  Look look;
  uint width, height, samples;
  DrawMethod method = DrawMethod::compute;
  std::optional<Bounds> box = {};  // draws its edges
};

struct DrawnImage {
  std::vector<uint> pixels;  // in the format of Drawing::image()
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

// Draws the backend's spheres. An image through OpenGL's pipeline gets the box's edges, and from compute kernels the
// ground with shadows on it. Occlusion and shadows on the spheres themselves exist only in compute.
DrawnImage draw_image(Drawing& drawing, const ImageOptions& options);
DrawnImage draw_sample(Drawing& drawing, const ImageOptions& options, uint k);  // sample k of that image

// Adds a ground. height: metres along the upward normal.
void put_ground(Look& look, const Vector& normal, double height);

}  // namespace spherepair
