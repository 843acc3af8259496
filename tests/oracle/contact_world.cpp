// SPDX-License-Identifier: MIT
#include "tests/oracle/contact_world.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spherepair {
namespace {

using std::size_t;

using Vector = std::array<Real, 3>;

Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Two spheres, or one and a wall, on the way of each other. normal: from the other to the first.
struct Touch {
  size_t first, second;  // second: number of spheres and more are walls
  Vector normal;
  Real reach, distance, closing, reduced_mass;

  Real overlap() const { return reach - distance; }
};

class Forces {
 public:
  explicit Forces(const OracleWorld& world) : world_(world), n_(world.spheres.size()) {}

  std::vector<Touch> touches(const std::vector<OracleSphere>& spheres) const {
    std::vector<Touch> all;
    for (size_t i = 0; i < n_; ++i) {
      for (size_t j = 0; j < i; ++j) all.push_back(between(spheres, i, j));
      for (size_t w = 0; w < world_.walls.size(); ++w) all.push_back(at_wall(spheres, i, w));
    }
    return all;
  }

  // As the law has it, also where it attracts or nothing touches.
  Real force(const Touch& t) const {
    const Real k = world_.stiffness, depth = t.overlap();
    if (world_.law == OracleLaw::quartic) return k * (t.reach * t.reach - t.distance * t.distance) * t.distance;
    if (world_.law == OracleLaw::hertz) return k * std::copysign(std::pow(std::abs(depth), 1.5L), depth);
    return k * depth + 2 * world_.damping * std::sqrt(k * t.reduced_mass) * t.closing;
  }

  std::vector<bool> pushing(const std::vector<OracleSphere>& spheres) const {
    std::vector<bool> push;
    for (const Touch& t : touches(spheres)) push.push_back(t.overlap() > 0 && force(t) > 0);
    return push;
  }

  // With these contacts, whether or not they would begin or end.
  std::vector<Vector> accelerations(const std::vector<OracleSphere>& spheres, const std::vector<bool>& push) const {
    std::vector<Vector> a;
    for (const OracleSphere& s : spheres)
      a.push_back(
          {-world_.drag * s.velocity[0], world_.gravity - world_.drag * s.velocity[1], -world_.drag * s.velocity[2]});
    const std::vector<Touch> all = touches(spheres);
    for (size_t c = 0; c < all.size(); ++c) {
      if (!push[c]) continue;
      const Touch& t = all[c];
      const Real size = force(t);
      for (size_t k = 0; k < 3; ++k) {
        a[t.first][k] += size * t.normal[k] / oracle_mass(spheres[t.first].radius);
        if (t.second < n_) a[t.second][k] -= size * t.normal[k] / oracle_mass(spheres[t.second].radius);
      }
    }
    return a;
  }

 private:
  Touch between(const std::vector<OracleSphere>& spheres, size_t i, size_t j) const {
    const OracleSphere &a = spheres[i], &b = spheres[j];
    const Real ma = oracle_mass(a.radius), mb = oracle_mass(b.radius);
    Touch t = {i, j, {}, a.radius + b.radius, 0, 0, ma * mb / (ma + mb)};
    Vector v;
    for (size_t k = 0; k < 3; ++k) t.normal[k] = a.at[k] - b.at[k], v[k] = a.velocity[k] - b.velocity[k];
    t.distance = std::sqrt(dot(t.normal, t.normal));
    for (Real& part : t.normal) part /= t.distance;
    t.closing = -dot(t.normal, v);
    return t;
  }
  Touch at_wall(const std::vector<OracleSphere>& spheres, size_t i, size_t w) const {
    const OracleSphere& s = spheres[i];
    const OracleWall& wall = world_.walls[w];
    const Real sign = wall.up ? 1 : -1;
    Touch t = {i,
               n_ + w,
               {},
               s.radius,
               sign * (s.at[wall.axis] - wall.at),
               -sign * s.velocity[wall.axis],
               oracle_mass(s.radius)};
    t.normal[wall.axis] = sign;
    return t;
  }

