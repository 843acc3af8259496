// SPDX-License-Identifier: MIT
#include "common/image/image_samples.h"

namespace spherepair {

void ImageSamples::add(const std::vector<uint>& image) {
  sums_.resize(image.size() * 3);
  for (size_t i = 0; i < sums_.size(); ++i) sums_[i] += image[i / 3] >> (i % 3 * 8) & 255;
  ++count_;
}

std::vector<uint> ImageSamples::mean() const {
  std::vector<uint> mean(sums_.size() / 3, 0xFF000000u);
  for (size_t i = 0; i < sums_.size(); ++i) mean[i / 3] |= (sums_[i] + count_ / 2) / count_ << (i % 3 * 8);
  return mean;
}

}  // namespace spherepair
