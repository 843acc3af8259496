// SPDX-License-Identifier: MIT
// The viewer's camera: it looks at a point from around it, and is turned, moved and brought nearer by the mouse.
#pragma once

#include "common/scene/camera.h"

namespace spherepair {

class Orbit {
 public:
  explicit Orbit(const Bounds& bounds) : bounds_(bounds) {}

  void turn(std::array<double, 2> pixels);                   // dragged right and down
  void pan(std::array<double, 2> pixels, const View& seen);  // what is at the centre's depth follows the mouse
  void zoom(double notches);
  void reset() { *this = Orbit(bounds_); }
  Camera camera(double aspect) const;

 private:
  Bounds bounds_;
  double azimuth_ = 30, elevation_ = 20, distance_ = 1;  // degrees; relative to that with all spheres in view
  Vector panned_ = {};                                   // metres
};

}  // namespace spherepair
