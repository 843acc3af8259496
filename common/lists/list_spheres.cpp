// SPDX-License-Identifier: MIT
#include "common/lists/list_spheres.h"

#include <algorithm>
#include <cmath>

namespace spherepair {

// The systems stand in a cubic grid around 0 whose edge is 1 at most: float32 then moves a coordinate by 2^-26 at
// most, a centre by less than 2^-25. Where that is much for the smallest sphere of a single open system, each sphere
// gets a share of its own: a centre moves by less than 2^-23 of its largest coordinate.
std::vector<vec4> list_spheres(const ListProblem& problem, const ListPlan& plan) {
  const std::vector<System>& systems = plan.ranges();
  double pitch = 0;
  std::vector<Point3> middles(systems.size());
  for (size_t b = 0; b < systems.size(); ++b) {
    const System& system = systems[b];
    if (system.inside.empty()) continue;
    const auto& offsets = problem.firsts().offsets;
    middles[b] = middle_of(std::span(plan.looking()).subspan(offsets[b], offsets[b + 1] - offsets[b]));
    for (size_t axis = 0; axis < 3; ++axis) {
      const double middle = middles[b][axis];
      const double half = std::max(system.inside.high[axis] - middle, middle - system.inside.low[axis]);
      pitch = std::max(pitch, 2 * half + 3 * system.reach + 16 * system.rounded);
    }
  }
  const uint64_t side = uint64_t(std::ceil(std::cbrt(double(systems.size()))));
  const double all = pitch * double(side), scale = all > 0 ? std::exp2(-std::ceil(std::log2(all))) : 1;
  const auto share = [&](const System& system) { return 4 * system.rounded * scale * (1 + 0x1p-40) + 0x1p-25; };
  const bool own_shares = plan.is_open() && systems.size() == 1 && share(systems[0]) > scale * systems[0].least / 64;
  const auto sphere = [&](const Point3& at, uint32_t b, double radius) {
    const uint64_t cell[3] = {b % side, b / side % side, b / side / side};
    float centre[3];
    double farthest = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
      const double from_middle = at[axis] - middles[b][axis];
      centre[axis] = float((from_middle + (double(cell[axis]) - double(side - 1) / 2) * pitch) * scale);
      farthest = std::max(farthest, std::abs(from_middle * scale));
    }
    const double moved = own_shares ? 0x1p-23 * farthest + 0x1p-148 : share(systems[b]);
    const double larger = radius * scale * (1 + 0x1p-40) + moved;
    return vec4{centre[0], centre[1], centre[2], std::nextafter(float(larger), INFINITY)};
  };
  const auto looking = int64_t(problem.firsts().size()), count = looking + int64_t(plan.images().size());
  std::vector<vec4> spheres(static_cast<size_t>(count));
  in_shares(0, count, [&](int64_t begin, int64_t end) {
    for (int64_t i = begin; i < end; ++i)
      if (i < looking) {
        spheres[i] = sphere(plan.looking()[i], plan.systems()[i], radius_of(problem, problem.firsts(), uint64_t(i)));
      } else {
        const PointImage& image = plan.images()[i - looking];
        spheres[i] = sphere(image.place, image.system, radius_of(problem, problem.set, image.point));
      }
  });
  return spheres;
}

}  // namespace spherepair
