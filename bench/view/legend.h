// SPDX-License-Identifier: MIT
// The key to the colours of a picture.
#pragma once

#include <vector>

#include "common/scene/camera.h"

namespace spherepair {

// Into the lower left corner of an image as Backend::image() gives it; nothing where the image is too small for it.
void draw_legend(std::vector<uint>& image, uint width, uint height, const Look& look);

}  // namespace spherepair
