// SPDX-License-Identifier: MIT
// The colour legend of an image.
#pragma once

#include <string>
#include <vector>

#include "common/scene/camera.h"

namespace spherepair {

// Of the palette's entries: numbers of contacts, or the least speeds or radii; of the first the greatest.
std::vector<std::string> legend_labels(const Look& look);

// Draws it into the lower left corner, in the format of Backend::image(); nothing if the image is too small.
void draw_legend(std::vector<uint>& image, uint width, uint height, const Look& look);

}  // namespace spherepair
