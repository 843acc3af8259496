// SPDX-License-Identifier: MIT
// Scales spheres so that they can be drawn: kernels draw radii of 2^-30 to 2^50.
#pragma once

#include "bench/formats/start.h"
#include "common/image/antialiased_image.h"

namespace spherepair {

// Multiplies all lengths of spheres at rest, of the camera and of a ground given as a height by a power of two, if some
// spheres cannot be drawn otherwise and no number loses a bit. Scaling does not change a bit of the image.
void fit_for_drawing(std::vector<Start>& starts, CameraOptions& camera, std::string& ground);

// The number of spheres that no image can show, and the reason; empty if all can be drawn.
std::string undrawn_text(const Start& start, std::span<const vec4> spheres);

// Throws std::invalid_argument with the reason why an image shows no sphere.
[[noreturn]] void refuse_blank_image(const Start& start, std::span<const vec4> spheres);

}  // namespace spherepair
