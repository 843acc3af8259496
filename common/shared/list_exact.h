// SPDX-License-Identifier: MIT
// Whether |x_j - x_i + S H|^2 < c^2 in real arithmetic on float64 numbers as given: a float64 filter with the bound of
// its roundings, then integers. c is a sum of four numbers that is not rounded either.
#ifndef SPHEREPAIR_LIST_EXACT_H
#define SPHEREPAIR_LIST_EXACT_H

#include "common/shared/list.h"

// Of numbers from 2^-450 to 2^450 times 32 bits, and sums of five of these: 900 + 53 + 32 + 3 bits.
#define LIST_WORDS 31

struct ListWide {
  uint word[LIST_WORDS];
};

// A product number * times: words m2, m1 and m0, shifted by `shift` bits, in units of 2^(base - 1075).
struct ListTerm {
  uint m0, m1, m2, shift;
  uint negative;  // not 0
};

FN uint scale_of_double(double x) { return (double_high(x) >> 20) & 2047u; }

FN ListTerm term_of(double number, int times, uint base) {
  ListTerm term = {0u, 0u, 0u, 0u, 0u};
  if (scale_of_double(number) == 0u || times == 0) return term;  // 0
  uint size = times < 0 ? ~uint(times) + 1u : uint(times);
  uint64_t low = uint64_t(double_low(number)) * uint64_t(size);
  uint64_t high = uint64_t((double_high(number) & 0xFFFFFu) | 0x100000u) * uint64_t(size) + (low >> 32);
  term.m0 = uint(low & 0xFFFFFFFFul);
  term.m1 = uint(high & 0xFFFFFFFFul);
  term.m2 = uint(high >> 32);
  term.shift = scale_of_double(number) - base;
  term.negative = (double_high(number) ^ uint(times)) & 0x80000000u;
  return term;
}

FN uint mantissa_word(ListTerm t, uint k) { return k == 0u ? t.m0 : k == 1u ? t.m1 : k == 2u ? t.m2 : 0u; }

// Word k of the term, with its sign.
FN int64_t word_of_term(ListTerm t, uint k) {
  uint first = t.shift >> 5;
  uint bits = t.shift & 31u;
  if (k < first || k > first + 3u) return int64_t(0);
  uint word = mantissa_word(t, k - first) << bits;
  if (bits != 0u && k > first) word |= mantissa_word(t, k - first - 1u) >> (32u - bits);
  return t.negative != 0u ? -int64_t(word) : int64_t(word);
}

// |a + b + c + d + e|
FN ListWide magnitude_of_terms(ListTerm a, ListTerm b, ListTerm c, ListTerm d, ListTerm e, uint words) {
  ListWide sum;
  int64_t carry = int64_t(0);
  for (uint k = 0u; k < words; ++k) {
    carry += word_of_term(a, k) + word_of_term(b, k) + word_of_term(c, k) + word_of_term(d, k) + word_of_term(e, k);
    sum.word[k] = uint(carry & int64_t(0xFFFFFFFFul));
    carry = carry >> 32;
  }
  if (carry < int64_t(0)) {
    uint64_t one = uint64_t(1u);
    for (uint k = 0u; k < words; ++k) {
      one += uint64_t(~sum.word[k]);
      sum.word[k] = uint(one & 0xFFFFFFFFul);
      one = one >> 32;
    }
  }
  return sum;
}

// The sign of x*x + y*y + z*z - c*c. Adds the columns of the squares from low to high, as squares_less() in exact.h
// does with fewer words; the carry out of the top has the sign.
FN int side_of_squares(ListWide x, ListWide y, ListWide z, ListWide c, uint words) {
  int64_t carry = int64_t(0);
  int64_t high = int64_t(0);
  uint rest = 0u;
  for (uint column = 0u; column < 2u * words; ++column) {
    int64_t low = carry + high;
    high = int64_t(0);
    uint first = column < words ? 0u : column - words + 1u;
    uint last = column < words ? column : words - 1u;
    for (uint k = first; k <= last; ++k) {
      uint64_t xx = uint64_t(x.word[k]) * uint64_t(x.word[column - k]);
      uint64_t yy = uint64_t(y.word[k]) * uint64_t(y.word[column - k]);
      uint64_t zz = uint64_t(z.word[k]) * uint64_t(z.word[column - k]);
      uint64_t cc = uint64_t(c.word[k]) * uint64_t(c.word[column - k]);
      low += int64_t(xx & 0xFFFFFFFFul) + int64_t(yy & 0xFFFFFFFFul) + int64_t(zz & 0xFFFFFFFFul) -
             int64_t(cc & 0xFFFFFFFFul);
      high += int64_t(xx >> 32) + int64_t(yy >> 32) + int64_t(zz >> 32) - int64_t(cc >> 32);
    }
    rest |= uint(low & int64_t(0xFFFFFFFFul));
    carry = low >> 32;
  }
  return carry < int64_t(0) ? -1 : rest != 0u ? 1 : 0;
}

