// SPDX-License-Identifier: MIT
#include "bench/viewer/orbit.h"

#include <algorithm>
#include <cmath>

namespace spherepair {

void Orbit::turn(std::array<double, 2> pixels) {
  azimuth_ -= 0.4 * pixels[0];
  elevation_ = std::clamp(elevation_ + 0.4 * pixels[1], -5.0, 85.0);
}

void Orbit::pan(std::array<double, 2> pixels, const View& seen) {
  const Camera now = camera(double(seen.width) / seen.height);
  const double metres = std::hypot(now.eye[0] - now.target[0], now.eye[1] - now.target[1], now.eye[2] - now.target[2]) /
                        double(seen.focal);  // metres a pixel
  const vec4 &right = seen.right, &up = seen.up;
  panned_[0] += metres * (pixels[1] * up.x - pixels[0] * right.x);
  panned_[1] += metres * (pixels[1] * up.y - pixels[0] * right.y);
  panned_[2] += metres * (pixels[1] * up.z - pixels[0] * right.z);
}

void Orbit::zoom(double notches) { distance_ = std::clamp(distance_ * std::pow(0.9, notches), 0.05, 5.0); }

Camera Orbit::camera(double aspect) const {
  Camera camera = frame(bounds_, azimuth_, elevation_, 30, aspect);
  for (int a = 0; a < 3; ++a) {
    camera.eye[a] = camera.target[a] + distance_ * (camera.eye[a] - camera.target[a]) + panned_[a];
    camera.target[a] += panned_[a];
  }
  return camera;
}

}  // namespace spherepair
