// SPDX-License-Identifier: MIT
// One system of a list as the host looks through it. Its targets are its points and their images: in float32, around
// the middle of the system, scaled to at most 1. A target's key is the point, then the number of the image, in 32 bits:
// keys in order are pairs in the list's order.
#pragma once

#include <span>

#include "common/cpu/search/cpu_rows.h"
#include "common/lists/list_plan.h"
#include "common/shared/layout.h"

namespace spherepair {

class HostSystem {
 public:
  static constexpr uint no_key = 0xFFFFFFFFu;

  HostSystem(const ListProblem& problem, const ListPlan& plan, size_t b);

  bool fits_keys() const { return fits_; }  // else keys have too few bits
  bool sized() const { return !problem_->set.radii.empty(); }
  uint64_t looking() const { return looking_; }
  uint64_t points() const { return points_; }  // as targets: none where queries look for images
  uint64_t targets() const { return points_ + images_.size(); }
  uint64_t first_looking() const { return first_looking_; }
  const System& range() const { return *range_; }

  // Coordinates, and a share of the reach in w. First the points, then the images.
  vec4 target(uint64_t k) const {
    if (k < points_) return placed(plan_->points()[first_point_ + k], share_of(problem_->set, first_point_ + k));
    const PointImage& image = images_[k - points_];
    return placed(image.place, share_of(problem_->set, image.point));
  }
  uint key(uint64_t k) const { return k < points_ ? key_of(uint(k), own_image_) : key_of_image(images_[k - points_]); }
  bool keys_are_numbers() const { return bits_ == 0 && images_.empty(); }
  vec4 looker(uint64_t i) const {
    return placed(plan_->looking()[first_looking_ + i], share_of(problem_->firsts(), first_looking_ + i));
  }
  RowPoint row_point(uint64_t i, const vec4& at) const {
    if (problem_->asks) return {at.x, at.y, at.z, at.w, 0, no_key};
    const uint own = key_of(uint(i), own_image_);
    return {at.x,
            at.y,
            at.z,
            at.w,
            problem_->half ? own + !problem_->self_pairs : 0,
            problem_->half || problem_->self_pairs ? no_key : own};
  }
  bool is_half() const { return problem_->half; }

  RowLimits limits() const { return limits_; }
  float reach() const { return reach_; }  // no target farther away along an axis is in a row
  // Lengths of the smallest box around all targets; lowest corner.
  float low(size_t axis) const { return -half_[axis]; }
  float high(size_t axis) const { return half_[axis]; }

  uint second_of(uint key) const { return uint(first_point_) + (key >> bits_); }
  ListedPair pair(uint64_t i, uint key) const;
  bool is_within_reach(const ListedPair& pair) const {
    return spherepair::is_within_reach(*problem_, plan_->lattices()[b_].box(), pair);
  }

 private:
  uint key_of(uint point, uint image) const { return uint(uint64_t(point) << bits_) | image; }
  uint image_of(const Shift& shift) const {
    return (uint(shift[0] - lowest_[0]) * sizes_[1] + uint(shift[1] - lowest_[1])) * sizes_[2] +
           uint(shift[2] - lowest_[2]);
  }
  uint key_of_image(const PointImage& image) const {
    return key_of(image.point - uint(first_point_), image_of(image.shift));
  }
  void number_images();
  void set_frame();
  double share_of(const PointSet& set, uint64_t point) const { return radius_of(*problem_, set, point); }
  vec4 placed(const Point3& at, double radius) const {
    return {float((at[0] - middle_[0]) * scale_), float((at[1] - middle_[1]) * scale_),
            float((at[2] - middle_[2]) * scale_), float(radius * scale_)};
  }

  const ListProblem* problem_;
  const ListPlan* plan_;
  const System* range_;
  size_t b_;
  uint64_t first_point_, points_, first_looking_, looking_;
  std::span<const PointImage> images_;
  bool fits_ = true;
  uint bits_ = 0, own_image_ = 0;
  Shift lowest_ = {};
  uint sizes_[3] = {1, 1, 1};
  Point3 middle_ = {};
  double scale_ = 1;
  float half_[3] = {};
  RowLimits limits_ = {};
  float reach_ = 0;
};

}  // namespace spherepair
