// SPDX-License-Identifier: MIT
// Images of spheres of any size: kernels draw radii of 2^-30 to 2^50.
#pragma once

#include "bench/formats/start.h"
#include "bench/image/antialiased_image.h"

namespace spherepair {

// Multiplies all lengths of spheres at rest, of the camera and of the ground's height, if it is one, by a power of two,
// where some cannot be drawn as they are and no number loses a bit. The image of spheres that can be drawn either way
// is the same bit for bit.
void fit_for_drawing(std::vector<Start>& starts, CameraOptions& camera, std::string& ground);

// How many spheres no image can show, and why; empty if all can be drawn.
std::string undrawn_text(const Start& start, std::span<const vec4> spheres);

// Throws std::invalid_argument: why an image shows no sphere.
[[noreturn]] void refuse_blank_image(const Start& start, std::span<const vec4> spheres);

}  // namespace spherepair
