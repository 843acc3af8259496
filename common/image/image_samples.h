// SPDX-License-Identifier: MIT
// The mean of images of one size, sample by sample.
#pragma once

#include <cstddef>
#include <vector>

#include "common/shared/layout.h"

namespace spherepair {

class ImageSamples {
 public:
  void add(const std::vector<uint>& image);  // in the format of Drawing::image()
  uint count() const { return count_; }
  std::vector<uint> mean() const;  // rounded; the order of the samples does not matter

 private:
  std::vector<uint> sums_;  // of the three channels of each pixel
  uint count_ = 0;
};

}  // namespace spherepair
