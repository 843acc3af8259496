// SPDX-License-Identifier: MIT
#include "tests/oracle/adversarial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace spherepair {
namespace {

using Inputs = std::array<float, 8>;  // x y z r of one sphere, then of the other

void nudge_one(Inputs& inputs, Random& random, int most) {
  const int ulps = random.between(1, most) * int(random.sign());
  float& input = inputs[random.below(8)];
  input = nudged(input, ulps);
}

void permute_axes(Inputs& inputs, Random& random) {
  for (int c = 2; c > 0; --c) {
    const int other = random.between(0, c);
    std::swap(inputs[c], inputs[other]);
    std::swap(inputs[4 + c], inputs[4 + other]);
  }
}

Inputs scaled(Inputs inputs, int exponent) {
  for (float& input : inputs) input = std::ldexp(input, exponent);
  return inputs;
}

// Half with all bits random, half with exponents so close that the answer is open.
Inputs random_bits(Random& random) {
  Inputs inputs;
  const bool close = random.next() >> 63;
  const uint exponent = uint(random.below(246)) + 1;
  for (float& input : inputs) {
    uint bits = uint(random.next());
    if (close) bits = (bits & 0x807FFFFFu) | (exponent + uint(random.below(8))) << 23;
    input = bits_float(bits);
  }
  return inputs;
}

Inputs tangent_in_box(Random& random, double box) {
  double direction[3], norm = 0;
  do {
    norm = 0;
    for (double& c : direction) {
      c = random.uniform(-1, 1);
      norm += c * c;
    }
  } while (norm < 0.01 || norm > 1);
  Inputs inputs;
  inputs[3] = float(random.uniform(0.1, 1));
  inputs[7] = float(random.uniform(0.1, 1));
  const double reach = (double(inputs[3]) + double(inputs[7])) / std::sqrt(norm);
  for (int c = 0; c < 3; ++c) {
    inputs[c] = float(random.uniform(-box, box));
    inputs[4 + c] = float(double(inputs[c]) + direction[c] * reach);
  }
  return inputs;
}

Inputs near_tangent(Random& random) {
  static constexpr std::array<double, 3> boxes = {8, 1e4, 1e6};
  Inputs inputs = tangent_in_box(random, boxes[random.below(3)]);
  nudge_one(inputs, random, 8);
  return inputs;
}

// x^2 + y^2 + z^2 = d^2 by Euler's parametrisation; all inputs are integers below 2^23.
Inputs integer_quadruple(Random& random) {
  static constexpr std::array<int, 3> limits = {8, 60, 900};
  const int limit = limits[random.below(3)];
  const int64_t m = random.between(1, limit), n = random.between(0, limit);
  const int64_t p = random.between(0, limit), q = random.between(0, limit);
  const int64_t side[3] = {m * m + n * n - p * p - q * q, 2 * (m * q + n * p), 2 * (n * q - m * p)};
  const int64_t reach = m * m + n * n + p * p + q * q;
  const int64_t radius = int64_t(random.below(uint64_t(reach) + 1));
  Inputs inputs;
  for (int c = 0; c < 3; ++c) {
    const int64_t from = random.between(-(1 << 21), 1 << 21);
    inputs[c] = float(from);
    inputs[4 + c] = float(from + side[c] * int64_t(random.sign()));
  }
  inputs[3] = float(radius);
  inputs[7] = float(reach - radius);
  permute_axes(inputs, random);
  return inputs;
}

Inputs quadruple(Random& random) {
  const Inputs inputs = integer_quadruple(random);
  return scaled(inputs, random.between(-149, 100));
}

Inputs quadruple_off(Random& random) {
  Inputs inputs = quadruple(random);
  nudge_one(inputs, random, 1);
  return inputs;
}

Inputs denormal(Random& random) {
  Inputs inputs;
  if (random.next() >> 63) {
    const uint kept_bits = uint(random.below(20)) + 3;
    for (float& input : inputs) input = bits_float(uint(random.below(1u << kept_bits)) | uint(random.next() & 1) << 31);
    return inputs;
  }
  inputs = scaled(integer_quadruple(random), -149);
  if (random.next() >> 63) nudge_one(inputs, random, 2);
  return inputs;
}

Inputs extreme(Random& random) {
  Inputs inputs;
  switch (random.below(4)) {
    case 0:  // the squared sum of radii between 2^124 and 2^132
      inputs = integer_quadruple(random);
      inputs = scaled(inputs, random.between(62, 66) - std::ilogb(inputs[3] + inputs[7]));
      break;
    case 1:
      inputs = scaled(tangent_in_box(random, 8), random.between(61, 66));
      break;
    case 2:
      inputs = scaled(tangent_in_box(random, 8), random.between(-115, -45));
      break;
    default:  // differences themselves overflow
      for (float& input : inputs) input = bits_float(0x7E800000u + uint(random.below(0x1000000u))) * random.sign();
  }
  if (random.next() >> 63) nudge_one(inputs, random, 2);
  return inputs;
}

// The offset turns the tie into a miss (perpendicular to the axis), a hit (along it, or in a radius) or, twice, a tie
// again. Half the pairs have it around 2^-140; in the others both sizes vary, so that integers of every width are
// needed.
Inputs axis_offset(Random& random) {
  const bool varied = random.next() >> 63;
  const int scale = varied ? random.between(-20, 120) : 0;
  const float left = float(random.uniform(0.5, 1)), right = float(random.uniform(0.5, 1));
  const float reach = std::ldexp(left + right, scale), rest = std::ldexp((left + right) - right, scale);
  const float tiny = std::ldexp(float(random.between(1, 511)), varied ? random.between(-149, -80) : -149);
  Inputs inputs = {0, 0, 0, rest, reach, 0, 0, std::ldexp(right, scale)};
  switch (random.below(4)) {
    case 0:
      inputs[5] = tiny * random.sign();
      break;
    case 1:
      inputs[0] = tiny * random.sign();
      break;
    case 2:
      inputs = {0, 0, 0, tiny, reach, 0, 0, reach};
      break;
    default:
      inputs = {-tiny, 0, 0, tiny, reach, 0, 0, reach};
  }
  permute_axes(inputs, random);
  return inputs;
}

// An integer of up to 48 bits as the difference, or sum, of two floats.
void set_difference(Inputs& inputs, int c, uint64_t value, float sign) {
  inputs[c] = float(value >> 24) * 0x1p24f;
  inputs[4 + c] = sign * float(value & 0xFFFFFFu);
}

// x^2 + y^2 next to r^2, where y is the root of r^2 - x^2 rounded down or up: so close that float64 sees no difference.
Inputs beyond_double(Random& random) {
  const uint64_t x = (1ul << 46) + random.below(1ul << 46), more = 1 + random.below(1 << 12);
  const uint64_t square = more * (2 * x + more);  // r^2 - x^2 for r = x + more
  uint64_t y = uint64_t(std::sqrt(double(square)));
  while (y * y >= square) --y;
  while ((y + 1) * (y + 1) < square) ++y;
  Inputs inputs{};
  set_difference(inputs, 0, x, -1);
  set_difference(inputs, 1, y + (random.next() >> 63), -1);
  set_difference(inputs, 3, x + more, 1);
  permute_axes(inputs, random);
  return scaled(inputs, random.between(-100, 10));
}

Inputs nonfinite(uint64_t index) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float apart = (index / 390625) % 2 == 0 ? 0.25f : 4.0f;
  Inputs inputs = {0.5f, -1, 2, 0.5f, 0.5f + apart, -1, 2, 0.5f};
  for (float& input : inputs) {
    const std::array<float, 5> kinds = {input, infinity, -infinity, bits_float(0x7FC00000u), bits_float(0xFFA00001u)};
    input = kinds[index % 5];
    index /= 5;
  }
  return inputs;
}