struct ListRange {
  uint lowest, highest;
};
FN ListRange with_number(ListRange range, double x) {
  uint scale = scale_of_double(x);
  if (scale == 0u) return range;
  if (scale < range.lowest) range.lowest = scale;
  if (scale > range.highest) range.highest = scale;
  return range;
}

FN ListRange with_row(ListRange range, ListRows row, uint k, int times) {
  if (times == 0) return range;
  return with_number(with_number(with_number(range, row.of[3u * k]), row.of[3u * k + 1u]), row.of[3u * k + 2u]);
}

// |to - from + S H| along an axis, in units of 2^(base - 1075).
FN ListWide way_along(double from, double to, ListRows row, uint axis, int s0, int s1, int s2, uint base, uint words) {
  return magnitude_of_terms(term_of(to, 1, base), term_of(from, -1, base), term_of(row.of[axis], s0, base),
                            term_of(row.of[3u + axis], s1, base), term_of(row.of[6u + axis], s2, base), words);
}

// The sign of |b - a + S H|^2 - c^2 for c = cutoff + skin + both radii.
RARE_FN int list_exact_side(dvec4 a, dvec4 b, ListRows row, int s0, int s1, int s2, double cutoff, double skin) {
  ListRange range = {2047u, 0u};
  range = with_number(with_number(with_number(with_number(range, a.x), a.y), a.z), a.w);
  range = with_number(with_number(with_number(with_number(range, b.x), b.y), b.z), b.w);
  range = with_number(with_number(range, cutoff), skin);
  range = with_row(with_row(with_row(range, row, 0u, s0), row, 1u, s1), row, 2u, s2);
  if (range.highest == 0u) return 0;  // all are 0
  uint base = range.lowest;
  uint words = (range.highest - base + 53u + 32u + 3u + 31u) >> 5;
  ListTerm none = {0u, 0u, 0u, 0u, 0u};
  ListWide x = way_along(a.x, b.x, row, 0u, s0, s1, s2, base, words);
  ListWide y = way_along(a.y, b.y, row, 1u, s0, s1, s2, base, words);
  ListWide z = way_along(a.z, b.z, row, 2u, s0, s1, s2, base, words);
  ListWide c = magnitude_of_terms(term_of(cutoff, 1, base), term_of(skin, 1, base), term_of(a.w, 1, base),
                                  term_of(b.w, 1, base), none, words);
  return side_of_squares(x, y, z, c, words);
}

// A component of b - a + S H, and the sum of its terms' absolute values.
struct ListWay {
  double way, sizes;
};
FN ListWay list_way(double from, double to, double x, double y, double z) {
  EXACT double way = to - from + x + y + z;
  EXACT double sizes = magnitude(to) + magnitude(from) + magnitude(x) + magnitude(y) + magnitude(z);
  ListWay both = {way, sizes};
  return both;
}
FN ListWay list_way_along(double from, double to, ListRows row, uint axis, int s0, int s1, int s2) {
  EXACT double x = double(s0) * row.of[axis];
  EXACT double y = double(s1) * row.of[3u + axis];
  EXACT double z = double(s2) * row.of[6u + axis];
  return list_way(from, to, x, y, z);
}

// Whether b's image by S is within reach of a. Rounding moves a component at most seven times, each time by 2^-53 of
// the sum of its terms' sizes at most: 2^-50 of that sum bounds them all. Squares and their sums are rounded four
// times.
RARE_FN bool list_within_reach(dvec4 a, dvec4 b, ListRows row, int s0, int s1, int s2, double cutoff, double skin,
                               bool inclusive) {
  double tiny = bits_double((1023u - 50u) << 20, 0u);
  ListWay x = list_way_along(a.x, b.x, row, 0u, s0, s1, s2);
  ListWay y = list_way_along(a.y, b.y, row, 1u, s0, s1, s2);
  ListWay z = list_way_along(a.z, b.z, row, 2u, s0, s1, s2);
  EXACT double squared = x.way * x.way + y.way * y.way + z.way * z.way;
  EXACT double off_x = x.sizes * tiny;
  EXACT double off_y = y.sizes * tiny;
  EXACT double off_z = z.sizes * tiny;
  EXACT double error_x = (magnitude(x.way) + magnitude(x.way) + off_x) * off_x;
  EXACT double error_y = (magnitude(y.way) + magnitude(y.way) + off_y) * off_y;
  EXACT double error_z = (magnitude(z.way) + magnitude(z.way) + off_z) * off_z;
  EXACT double reach = cutoff + skin + a.w + b.w;
  EXACT double limit = reach * reach;
  EXACT double error = error_x + error_y + error_z + (squared + limit) * (tiny + tiny);
  EXACT double highest = squared + error;
  EXACT double lowest = squared - error;
  if (highest < limit) return true;
  if (lowest > limit) return false;
  int side = list_exact_side(a, b, row, s0, s1, s2, cutoff, skin);
  return side < 0 || (side == 0 && inclusive);
}

#endif
