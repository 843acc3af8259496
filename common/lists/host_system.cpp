// SPDX-License-Identifier: MIT
#include "common/lists/host_system.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace spherepair {

HostSystem::HostSystem(const ListProblem& problem, const ListPlan& plan, size_t b)
    : problem_(&problem), plan_(&plan), range_(&plan.ranges()[b]), b_(b) {
  const std::vector<uint64_t>&points = problem.set.offsets, &looking = problem.firsts().offsets;
  first_point_ = points[b], points_ = problem.asks ? 0 : points[b + 1] - points[b];
  first_looking_ = looking[b], looking_ = looking[b + 1] - looking[b];
  const auto from = [&](uint64_t point) {
    return std::ranges::lower_bound(plan.images(), point, {}, [](const PointImage& image) { return image.point; });
  };
  images_ = {from(points[b]), from(points[b + 1])};
  number_images();
  set_frame();
}

void HostSystem::number_images() {
  Shift highest = {};
  for (const PointImage& image : images_)
    for (size_t k = 0; k < 3; ++k)
      lowest_[k] = std::min(lowest_[k], image.shift[k]), highest[k] = std::max(highest[k], image.shift[k]);
  double images = 1;
  for (size_t k = 0; k < 3; ++k) {
    sizes_[k] = uint(highest[k] - lowest_[k]) + 1;
    images *= sizes_[k];
  }
  const uint64_t points = problem_->set.offsets[b_ + 1] - first_point_;
  fits_ = images <= 0x1p31;
  if (!fits_) return;
  bits_ = uint(std::bit_width(uint64_t(images) - 1));
  fits_ = double(points) * std::ldexp(1, int(bits_)) < 0x1p32;  // one is no_key
  own_image_ = image_of({});
}

// Coordinates are below 1 in size, so float32 moves each by 2^-25 at most, and their difference by 2^-24 more. Along
// with `rounded` a distance d near its reach c is then off by e = 2^-22 + 4 rounded at most, d^2 by e (2c + e), and
// float32 rounds d^2 and c^2 by less than 2^-20 (c + e)^2 in all.
void HostSystem::set_frame() {
  if (range_->inside.empty()) return;
  double largest = 0;
  Point3 half;
  for (size_t axis = 0; axis < 3; ++axis) {
    middle_[axis] = range_->inside.low[axis] / 2 + range_->inside.high[axis] / 2;
    half[axis] = range_->inside.high[axis] / 2 - range_->inside.low[axis] / 2;
    if (!images_.empty()) half[axis] += range_->reach;
    half[axis] += 16 * range_->rounded;
    largest = std::max({largest, half[axis], range_->reach});
  }
  if (largest > 0) scale_ = std::ldexp(1, -(std::ilogb(largest) + 2));
  for (size_t axis = 0; axis < 3; ++axis) half_[axis] = float(half[axis] * scale_);
  const double reach = range_->reach * scale_, error = 0x1p-22 + 4 * range_->rounded * scale_, far = reach + error;
  const double tolerance = far * (2 * error + far * 0x1p-19), square = sized() ? 0 : reach * reach;
  limits_ = {float(square + tolerance), float(square - tolerance), sized()};
  reach_ = float(std::sqrt(reach * reach + tolerance) * (1 + 0x1p-16) + 0x1p-22);
}

ListedPair HostSystem::pair(uint64_t i, uint key) const {
  const uint first = uint(first_looking_ + i), second = second_of(key);
  uint image = key & ((1u << bits_) - 1);
  Shift shift = {};
  if (bits_ != 0 && image != own_image_) {
    shift[2] = lowest_[2] + int32_t(image % sizes_[2]), image /= sizes_[2];
    shift[1] = lowest_[1] + int32_t(image % sizes_[1]), image /= sizes_[1];
    shift[0] = lowest_[0] + int32_t(image);
  }
  return {first, second, plan_->shift_of(first, second, shift)};
}

}  // namespace spherepair
