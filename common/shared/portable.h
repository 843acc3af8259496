// SPDX-License-Identifier: MIT
// Spells for C++20, CUDA and GLSL 4.50 what they write differently. Headers that shaders include from this folder use
// the subset that all three share: by-value parameters, struct returns, component arithmetic into EXACT locals. EXACT
// forbids the compiler to contract or reorder; C++ and CUDA get the same from -ffp-contract=off and --fmad=false.
#ifndef SPHEREPAIR_PORTABLE_H
#define SPHEREPAIR_PORTABLE_H

#ifdef GL_core_profile

#define FN
#define RARE_FN
#define EXACT precise
#define UNIFORM_ALIGN  // std140 aligns structs by itself

uint float_bits(float x) { return floatBitsToUint(x); }
float bits_float(uint bits) { return uintBitsToFloat(bits); }
int signed_bits(float x) { return floatBitsToInt(x); }
double bits_double(uint high, uint low) { return packDouble2x32(uvec2(low, high)); }
uint double_high(double x) { return unpackDouble2x32(x).y; }
uint double_low(double x) { return unpackDouble2x32(x).x; }

// Code for any of the number types float, Two and double. It is a template in C++ and CUDA. In GLSL it is plain text,
// for which the compiled program defines Real as one of them.
#define ANY_REAL
#define OF_REAL

// a*b + c, rounded once or twice: only for filters whose error bound covers both.
float multiply_add(float a, float b, float c) { return fma(a, b, c); }

uint count_bits(uint bits) { return uint(bitCount(bits)); }
uint lowest_bit(uint bits) { return uint(findLSB(bits)); }
uint highest_bit(uint bits) { return uint(findMSB(bits)); }

// Return the larger and the smaller; b if a is NaN.
float larger(float a, float b) { return a > b ? a : b; }
float smaller(float a, float b) { return a < b ? a : b; }

#else

#include <bit>
#include <cstdint>

#ifdef __CUDACC__
#define FN __host__ __device__ inline
#define RARE_FN __host__ __device__ __noinline__ inline  // not inlined: saves registers in a kernel's common case
#else
#define FN inline
#define RARE_FN inline
#endif
#define EXACT
#define UNIFORM_ALIGN alignas(16)
#define ANY_REAL template <typename Real>
#define OF_REAL <Real>

using uint = unsigned int;

struct alignas(8) uvec2 {
  uint x, y;
};
struct alignas(16) uvec4 {
  uint x, y, z, w;
};
struct alignas(16) vec4 {
  float x, y, z, w;
};
struct alignas(8) ivec2 {
  int x, y;
};
struct alignas(16) ivec4 {
  int x, y, z, w;
};
struct alignas(32) dvec4 {
  double x, y, z, w;
};

#ifdef __CUDA_ARCH__
FN uint float_bits(float x) { return __float_as_uint(x); }
FN float bits_float(uint bits) { return __uint_as_float(bits); }
FN int signed_bits(float x) { return __float_as_int(x); }
FN double bits_double(uint high, uint low) { return __hiloint2double(int(high), int(low)); }
FN uint double_high(double x) { return uint(__double2hiint(x)); }
FN uint double_low(double x) { return uint(__double2loint(x)); }
FN float multiply_add(float a, float b, float c) { return __fmaf_rn(a, b, c); }
FN uint count_bits(uint bits) { return uint(__popc(bits)); }
FN uint lowest_bit(uint bits) { return uint(__ffs(bits)) - 1u; }
FN uint highest_bit(uint bits) { return 31u - uint(__clz(bits)); }
FN float larger(float a, float b) { return fmaxf(a, b); }
FN float smaller(float a, float b) { return fminf(a, b); }
#else
FN uint float_bits(float x) { return std::bit_cast<uint>(x); }
FN float bits_float(uint bits) { return std::bit_cast<float>(bits); }
FN int signed_bits(float x) { return std::bit_cast<int>(x); }
FN double bits_double(uint high, uint low) { return std::bit_cast<double>(uint64_t(high) << 32 | low); }
FN uint double_high(double x) { return uint(std::bit_cast<uint64_t>(x) >> 32); }
FN uint double_low(double x) { return uint(std::bit_cast<uint64_t>(x)); }
FN float multiply_add(float a, float b, float c) { return a * b + c; }
FN uint count_bits(uint bits) { return uint(std::popcount(bits)); }
FN uint lowest_bit(uint bits) { return uint(std::countr_zero(bits)); }
FN uint highest_bit(uint bits) { return uint(std::bit_width(bits)) - 1u; }
FN float larger(float a, float b) { return a > b ? a : b; }
FN float smaller(float a, float b) { return a < b ? a : b; }
#endif

#endif
#endif
