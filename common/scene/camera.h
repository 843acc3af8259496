// SPDX-License-Identifier: MIT
// Where a image is taken from. All is computed in float64 and rounded once; the View that comes of it decides every
// bit of the image.
#pragma once

#include <array>
#include <span>
#include <string>

#include "common/shared/layout.h"
#include "common/shared/view.h"

namespace spherepair {

using Vector = std::array<double, 3>;

// Metres and degrees.
struct Camera {
  Vector eye = {0, 0, 10}, target = {0, 0, 0}, up = {0, 1, 0};
  double field = 40;  // of view, from the image's lower to its upper edge
  double near = 0;    // least depth that is drawn; 0: a thousandth of the distance from eye to target
};

// What is to be in view: a box that holds all spheres. Empty for no spheres: the unit cube.
struct Bounds {
  Vector low, high;
};
Bounds bounds_of(std::span<const vec4> spheres);

// From a direction so that the box just fits: degrees around `up`, for y from +z to +x, for z from +x to +y, for x from
// +y to +z, and above the horizon.
Camera frame(const Bounds& bounds, double azimuth, double elevation, double field, double aspect,
             const Vector& up = {0, 1, 0});

struct Look {
  std::array<uint, COLOURS> palette;  // 0xRRGGBB of 0, 1 ... 6, 7 and more contacts, or limits that are reached
  uint colour_by = COLOUR_BY_CONTACTS;
  std::array<double, COLOURS - 1> limits = {};  // ascending; metres a second, or metres
  uint background = 0xFFFFFF;
  Vector light = {-0.35, 0.75, -0.56};  // towards the light: right, up, forward of the camera
  double ambient = 0.38;                // the share of light from all around
  uint lighting = 0;                    // LIGHT_*; on the ground there must be light from above
  Vector ground_normal = {0, 1, 0};     // upwards
  double ground = 0;                    // its height along the normal, metres
  double shadow = 0.72;                 // the ground's brightness in full shadow, of the background's
};
// By speed or radius: equal intervals from the lowest to the highest, from dark violet over green to yellow.
Look range_look(uint colour_by, double lowest, double highest);
Look contact_look();  // blue without contacts, then from pale yellow to dark red: told apart also by the colour-blind

constexpr uint widest_image = 16384;  // pixels, along either axis

// Throws std::invalid_argument when the camera has no direction, no field or a bad near, or the image no size.
// jitter: by how many pixels the image is moved, for antialiasing.
View make_view(const Camera& camera, const Look& look, uint width, uint height, std::array<double, 2> jitter = {});
void check_view(const View& view);  // throws std::invalid_argument for an image without pixels, or too many

}  // namespace spherepair
