// SPDX-License-Identifier: MIT
#include "tests/oracle/reference_motion.h"

#include <gmp.h>

#include <algorithm>
#include <cmath>

namespace spherepair {
namespace {

class GmpRational {
 public:
  GmpRational(float value = 0) {
    mpq_init(value_);
    mpq_set_d(value_, value);
  }
  GmpRational(const GmpRational& other) : GmpRational() { mpq_set(value_, other.value_); }
  GmpRational& operator=(const GmpRational& other) {
    mpq_set(value_, other.value_);
    return *this;
  }
  ~GmpRational() { mpq_clear(value_); }
  friend GmpRational operator+(GmpRational a, const GmpRational& b) {
    mpq_add(a.value_, a.value_, b.value_);
    return a;
  }
  friend GmpRational operator-(GmpRational a, const GmpRational& b) {
    mpq_sub(a.value_, a.value_, b.value_);
    return a;
  }
  friend GmpRational operator*(GmpRational a, const GmpRational& b) {
    mpq_mul(a.value_, a.value_, b.value_);
    return a;
  }
  int sign() const { return mpq_sgn(value_); }
  float nearest() const;

 private:
  mpq_t value_;
};

// The quotient is scaled so that its integer part has the float's 24 bits (fewer for denormals); what is left of it
// decides the rounding, ties to even.
float GmpRational::nearest() const {
  if (sign() == 0) return 0;
  long exponent = long(mpz_sizeinbase(mpq_numref(value_), 2)) - long(mpz_sizeinbase(mpq_denref(value_), 2)) - 24;
  mpz_t numerator, denominator, quotient, rest;
  mpz_inits(numerator, denominator, quotient, rest, nullptr);
  for (exponent = std::max(exponent, -149L);; ++exponent) {
    mpz_abs(numerator, mpq_numref(value_));
    mpz_set(denominator, mpq_denref(value_));
    if (exponent < 0) mpz_mul_2exp(numerator, numerator, mp_bitcnt_t(-exponent));
    if (exponent > 0) mpz_mul_2exp(denominator, denominator, mp_bitcnt_t(exponent));
    mpz_fdiv_qr(quotient, rest, numerator, denominator);
    if (mpz_sizeinbase(quotient, 2) <= 24) break;
  }
  mpz_mul_2exp(rest, rest, 1);
  const int half = mpz_cmp(rest, denominator);
  unsigned long digits = mpz_get_ui(quotient);
  if (half > 0 || (half == 0 && digits % 2 == 1)) ++digits;
  mpz_clears(numerator, denominator, quotient, rest, nullptr);
  return std::ldexp(sign() < 0 ? -float(digits) : float(digits), int(exponent));
}

float snapped(float x) { return std::abs(x) < 0x1p-64f ? 0.0f : x; }

float advanced(float position, float velocity, float dt, float term) {
  const float travelled = (GmpRational(velocity) * dt).nearest();
  const float moved = (GmpRational(position) + travelled).nearest();
  return snapped((GmpRational(moved) + term).nearest());
}

}  // namespace

MotionParams reference_params(const Scene& scene) {
  MotionParams params = {};
  params.dt = scene.dt;
  params.gravity_dt.x = scene.gravity * scene.dt;
  params.half_gravity_dt2.x = 0.5f * scene.gravity * scene.dt * scene.dt;
  params.restitution = scene.restitution;
  params.plane = scene.plane;
  return params;
}

Moved step_rational(vec4 position, vec4 velocity, const MotionParams& m) {
  Moved next = {position, velocity};
  next.position.x = advanced(position.x, velocity.x, m.dt, 0);
  next.position.y = advanced(position.y, velocity.y, m.dt, m.half_gravity_dt2.x);
  next.position.z = advanced(position.z, velocity.z, m.dt, 0);
  next.velocity.x = snapped(velocity.x);
  next.velocity.y = snapped((GmpRational(velocity.y) + m.gravity_dt.x).nearest());
  next.velocity.z = snapped(velocity.z);
  if ((GmpRational(next.position.y) - position.w - m.plane).sign() < 0) {
    next.velocity.y = snapped(-(GmpRational(velocity.y) * m.restitution).nearest());
    next.position.y = advanced(position.y, next.velocity.y, m.dt, m.half_gravity_dt2.x);
  }
  return next;
}

Moved step_paper(vec4 position, vec4 velocity, const MotionParams& params) {
  const Moving<float> from = {position.x, position.y, position.z, velocity.x, velocity.y, velocity.z, position.w};
  const Moving<float> next = move_paper(from, params);
  return {{next.x, next.y, next.z, next.radius}, {next.vx, next.vy, next.vz, 0}};
}

void step_all(const Scene& scene, Motion::State& state) {
  const MotionParams params = reference_params(scene);
  for (size_t i = 0; i < state.positions.size(); ++i) {
    const Moved next = step_paper(state.positions[i], state.velocities[i], params);
    state.positions[i] = next.position;
    state.velocities[i] = next.velocity;
  }
}

}  // namespace spherepair
