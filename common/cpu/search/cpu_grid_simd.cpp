// SPDX-License-Identifier: MIT
// Compiles one body for several instruction sets; the program picks one when it starts. The filter's error bound covers
// fused and separate rounding alike.
#include "common/cpu/search/cpu_grid_simd.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "common/cpu/search/cpu_grid_cells.h"
#include "common/cpu/search/cpu_vectors.h"
#include "common/shared/predicate.h"

#ifdef __x86_64__
namespace spherepair::avx512 {
alignas(64) constexpr std::array<unsigned char, 64> bit_numbers = [] {
  std::array<unsigned char, 64> numbers{};
  for (uint k = 0; k < 64; ++k) numbers[k] = static_cast<unsigned char>(k);
  return numbers;
}();
}  // namespace spherepair::avx512

BEGIN_TARGET("avx512f,avx512dq,avx512vl,avx512bw,avx512vbmi2,avx2,fma,bmi,bmi2,popcnt")
namespace spherepair::avx512 {
inline uint not_above(Floats a, Floats b) { return _mm512_cmp_ps_mask(a, b, _CMP_NGT_UQ); }
inline uint below(Floats a, Floats b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
typedef uint Uints __attribute__((vector_size(64)));
#include "common/cpu/search/cpu_grid_parts.h"
// Appends the candidate pairs of a quad without a branch on each bit, which would be hard to predict.
inline void append(Candidates& found, uint first, uint at, uint64_t near, uint64_t open) {
  const uint count = uint(_mm_popcnt_u64(near));
  if (count > lanes || (open & near)) [[unlikely]]
    return append_each(found, first, at, near, open);
  const __m512i bits = _mm512_maskz_compress_epi8(near, _mm512_load_si512(bit_numbers.data()));
  const Uints bit = Uints(_mm512_maskz_cvtepu8_epi32(0xFFFF, _mm512_maskz_extracti32x4_epi32(0xF, bits, 0)));
  _mm512_storeu_si512(found.mine + found.size, __m512i(bit / lanes + first));
  _mm512_storeu_si512(found.other + found.size, __m512i(bit % lanes + at));
  found.size += count;
}
#include "common/cpu/search/cpu_grid_body.h"
}  // namespace spherepair::avx512
END_TARGET

BEGIN_TARGET("avx2,fma,bmi,bmi2,popcnt")
namespace spherepair::avx2 {
inline uint not_above(Floats a, Floats b) { return uint(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_NGT_UQ))); }
inline uint below(Floats a, Floats b) { return uint(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ))); }
#include "common/cpu/search/cpu_grid_parts.h"
inline void append(Candidates& found, uint first, uint at, uint64_t near, uint64_t open) {
  append_each(found, first, at, near, open);
}
#include "common/cpu/search/cpu_grid_body.h"
}  // namespace spherepair::avx2
END_TARGET
#endif

namespace spherepair::portable {
inline uint bits_of(Ints m) { return uint((m[0] & 1) | (m[1] & 2) | (m[2] & 4) | (m[3] & 8)); }
inline uint not_above(Floats a, Floats b) { return bits_of(~(a > b)); }
inline uint below(Floats a, Floats b) { return bits_of(a < b); }
#include "common/cpu/search/cpu_grid_parts.h"
inline void append(Candidates& found, uint first, uint at, uint64_t near, uint64_t open) {
  append_each(found, first, at, near, open);
}
#include "common/cpu/search/cpu_grid_body.h"
}  // namespace spherepair::portable

namespace spherepair {

std::span<const GridSimd> grid_simds() {
  static const std::vector<GridSimd> runnable = [] {
    std::vector<GridSimd> all;
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vbmi2"))
      all.push_back(avx512::grid_simd("avx512"));
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) all.push_back(avx2::grid_simd("avx2"));
#endif
    all.push_back(portable::grid_simd("portable"));
    return all;
  }();
  return runnable;
}

}  // namespace spherepair
