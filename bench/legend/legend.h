// SPDX-License-Identifier: MIT
// The legend of an image: the meaning of its colours, and facts about it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/image/colouring.h"
#include "common/scene/camera.h"

namespace spherepair {

// Labels of the palette's entries: numbers of contacts, or the least speed or radius of each; for the first entry the
// greatest.
std::vector<std::string> legend_labels(const Look& look);

Legend legend_of(const Look& look, const std::vector<std::string>& facts);  // of contacts, speeds or radii

// A white strip below an image, so that the legend covers none of it.
class LegendStrip {
 public:
  // A strip as high as this legend needs in an image of this size; none if less than half would be left for the
  // spheres.
  static std::optional<LegendStrip> within(const Legend& widest, uint width, uint height);
  uint height() const { return height_; }

  // Adds it to an image of this width, in the format of Drawing::image().
  void append_to(std::vector<uint>& image, const Legend& legend) const;

 private:
  LegendStrip(double size, uint width, uint height) : size_(size), width_(width), height_(height) {}
  double size_;  // of the letters' em, pixels
  uint width_, height_;
};

}  // namespace spherepair
