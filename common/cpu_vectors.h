// SPDX-License-Identifier: MIT
// Vectors of floats of each instruction set under the same names. Fused operations are named here, so the files that
// use them need no contraction; where there are none, the filters' bounds cover separate rounding alike.
#pragma once

#include "portable.h"

#ifdef __x86_64__
#include <immintrin.h>

#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx2,fma")
namespace spherepair::avx512 {
using Floats = __m512;
constexpr uint lanes = 16;
inline Floats load(const float* p) { return _mm512_loadu_ps(p); }
inline Floats spread(float x) { return _mm512_set1_ps(x); }
inline Floats fused(Floats a, Floats b, Floats c) { return _mm512_fmadd_ps(a, b, c); }
}  // namespace spherepair::avx512
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx2,fma")
namespace spherepair::avx2 {
using Floats = __m256;
constexpr uint lanes = 8;
inline Floats load(const float* p) { return _mm256_loadu_ps(p); }
inline Floats spread(float x) { return _mm256_set1_ps(x); }
inline Floats fused(Floats a, Floats b, Floats c) { return _mm256_fmadd_ps(a, b, c); }
}  // namespace spherepair::avx2
#pragma GCC pop_options
#endif

namespace spherepair::portable {
typedef float Floats __attribute__((vector_size(16)));
typedef int Ints __attribute__((vector_size(16)));
constexpr uint lanes = 4;
inline Floats load(const float* p) { return Floats{p[0], p[1], p[2], p[3]}; }
inline Floats spread(float x) { return Floats{x, x, x, x}; }
inline Floats fused(Floats a, Floats b, Floats c) { return a * b + c; }
}  // namespace spherepair::portable
