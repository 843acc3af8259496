// SPDX-License-Identifier: MIT
#include "common/scene/contact/contact_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace spherepair {
namespace {

class Failure {
 public:
  Failure(const FailedStep& step, const ContactParams& params) : step_(step), params_(params) {}

  std::string text(uint kind, uint64_t i) const {
    if (kind == FAULT_DEEP) return deep(i);
    const Body& s = step_.bodies[i];
    if (kind == FAULT_RANGE)
      return fmt::format(
          "sphere {} has left the range of float32 centres and 64-bit positions, at ({:.6g}, {:.6g}, {:.6g}) m: close "
          "the box with --walls, or take fewer steps",
          i, metres(s.x), metres(s.y), metres(s.z));
    const vec4 v = velocity_of(speeds_of(s, mobility_of(s.radius, params_)), params_);
    const double along = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}), most = params_.fastest * unit();
    return fmt::format(
        "sphere {} moves by more than the smallest radius in a step, {:.4g} m of {:.4g} m along an axis, at {:.4g} "
        "m/s: give --dt {:.2g} or less, which has room for {:.3g} times that speed",
        i, along * seconds(), most, std::hypot(v.x, v.y, v.z), roomy_step(along, most),
        most / (roomy_step(along, most) * along));
  }

  double seconds() const { return unit() / double(params_.metres_per_second); }

 private:
  // Returns the longest of 1, 0.5, 0.2, 0.1, ... seconds in which a sphere of this speed moves at most half of the
  // distance allowed.
  static double roomy_step(double speed, double most) {
    const double longest = most / (2 * speed), decade = std::pow(10, std::floor(std::log10(longest)));
    return decade * (longest >= 5 * decade ? 5 : longest >= 2 * decade ? 2 : 1);
  }
  double unit() const { return std::ldexp(1.0, -params_.unit_exponent); }
  double metres(int64_t units) const { return double(units) * unit(); }

  // Returns a sphere at the position where the step's contacts were found.
  Body before(uint64_t i) const {
    Body s = step_.bodies[i];
    const float mobility = mobility_of(s.radius, params_);
    if (fault_of(s, speeds_of(s, mobility), params_) != FAULTS) return s;
    s.x -= scaled(s.px, mobility), s.y -= scaled(s.py, mobility), s.z -= scaled(s.pz, mobility);
    return wrapped(s, params_);
  }

  // Describes the deepest contact of a sphere, relative to the smaller radius.
  std::string deep(uint64_t i) const {
    const Body a = before(i);
    const double radius = double(a.radius);
    const int64_t walls[6] = {a.x - params_.low_x,  a.y - params_.low_y,  a.z - params_.low_z,
                              params_.high_x - a.x, params_.high_y - a.y, params_.high_z - a.z};
    double smaller = radius, overlap = -INFINITY;
    for (uint wall = 0; wall < 6; ++wall)
      if (all_walls(params_) >> wall & 1) overlap = std::max(overlap, radius - metres(walls[wall]));
    std::string in = "a wall";
    for (uint64_t j = 0; j < step_.bodies.size(); ++j) {
      const Body b = before(j);
      const double least = std::min(radius, double(b.radius));
      const Ways way = ways_between(a, b, params_);
      const double enters = radius + double(b.radius) - std::hypot(metres(way.x), metres(way.y), metres(way.z));
      if (j == i || enters * smaller <= overlap * least) continue;
      smaller = least, overlap = enters, in = fmt::format("sphere {}", j);
    }
    return fmt::format(
        "sphere {} is deeper in {} than the smaller radius, {:.4g} m of {:.4g} m: let no spheres overlap that much at "
        "the start, or give a larger --stiffness or a smaller --dt",
        i, in, overlap, smaller);
  }

  const FailedStep& step_;
  const ContactParams& params_;
};

}  // namespace

bool has_faults(const std::vector<uint>& words) {
  return any_fault(words[FAULT_DEEP], words[FAULT_FAST], words[FAULT_RANGE]);
}

void throw_fault(const std::string& backend, const FailedStep& step, const ContactParams& params) {
  const Failure failure(step, params);
  const std::vector<uint>& faults = step.faults;
  const auto kind = uint(std::ranges::find_if(faults, [](uint i) { return i != ~0u; }) - faults.begin());
  const std::string what = fmt::format("{}: contacts cannot go on from step {} of {:.4g} s: {}", backend, step.number,
                                       failure.seconds(), failure.text(kind, faults[kind]));
  throw std::invalid_argument(what);
}

}  // namespace spherepair
