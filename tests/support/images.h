// SPDX-License-Identifier: MIT
// Makes the expected image: tests every sphere at every pixel and skips nothing.
#pragma once

#include "common/scene/camera.h"
#include "tests/support/backends.h"

namespace spherepair {

struct Image {
  std::vector<uint> image;
  std::vector<uvec2> visible;
};
Image brute_force_image(const std::vector<vec4>& spheres, const std::vector<uint>& contacts, const View& view);

// Tests of data that a device keeps from one image to the next, or leaves out; the CPU draws every sphere anew.
class DeviceImages : public KernelTest {
 protected:
  void SetUp() override;
};

// The reason why OpenGL's pipeline cannot draw the backend's spheres here; empty if it can.
std::string why_no_pipeline(Backend& backend);

// Draws the backend's spheres and returns the image. The first difference from the expected image as one sentence;
// empty if there is none.
Image image_of(Backend& backend, const View& view, const DrawOptions& options = {});
std::string first_mismatch(const Image& given, const Image& expected, const View& view);

}  // namespace spherepair
