// SPDX-License-Identifier: MIT
#include "common/plan/plan_watch.h"

#include <algorithm>
#include <cmath>

namespace spherepair {
namespace {

constexpr double cells_free = 4;         // cells that spheres may travel ...
constexpr double share_free = 1.0 / 16;  // ... or this share of the longest axis: few of them then leave the grid
constexpr double most_patience = 64;
constexpr double share_outside = 1.0 / 64;  // share of spheres outside the grid from which on new cells pay

// Bounds the speed along any axis, now and later: a fall from the height of the highest sphere may add to it.
double speed_bound(const Scene& scene) {
  double speed = 0, highest = scene.plane;
  for (const vec4& v : scene.velocities)
    speed = std::max({speed, std::abs(double(v.x)), std::abs(double(v.y)), std::abs(double(v.z))});
  for (const vec4& p : scene.positions) highest = std::max(highest, double(p.y));
  return std::sqrt(speed * speed + 2 * std::abs(double(scene.gravity)) * (highest - double(scene.plane)));
}

double longest_axis(const GridPlan& plan) {
  return double(plan.side) * std::max({plan.size[0], plan.size[1], plan.size[2]});
}

// Whether both plans put all but a few spheres into the same cells.
bool alike(const GridPlan& a, const GridPlan& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(double(a.origin[axis]) - double(b.origin[axis])) > 2 * double(a.side)) return false;
    if (std::abs(double(a.size[axis]) - double(b.size[axis])) > 3) return false;
  }
  return std::abs(double(a.side) - double(b.side)) <= 0.1 * double(a.side);
}

}  // namespace

PlanWatch::PlanWatch(const Scene& scene, const GridPlans& plans) : step_(speed_bound(scene) * double(scene.dt)) {
  allow(plans);
}

void PlanWatch::allow(const GridPlans& plans) {
  allowance_ = std::max(cells_free * double(plans.dense.side), share_free * longest_axis(plans.dense));
  travelled_ = 0;
}

bool PlanWatch::worthwhile(const std::vector<vec4>& sample, const GridPlans& plans) {
  bool sparse = false;
  double outside = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = plans.dense.origin[axis], length = double(plans.dense.side) * plans.dense.size[axis];
    double lowest = low + length, highest = low;
    for (const vec4& sphere : sample) {
      const double x = axis == 0 ? sphere.x : axis == 1 ? sphere.y : sphere.z;
      outside += x < low || x > low + length;
      lowest = std::min(lowest, x);
      highest = std::max(highest, x);
    }
    sparse = sparse || (plans.dense.size[axis] > 8 && highest - lowest < length / 2);
  }
  if (sparse || outside > share_outside * double(sample.size())) return true;
  patience_ = std::min(2 * patience_, most_patience);
  allow(plans);
  return false;
}

bool PlanWatch::replan(const std::vector<vec4>& sample, uint64_t n, GridPlans& plans) {
  GridPlans now = plan_grids_anew(plans, sample, n);
  const bool same = alike(plans.dense, now.dense) && plans.chosen == now.chosen;
  patience_ = same ? std::min(2 * patience_, most_patience) : 1;
  if (!same) plans = std::move(now);
  allow(plans);
  return !same;
}

}  // namespace spherepair
