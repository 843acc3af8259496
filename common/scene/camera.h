// SPDX-License-Identifier: MIT
// The camera of an image. Everything is computed in float64 and rounded once, into the View, which decides every bit of
// the image.
#pragma once

#include <array>
#include <span>
#include <string>

#include "common/shared/layout.h"
#include "common/shared/view.h"

namespace spherepair {

using Vector = std::array<double, 3>;

// Lengths in metres, angles in degrees.
struct Camera {
  Vector eye = {0, 0, 10}, target = {0, 0, 0}, up = {0, 1, 0};
  double field = 40;  // of view, from the image's lower to its upper edge
  double near = 0;    // least depth that is drawn; 0: 1/1000 of the distance from eye to target
};

// The box that the image must show. For no spheres it is the unit cube.
struct Bounds {
  Vector low, high;
};
Bounds bounds_of(std::span<const vec4> spheres);

// Returns a camera from which the box just fits into the image. Azimuth is in degrees around `up`: for y from +z to +x,
// for z from +x to +y, for x from +y to +z. Elevation is in degrees above the horizon.
Camera frame(const Bounds& bounds, double azimuth, double elevation, double field, double aspect,
             const Vector& up = {0, 1, 0});

struct Look {
  std::array<uint, COLOURS> palette;  // 0xRRGGBB by contacts (0, 1 ... 6, 7 and more) or by limits reached
  uint colour_by = COLOUR_BY_CONTACTS;
  std::array<double, COLOURS - 1> limits = {};  // ascending; m/s or m
  uint background = 0xFFFFFF;
  Vector light = {-0.35, 0.75, -0.56};  // towards the light: right, up, forward of the camera
  double ambient = 0.38;                // share of the light that comes from all around
  uint lighting = 0;                    // LIGHT_*; with a ground, light must come from above
  Vector ground_normal = {0, 1, 0};     // upwards
  double ground = 0;                    // its height along the normal, metres
  double shadow = 0.72;                 // brightness of the ground in full shadow, relative to the background
};
// Returns colours by speed or radius: equal intervals from lowest to highest, dark violet over green to yellow.
Look range_look(uint colour_by, double lowest, double highest);
Look contact_look();  // blue without contacts, then pale yellow to dark red; safe for the colour-blind

constexpr uint widest_image = 16384;  // pixels, along either axis

// Makes the view. Throws std::invalid_argument if the camera has no direction, no field or a bad near, or the image no
// size. jitter: pixels by which the image is moved, for antialiasing.
View make_view(const Camera& camera, const Look& look, uint width, uint height, std::array<double, 2> jitter = {});
void check_view(const View& view);  // throws std::invalid_argument for an image without pixels, or too many

}  // namespace spherepair
