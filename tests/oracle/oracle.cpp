// SPDX-License-Identifier: MIT
#include "tests/oracle/oracle.h"

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

namespace spherepair {
namespace {

// mantissa * 2^exponent; a NaN or an infinity has the exponent NOT_FINITE.
constexpr int NOT_FINITE = 1 << 20;
struct Dyadic {
  long mantissa;
  int exponent;
};

Dyadic take_apart(float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  const int field = int(bits >> 23 & 0xFF);
  if (field == 0xFF) return {0, NOT_FINITE};
  const long fraction = long(bits & 0x7FFFFF) + (field > 0 ? 0x800000 : 0);
  return {bits >> 31 ? -fraction : fraction, std::max(field, 1) - 150};
}

// Reused by every decision of a thread, so that GMP allocates only at first.
struct Scratch {
  mpz_t sum[4], term;
  Scratch() {
    for (auto& value : sum) mpz_init2(value, 1280);
    mpz_init2(term, 1280);
  }
  ~Scratch() {
    for (auto& value : sum) mpz_clear(value);
    mpz_clear(term);
  }
};

void set_shifted(mpz_t target, const Dyadic& value, int base) {
  mpz_set_si(target, value.mantissa);
  if (value.mantissa != 0) mpz_mul_2exp(target, target, mp_bitcnt_t(value.exponent - base));
}

using Decided = std::vector<Pair>;

// Each thread gathers its own list; the canonical order comes from sorting at the end.
template <typename Row>
Decided gather(size_t rows, const Row& row) {
  Decided all;
#pragma omp parallel
  {
    Decided mine;
#pragma omp for schedule(dynamic, 16)
    for (size_t i = 0; i < rows; ++i) row(i, mine);
#pragma omp critical
    all.insert(all.end(), mine.begin(), mine.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

bool boxes_may_overlap(const vec4& a, const vec4& b) {
  const double reach = (double(a.w) + double(b.w)) * (1 + 1e-9);
  return std::abs(double(a.y) - double(b.y)) <= reach && std::abs(double(a.z) - double(b.z)) <= reach &&
         std::abs(double(a.x) - double(b.x)) <= reach;
}

// Spheres by slabs of y as wide as the largest diameter, in each of them by x: colliding spheres are in one slab or in
// neighbours. All in float64 with slacks far above its rounding errors.
class Slabs {
 public:
  explicit Slabs(std::span<const vec4> spheres) : spheres_(spheres), order_(spheres.size()), slab_(spheres.size()) {
    double extent = 0;
    for (const vec4& s : spheres) {
      reach_ = std::max(reach_, 2 * double(s.w));
      for (float c : {s.x, s.y}) extent = std::max(extent, std::abs(double(c)));
    }
    reach_ = reach_ * (1 + 1e-6) + extent * 1e-6;
    for (size_t i = 0; i < spheres.size(); ++i)
      slab_[i] = reach_ > 0 ? long(std::floor(double(spheres[i].y) / reach_)) : 0;
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(), [this](uint i, uint j) { return key(i) < key(j); });
  }

  // Calls with each sphere that may collide with the one at this sorted index, every pair once in all.
  template <typename Visit>
  void for_candidates(size_t row, const Visit& visit) const {
    const uint i = order_[row];
    const auto [slab, x] = key(i);
    for (size_t k = row + 1; k < order_.size() && key(order_[k]) <= std::pair(slab, x + reach_); ++k)
      visit(i, order_[k]);
    const std::pair above = {slab + 1, x - reach_};
    auto next = std::lower_bound(order_.begin(), order_.end(), above, [this](uint j, auto to) { return key(j) < to; });
    for (; next != order_.end() && key(*next) <= std::pair(slab + 1, x + reach_); ++next) visit(i, *next);
  }

 private:
  std::pair<long, double> key(uint i) const { return {slab_[i], double(spheres_[i].x)}; }

  std::span<const vec4> spheres_;
  std::vector<uint> order_;
  std::vector<long> slab_;
  double reach_ = 0;
};

}  // namespace

Relation relation(const vec4& a, const vec4& b) {
  thread_local Scratch scratch;
  const std::array<Dyadic, 4> left = {take_apart(a.x), take_apart(a.y), take_apart(a.z), take_apart(a.w)};
  const std::array<Dyadic, 4> right = {take_apart(b.x), take_apart(b.y), take_apart(b.z), take_apart(b.w)};
  int base = NOT_FINITE;
  for (int c = 0; c < 4; ++c) {
    if (left[c].exponent == NOT_FINITE || right[c].exponent == NOT_FINITE) return Relation::nonfinite;
    if (left[c].mantissa != 0) base = std::min(base, left[c].exponent);
    if (right[c].mantissa != 0) base = std::min(base, right[c].exponent);
  }
  for (int c = 0; c < 4; ++c) {
    set_shifted(scratch.sum[c], left[c], base);
    set_shifted(scratch.term, right[c], base);
    (c < 3 ? mpz_sub : mpz_add)(scratch.sum[c], scratch.sum[c], scratch.term);
    mpz_mul(scratch.sum[c], scratch.sum[c], scratch.sum[c]);
  }
  mpz_add(scratch.sum[0], scratch.sum[0], scratch.sum[1]);
  mpz_add(scratch.sum[0], scratch.sum[0], scratch.sum[2]);
  const int sign = mpz_cmp(scratch.sum[0], scratch.sum[3]);
  return sign > 0 ? Relation::apart : sign < 0 ? Relation::overlapping : Relation::tangent;
}

std::vector<Relation> relations(std::span<const vec4> spheres) {
  std::vector<Relation> answers(spheres.size() / 2);
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < answers.size(); ++k) answers[k] = relation(spheres[2 * k], spheres[2 * k + 1]);
  return answers;
}

std::vector<Pair> brute_force_pairs(std::span<const vec4> spheres) {
  return gather(spheres.size(), [&](size_t i, Decided& mine) {
    for (size_t j = i + 1; j < spheres.size(); ++j)
      if (boxes_may_overlap(spheres[i], spheres[j]) && relation(spheres[i], spheres[j]) == Relation::overlapping)
        mine.push_back({uint(i), uint(j)});
  });
}

std::vector<Pair> swept_pairs(std::span<const vec4> spheres) {
  const Slabs slabs(spheres);
  return gather(spheres.size(), [&](size_t row, Decided& mine) {
    slabs.for_candidates(row, [&](uint i, uint j) {
      if (boxes_may_overlap(spheres[i], spheres[j]) && relation(spheres[i], spheres[j]) == Relation::overlapping)
        mine.push_back({std::min(i, j), std::max(i, j)});
    });
  });
}

std::vector<Pair> within_groups(std::span<const Pair> pairs, uint block) {
  std::vector<Pair> kept;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(kept),
               [block](const Pair& pair) { return pair.first / block == pair.second / block; });
  return kept;
}

}  // namespace spherepair
