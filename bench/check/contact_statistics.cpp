// SPDX-License-Identifier: MIT
#include "bench/check/contact_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/scene/contact_scene.h"
#include "common/shared/contact/contact_rest.h"

namespace spherepair {
namespace {

using Impulse = std::array<int64_t, 3>;

class Sums {
 public:
  Sums(const Scene& scene, const std::vector<uint>& wide, uint64_t step)
      : scene_(scene),
        wide_(wide),
        params_(contact_params(scene)),
        metres_(std::exp2(-scene.contact.unit_exponent)),
        momentum_(std::exp2(-scene.contact.momentum_exponent)),
        impulses_(scene.size()) {
    sums_.step = step;
    sums_.seconds = double(step) * double(scene.dt);
  }

  void add_pair(const Pair& pair) {
    const Body a = load_body(wide_, scene_.positions, pair.first), b = load_body(wide_, scene_.positions, pair.second);
    const Push push = push_of_pair(a, b, params_);
    const Ways way = ways_between(a, b, params_);
    const double d[3] = {metres_ * double(way.x), metres_ * double(way.y), metres_ * double(way.z)};
    const double reach = double(a.radius) + double(b.radius), overlap = reach - std::hypot(d[0], d[1], d[2]);
    if (overlap <= 0) return;  // they collide only after their centres are rounded to float32
    ++sums_.contacts;
    add_overlap(overlap, reach);
    const Impulse impulse = {push.x, push.y, push.z};
    for (uint64_t axis = 0; axis < 3; ++axis) {
      sums_.virial += force(impulse[axis]) * d[axis];
      impulses_[pair.first][axis] += impulse[axis];
      impulses_[pair.second][axis] -= impulse[axis];
    }
  }

  void add_sphere(uint64_t i) {
    const Body s = load_body(wide_, scene_.positions, i);
    const double radius = double(s.radius), mass = sphere_mass(radius);
    const int64_t gaps[6] = {s.x - params_.low_x,  s.y - params_.low_y,  s.z - params_.low_z,
                             params_.high_x - s.x, params_.high_y - s.y, params_.high_z - s.z};
    for (uint wall = 0; wall < 6; ++wall)
      if (const double overlap = radius - metres_ * double(gaps[wall]); overlap > 0 && all_walls(params_) >> wall & 1)
        ++sums_.wall_contacts, add_overlap(overlap, radius);
    if (all_walls(params_) & 2) sums_.floor_force += force(push_of_wall(gaps[1], s.py, s.radius, params_));
    sums_.potential -= mass * double(scene_.gravity) * metres_ * double(s.y - params_.low_y);
    const Push contacts = {impulses_[i][0], impulses_[i][1], impulses_[i][2], FAULTS};
    const Body before = slowed(s, params_), after = kicked(before, contacts, push_of_walls(s, false, params_), params_);
    const double sums[3] = {double(before.px) + double(after.px), double(before.py) + double(after.py),
                            double(before.pz) + double(after.pz)};
    for (uint64_t axis = 0; axis < 3; ++axis) {
      const double momentum = momentum_ * sums[axis] / 2;
      sums_.momentum[axis] += momentum;
      sums_.kinetic += momentum * momentum / (2 * mass);
    }
  }

  ContactStatistics sums() const {
    ContactStatistics sums = sums_;
    for (double* sum : {&sums.kinetic, &sums.contact, &sums.potential, &sums.momentum[0], &sums.momentum[1],
                        &sums.momentum[2], &sums.virial, &sums.floor_force})
      *sum *= times_water(scene_);
    return sums;
  }

 private:
  double force(int64_t impulse) const { return momentum_ * double(impulse) / double(scene_.dt); }
  void add_overlap(double overlap, double reach) {
    const ContactOptions& contact = scene_.contact;
    sums_.contact += contact_energy(contact.law, double(contact.stiffness), overlap, reach);
    sums_.greatest_overlap = std::max(sums_.greatest_overlap, overlap);
  }

  const Scene& scene_;
  const std::vector<uint>& wide_;
  const ContactParams params_;
  const double metres_, momentum_;  // of one unit of length, of momentum
  std::vector<Impulse> impulses_;
  ContactStatistics sums_;
};

}  // namespace

ContactStatistics contact_statistics(const Scene& scene, const std::vector<uint>& wide, std::span<const Pair> pairs,
                                     uint64_t step) {
  Sums sums(scene, wide, step);
  for (const Pair& pair : pairs) sums.add_pair(pair);
  for (uint64_t i = 0; i < scene.size(); ++i) sums.add_sphere(i);
  return sums.sums();
}

std::string statistics_heading() {
  return "step,time_s,kinetic_J,contact_J,potential_J,momentum_x_kg_m_per_s,momentum_y_kg_m_per_s,momentum_z_kg_m_per_"
         "s,"
         "greatest_overlap_m,contacts,wall_contacts,virial_J,floor_force_N\n";
}

std::string statistics_row(const ContactStatistics& row) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", row.step, row.seconds, row.kinetic, row.contact,
                     row.potential, fmt::join(row.momentum, ","), row.greatest_overlap, row.contacts, row.wall_contacts,
                     row.virial, row.floor_force);
}

}  // namespace spherepair
