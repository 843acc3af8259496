// SPDX-License-Identifier: MIT
// Gives vectors of floats of each instruction set the same names. Fused operations are explicit, so the files that use
// them need no contraction. On sets without fused operations the filters' bounds cover separate rounding alike.
#pragma once

#include "common/shared/portable.h"

#ifdef __x86_64__
#include <immintrin.h>

// Between these two macros, functions are compiled for an instruction set that the rest of the program must not use.
#define CPU_PRAGMA(text) _Pragma(#text)
#ifdef __clang__
#define BEGIN_TARGET(indices) CPU_PRAGMA(clang attribute push(__attribute__((target(indices))), apply_to = function))
#define END_TARGET CPU_PRAGMA(clang attribute pop)
#else
#define BEGIN_TARGET(indices) CPU_PRAGMA(GCC push_options) CPU_PRAGMA(GCC target(indices))
#define END_TARGET CPU_PRAGMA(GCC pop_options)
#endif

BEGIN_TARGET("avx512f,avx512dq,avx2,fma")
namespace spherepair::avx512 {
using Floats = __m512;
constexpr uint lanes = 16;
inline Floats load(const float* p) { return _mm512_loadu_ps(p); }
inline Floats spread(float x) { return _mm512_set1_ps(x); }
inline Floats fused(Floats a, Floats b, Floats c) { return _mm512_fmadd_ps(a, b, c); }
}  // namespace spherepair::avx512
END_TARGET

BEGIN_TARGET("avx2,fma")
namespace spherepair::avx2 {
using Floats = __m256;
constexpr uint lanes = 8;
inline Floats load(const float* p) { return _mm256_loadu_ps(p); }
inline Floats spread(float x) { return _mm256_set1_ps(x); }
inline Floats fused(Floats a, Floats b, Floats c) { return _mm256_fmadd_ps(a, b, c); }
}  // namespace spherepair::avx2
END_TARGET
#endif

namespace spherepair::portable {
typedef float Floats __attribute__((vector_size(16)));
typedef int Ints __attribute__((vector_size(16)));
constexpr uint lanes = 4;
inline Floats load(const float* p) { return Floats{p[0], p[1], p[2], p[3]}; }
inline Floats spread(float x) { return Floats{x, x, x, x}; }
inline Floats fused(Floats a, Floats b, Floats c) { return a * b + c; }
}  // namespace spherepair::portable
