// SPDX-License-Identifier: MIT
// The viewer's camera: it orbits a point; the mouse turns it, moves it and brings it nearer.
#pragma once

#include "common/scene/camera.h"

namespace spherepair {

class Orbit {
 public:
  explicit Orbit(const Bounds& bounds) : bounds_(bounds) {}

  void turn(std::array<double, 2> pixels);                   // dragged right and down
  void pan(std::array<double, 2> pixels, const View& seen);  // points at the centre's depth follow the mouse
  void zoom(double notches);
  void reset() { *this = Orbit(bounds_); }
  Camera camera(double aspect) const;

 private:
  Bounds bounds_;
  double azimuth_ = 30, elevation_ = 20, distance_ = 1;  // degrees; distance: over the one with all spheres in view
  Vector panned_ = {};                                   // metres
};

}  // namespace spherepair
