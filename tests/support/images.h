// SPDX-License-Identifier: MIT
// The expected image: every sphere tested at every pixel, with nothing skipped.
#pragma once

#include "common/scene/camera.h"
#include "tests/support/backends.h"

namespace spherepair {

struct Image {
  std::vector<uint> image;
  std::vector<uvec2> visible;
};
Image brute_force_image(const std::vector<vec4>& spheres, const std::vector<uint>& contacts, const View& view);

// Suites of what a device keeps from one image to the next, or leaves out; the CPU draws every sphere anew.
class DeviceImages : public BackendTest {
 protected:
  void SetUp() override;
};

// Why OpenGL's pipeline cannot draw its spheres here; empty where it can.
std::string why_no_pipeline(const Backend& backend);

// Draws what the backend holds. The first difference from the expected image as one sentence; empty when there is
// none.
Image image_of(Backend& backend, const View& view, const DrawOptions& options = {});
std::string first_mismatch(const Image& given, const Image& expected, const View& view);

}  // namespace spherepair
