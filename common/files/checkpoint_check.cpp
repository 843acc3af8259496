// SPDX-License-Identifier: MIT
#include "common/files/checkpoint_check.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "common/cpu/cpu_motion.h"
#include "common/scene/contact_scene.h"
#include "common/scene/counted.h"
#include "common/scene/scene_params.h"
#include "common/shared/contact/contact.h"

namespace spherepair {
namespace {

constexpr uint64_t many = 1 << 16;                  // spheres from which several threads are used
constexpr uint64_t most_steps = uint64_t(1) << 53;  // of --steps

bool is_finite(float x) { return std::isfinite(x); }
bool is_finite(double x) { return std::isfinite(x); }
bool is_finite(Two x) { return std::isfinite(x.hi) && std::isfinite(x.lo); }
bool is_finite(const vec4& v) { return is_finite(v.x) && is_finite(v.y) && is_finite(v.z) && is_finite(v.w); }

bool same(float a, float b) { return a == b; }
bool same(double a, double b) { return a == b; }
bool same(Two a, Two b) { return a.hi == b.hi && a.lo == b.lo; }
bool same(const vec4& a, const vec4& b) { return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w; }

std::string text(const vec4& v) { return fmt::format("({}, {}, {}; {})", v.x, v.y, v.z, v.w); }

class Checker {
 public:
  Checker(const Checkpoint& checkpoint, const std::string& file)
      : scene_(checkpoint.scene), motion_(checkpoint.motion), step_(checkpoint.step), n_(scene_.size()), file_(file) {}

  void check() const {
    check_header();
    check_vectors("positions", scene_.positions);
    check_vectors("velocities", scene_.velocities);
    check_vectors("anchors", motion_.anchors);
    check_radii();
    if (scene_.motion.precision == Precision::fixed) return check_fixed();
    with_real(scene_.motion.precision, [&](auto kind) {
      using Real = decltype(kind);
      check_reals<Real>("wide state", motion_.wide);
      check_reals<Real>("flights", motion_.flights);
      if (anchored()) check_anchors<Real>();
      if (anchored() || !motion_.wide.empty()) check_state<Real>();
    });
  }

 private:
  bool anchored() const { return scene_.motion.method == MotionMethod::anchored; }

  [[noreturn]] void fail(const std::string& where, const std::string& expected, const std::string& found) const {
    throw std::invalid_argument(fmt::format("{}, {}: expected {}, found {}", file_, where, expected, found));
  }

  // Calls fail_at(i) for the first i < count with wrong(i).
  template <typename Wrong, typename Fail>
  void refuse(uint64_t count, Wrong wrong, Fail fail_at) const {
    uint64_t first = count;
#pragma omp parallel for schedule(static) reduction(min : first) if (count > many)
    for (uint64_t i = 0; i < count; ++i)
      if (wrong(i)) first = std::min(first, i);
    if (first < count) fail_at(first);
  }

  void check_header() const {
    const std::string unmovable = why_unmovable(scene_, Origin::resumed);
    if (!unmovable.empty()) throw std::invalid_argument(fmt::format("{}, header: {}", file_, unmovable));
    if (step_ > most_steps) fail("header", fmt::format("at most {} steps", most_steps), fmt::format("{}", step_));
    const uint64_t wanted = anchored() ? step_ : 0;
    if (motion_.steps != wanted)
      fail("header", counted(wanted, "step") + " that the motion counts", fmt::format("{}", motion_.steps));
  }

  void check_vectors(const char* part, const std::vector<vec4>& vectors) const {
    refuse(
        vectors.size(), [&](uint64_t i) { return !is_finite(vectors[i]); },
        [&](uint64_t i) { fail(fmt::format("{}, sphere {}", part, i), "finite numbers", text(vectors[i])); });
  }

  template <typename Real>
  void check_reals(const char* part, const std::vector<uint>& words) const {
    refuse(
        words.size() * sizeof(uint) / sizeof(Real), [&](uint64_t k) { return !is_finite(load_real<Real>(words, k)); },
        [&](uint64_t k) {
          fail(fmt::format("{}, sphere {}", part, k % n_), "finite numbers",
               fmt::format("{}", nearest(load_real<Real>(words, k))));
        });
  }

  void check_radii() const {
    const auto radius = [&](uint64_t i) { return scene_.positions[i].w; };
    const auto wrong = [&](uint64_t i) { return radius(i) < 0 || (scene_.equal_radii && radius(i) != radius(0)); };
    refuse(n_, wrong, [&](uint64_t i) {
      fail(fmt::format("positions, sphere {}", i),
           radius(i) < 0 ? "a radius of at least 0"
                         : fmt::format("the radius {}, as all are said to be equal", radius(0)),
           fmt::format("{}", radius(i)));
    });
  }

