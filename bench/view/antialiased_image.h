// SPDX-License-Identifier: MIT
// Photographs: a camera from its options, and the mean of pictures each moved by part of a pixel.
#pragma once

#include <optional>

#include "bench/io/report.h"
#include "common/backend/backend.h"
#include "common/scene/camera.h"

namespace spherepair {

struct Shot {
  Camera camera;
  Look look;
  uint width, height, samples;
  DrawMethod method = DrawMethod::compute;
  std::optional<Bounds> box = {};    // its edges are drawn; of the method compute only
  std::optional<float> ground = {};  // height of the plane where that is drawn, metres
};

// A camera where it is given, else the frame of the spheres at the start from a direction.
struct CameraOptions {
  std::vector<double> eye, target, up = {0, 1, 0};  // metres; no eye: framed; no target: the middle of the spheres
  double azimuth = 30, elevation = 15, field = 30;  // degrees
  double near = 0;
};

Camera camera_of(const CameraOptions& options, const Bounds& bounds, double aspect);

// By how much sample k of so many moves the image, in pixels: evenly spread over one pixel; not at all for one.
std::array<double, 2> jitter(uint k, uint samples);

// Draws into an image, as Backend::image() gives it; the backend holds the spheres and has found their contacts.
std::vector<uint> take(Backend& backend, const Shot& shot);

json to_json(const Camera& camera);
json to_json(const View& view);  // every number that a backend was given

}  // namespace spherepair