  const OracleWorld& world_;
  const size_t n_;
};

std::vector<OracleSphere> moved(std::vector<OracleSphere> spheres, const std::vector<OracleSphere>& rates,
                                const std::vector<Vector>& a, Real seconds) {
  for (size_t i = 0; i < spheres.size(); ++i)
    for (size_t k = 0; k < 3; ++k) {
      spheres[i].at[k] += seconds * rates[i].velocity[k];
      spheres[i].velocity[k] += seconds * a[i][k];
    }
  return spheres;
}

std::vector<OracleSphere> stepped(const Forces& forces, const std::vector<OracleSphere>& s1,
                                  const std::vector<bool>& push, Real dt) {
  const auto a1 = forces.accelerations(s1, push);
  const auto s2 = moved(s1, s1, a1, dt / 2);
  const auto a2 = forces.accelerations(s2, push);
  const auto s3 = moved(s1, s2, a2, dt / 2);
  const auto a3 = forces.accelerations(s3, push);
  const auto s4 = moved(s1, s3, a3, dt);
  const auto a4 = forces.accelerations(s4, push);
  return moved(moved(moved(moved(s1, s1, a1, dt / 6), s2, a2, dt / 3), s3, a3, dt / 3), s4, a4, dt / 6);
}

}  // namespace

Real oracle_mass(Real radius) { return 1000 * 4 * std::numbers::pi_v<Real> / 3 * radius * radius * radius; }

// A step in which contacts begin or end is halved until it ends just behind the first of them.
void advance(OracleWorld& world, Real seconds, Real longest_step) {
  const Forces forces(world);
  const Real finest = longest_step * 1e-12L;
  while (seconds > 0) {
    const std::vector<bool> push = forces.pushing(world.spheres);
    Real step = std::min(seconds, longest_step), without = 0;
    std::vector<OracleSphere> next = stepped(forces, world.spheres, push, step);
    if (forces.pushing(next) != push)
      while (step - without > finest) {
        const Real middle = (without + step) / 2;
        std::vector<OracleSphere> there = stepped(forces, world.spheres, push, middle);
        if (forces.pushing(there) == push)
          without = middle;
        else
          step = middle, next = std::move(there);
      }
    world.spheres = std::move(next);
    seconds -= step;
  }
}

OracleStatistics statistics_of(const OracleWorld& world) {
  OracleStatistics sums;
  const Forces forces(world);
  for (const OracleSphere& s : world.spheres) {
    const Real mass = oracle_mass(s.radius);
    sums.kinetic += mass * dot(s.velocity, s.velocity) / 2;
    sums.potential -= mass * world.gravity * (s.at[1] - world.plane);
    for (size_t k = 0; k < 3; ++k) sums.momentum[k] += mass * s.velocity[k];
  }
  for (const Touch& t : forces.touches(world.spheres)) {
    if (t.overlap() <= 0) continue;
    const bool wall = t.second >= world.spheres.size();
    ++(wall ? sums.wall_contacts : sums.contacts);
    sums.greatest_overlap = std::max(sums.greatest_overlap, t.overlap());
    const Real k = world.stiffness, push = std::max(forces.force(t), Real(0));
    if (!wall) sums.virial += push * t.distance;
    if (t.second == world.spheres.size()) sums.floor_force += push;
    if (world.law == OracleLaw::spring) sums.contact += k / 2 * t.overlap() * t.overlap();
    if (world.law == OracleLaw::hertz) sums.contact += k * 0.4L * std::pow(t.overlap(), 2.5L);
    if (world.law == OracleLaw::quartic)
      sums.contact += k / 4 * std::pow(t.reach * t.reach - t.distance * t.distance, 2.0L);
  }
  return sums;
}

OracleDamper damper_for(Real restitution) {
  const auto bounce = [](Real b, Real& seconds) {  // x'' + 2 b x' + x = 0 from x = 0 at speed 1, until its force is 0
    const auto pull = [b](Real x, Real v) { return x + 2 * b * v; };
    const Real h = 1e-3L;
    Real x = 0, v = 1, last = 1;
    for (seconds = 0; pull(x, v) > 0; seconds += h) {
      last = pull(x, v);
      const Real a1 = -last, v2 = v + h / 2 * a1, a2 = -pull(x + h / 2 * v, v2), v3 = v + h / 2 * a2;
      const Real a3 = -pull(x + h / 2 * v2, v3), v4 = v + h * a3, a4 = -pull(x + h * v3, v4);
      x += h / 6 * (v + 2 * v2 + 2 * v3 + v4), v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    seconds -= h * pull(x, v) / (pull(x, v) - last);
    return -v;
  };
  Real low = 0, high = 2, seconds = 0;
  for (int turn = 0; turn < 40 && restitution < 1; ++turn) {
    const Real middle = (low + high) / 2;
    (bounce(middle, seconds) > restitution ? low : high) = middle;
  }
  if (restitution >= 1) return {0, std::numbers::pi_v<Real>};
  bounce(low, seconds);
  return {low, seconds};
}

}  // namespace spherepair