  // The anchor of a sphere is at step 0 until a bounce sets a new one.
  template <typename Real>
  void check_anchors() const {
    const MotionParams params = motion_params(scene_);
    refuse(
        n_,
        [&](uint64_t i) {
          const uint since = motion_.since[i];
          return since & ANCHOR_ON_PLANE ? (since & ~ANCHOR_ON_PLANE) > motion_.steps : since != 0;
        },
        [&](uint64_t i) {
          fail(fmt::format("steps of the anchors, sphere {}", i),
               fmt::format("a bounce by step {}, or none", motion_.steps), fmt::format("{:#x}", motion_.since[i]));
        });
    const auto expected = [&](uint64_t i) {
      return next_event_step(anchor_of<Real>(motion_, scene_.velocities[i], i), params);
    };
    refuse(
        n_, [&](uint64_t i) { return motion_.next_event[i] != expected(i); },
        [&](uint64_t i) {
          fail(fmt::format("due steps, sphere {}", i), fmt::format("{}, by its anchor", expected(i)),
               fmt::format("{}", motion_.next_event[i]));
        });
  }

  // Before the first step the float32 numbers are those of the scene, which can be finer than a unit.
  void check_fixed_start() const {
    const std::vector<uint> made = fixed_state(scene_);
    const uint64_t parts = scene_.contact.drag > 0 ? 3 : 6;  // with drag, program versions begin with different momenta
    const auto wrong = [&](uint64_t i) {
      for (uint64_t k = 0; k < parts; ++k)
        if (load_real<int64_t>(motion_.wide, k * n_ + i) != load_real<int64_t>(made, k * n_ + i)) return true;
      return false;
    };
    refuse(n_, wrong, [&](uint64_t i) {
      fail(fmt::format("wide state, sphere {}", i), "the integers made from its position and velocity",
           "other integers: the file was changed or is damaged");
    });
  }

  // Positions and velocities are the float32 numbers nearest to the integers.
  void check_fixed() const {
    if (step_ == 0) return check_fixed_start();
    const ContactParams params = contact_params(scene_);
    const auto body = [&](uint64_t i) -> Body {
      const auto word = [&](uint64_t k) { return load_real<int64_t>(motion_.wide, k * n_ + i); };
      return {word(0), word(1), word(2), word(3), word(4), word(5), scene_.positions[i].w};
    };
    const auto wrong = [&](uint64_t i) {
      const Body s = body(i);
      const vec4& v = scene_.velocities[i];
      if (!same(scene_.positions[i], centre_of(s, params))) return true;
      return !same(v, velocity_of(speeds_of(s, mobility_of(s.radius, params)), params));
    };
    refuse(n_, wrong, [&](uint64_t i) {
      fail(fmt::format("wide state, sphere {}", i), "integers nearest to which its position and velocity are",
           text(centre_of(body(i), params)));
    });
  }

  // Positions and velocities are the float32 numbers nearest to the motion's full-precision state.
  template <typename Real>
  void check_state() const {
    MotionParams params = motion_params(scene_);
    params.steps_done = motion_.steps;
    const auto wide = [&](uint64_t k, uint64_t i) { return load_real<Real>(motion_.wide, k * n_ + i); };
    const auto evaluated = [&](uint64_t i) -> Moving<Real> {
      if (anchored()) return evaluate_sphere(anchor_of<Real>(motion_, scene_.velocities[i], i), params);
      return {wide(0, i), wide(1, i), wide(2, i), wide(3, i), wide(4, i), wide(5, i), scene_.positions[i].w};
    };
    const char* by = anchored() ? "anchors and flights" : "wide state";
    const auto position = [](const Moving<Real>& s) {
      return vec4{nearest(s.x), nearest(s.y), nearest(s.z), s.radius};
    };
    const auto velocity = [](const Moving<Real>& s) { return vec4{nearest(s.vx), nearest(s.vy), nearest(s.vz), 0}; };
    const auto compare = [&](const char* part, const std::vector<vec4>& given, auto of) {
      refuse(
          n_,
          [&](uint64_t i) {
            const vec4& v = given[i];
            return !same({snap(v.x), snap(v.y), snap(v.z), v.w}, of(evaluated(i)));
          },
          [&](uint64_t i) {
            fail(fmt::format("{}, sphere {}", part, i), fmt::format("{} by the {}", text(of(evaluated(i))), by),
                 text(given[i]));
          });
    };
    compare("positions", scene_.positions, position);
    compare("velocities", scene_.velocities, velocity);
    if (motion_.wide.empty()) return;
    refuse(
        n_,
        [&](uint64_t i) {
          const Moving<Real> s = evaluated(i);
          const std::array<Real, 6> parts = {s.x, s.y, s.z, s.vx, s.vy, s.vz};
          for (uint64_t k = 0; k < 6; ++k)
            if (!same(wide(k, i), parts[k])) return true;
          return false;
        },
        [&](uint64_t i) {
          fail(fmt::format("wide state, sphere {}", i), fmt::format("the value of the {}", by), "another");
        });
  }

  const Scene& scene_;
  const MotionState& motion_;
  uint64_t step_, n_;
  const std::string& file_;
};

}  // namespace

void check_contents(const Checkpoint& checkpoint, const std::string& file) { Checker(checkpoint, file).check(); }

}  // namespace spherepair