Inputs make_inputs(Family family, uint64_t index) {
  Random random(index * 16 + uint64_t(family));
  switch (family) {
    case Family::random_bits:
      return random_bits(random);
    case Family::near_tangent:
      return near_tangent(random);
    case Family::quadruple:
      return quadruple(random);
    case Family::quadruple_off:
      return quadruple_off(random);
    case Family::denormal:
      return denormal(random);
    case Family::extreme:
      return extreme(random);
    case Family::axis_offset:
      return axis_offset(random);
    case Family::beyond_double:
      return beyond_double(random);
    default:
      return nonfinite(index);
  }
}

}  // namespace

float nudged(float x, int ulps) {
  const uint bits = float_bits(x);
  int place = bits >> 31 ? -int(bits & 0x7FFFFFFFu) : int(bits);
  place = std::clamp(place + ulps, -0x7F7FFFFF, 0x7F7FFFFF);
  return bits_float(place < 0 ? uint(-place) | 0x80000000u : uint(place));
}

std::vector<vec4> adversarial_pairs(Family family, uint64_t first, uint64_t count) {
  std::vector<vec4> spheres(2 * count);
#pragma omp parallel for schedule(static)
  for (uint64_t k = 0; k < count; ++k) {
    const Inputs in = make_inputs(family, first + k);
    spheres[2 * k] = {in[0], in[1], in[2], in[3]};
    spheres[2 * k + 1] = {in[4], in[5], in[6], in[7]};
  }
  return spheres;
}

}  // namespace spherepair
