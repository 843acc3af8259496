// SPDX-License-Identifier: MIT
// Compiles one body for several instruction sets; the program picks one when it starts. The limits' bounds cover fused
// and separate rounding alike.
#include "common/cpu/search/cpu_rows.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include "common/cpu/search/cpu_vectors.h"

namespace spherepair {
namespace {

// Appends the keys of the set bits.
inline uint* append_each(uint* end, const uint* keys, uint bits) {
  for (; bits; bits &= bits - 1) *end++ = keys[std::countr_zero(bits)];
  return end;
}

}  // namespace
}  // namespace spherepair

#ifdef __x86_64__
BEGIN_TARGET("avx512f,avx512dq,avx512vl,avx512bw,avx2,fma,bmi,bmi2,popcnt")
namespace spherepair::avx512 {
inline uint not_above(Floats a, Floats b) { return _mm512_cmp_ps_mask(a, b, _CMP_NGT_UQ); }
inline uint below(Floats a, Floats b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
inline uint meant(const uint* keys, uint least, uint skipped) {
  const __m512i key = _mm512_loadu_si512(keys);
  return _mm512_cmpge_epu32_mask(key, _mm512_set1_epi32(int(least))) &
         _mm512_cmpneq_epu32_mask(key, _mm512_set1_epi32(int(skipped)));
}
// Writes a whole vector, so that no branch depends on the bits.
inline uint* append(uint* end, const uint* keys, uint bits) {
  _mm512_storeu_si512(end, _mm512_maskz_compress_epi32(__mmask16(bits), _mm512_loadu_si512(keys)));
  return end + _mm_popcnt_u32(bits);
}
template <typename Number>
void copy(const Number* from, Number* to) {
  _mm512_storeu_si512(to, _mm512_loadu_si512(from));
}
#include "common/cpu/search/cpu_rows_body.h"
}  // namespace spherepair::avx512
END_TARGET

BEGIN_TARGET("avx2,fma,bmi,bmi2,popcnt")
namespace spherepair::avx2 {
inline uint not_above(Floats a, Floats b) { return uint(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_NGT_UQ))); }
inline uint below(Floats a, Floats b) { return uint(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ))); }
inline uint meant(const uint* keys, uint least, uint skipped) {
  const __m256i key = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(keys));
  const __m256i from = _mm256_cmpeq_epi32(_mm256_max_epu32(key, _mm256_set1_epi32(int(least))), key);
  const __m256i kept = _mm256_andnot_si256(_mm256_cmpeq_epi32(key, _mm256_set1_epi32(int(skipped))), from);
  return uint(_mm256_movemask_ps(_mm256_castsi256_ps(kept)));
}
inline uint* append(uint* end, const uint* keys, uint bits) { return append_each(end, keys, bits); }
template <typename Number>
void copy(const Number* from, Number* to) {
  std::copy(from, from + lanes, to);
}
#include "common/cpu/search/cpu_rows_body.h"
}  // namespace spherepair::avx2
END_TARGET
#endif

namespace spherepair::portable {
inline uint bits_of(Ints m) { return uint((m[0] & 1) | (m[1] & 2) | (m[2] & 4) | (m[3] & 8)); }
inline uint not_above(Floats a, Floats b) { return bits_of(~(a > b)); }
inline uint below(Floats a, Floats b) { return bits_of(a < b); }
inline uint meant(const uint* keys, uint least, uint skipped) {
  uint bits = 0;
  for (uint k = 0; k < lanes; ++k) bits |= uint(keys[k] >= least && keys[k] != skipped) << k;
  return bits;
}
inline uint* append(uint* end, const uint* keys, uint bits) { return append_each(end, keys, bits); }
template <typename Number>
void copy(const Number* from, Number* to) {
  std::copy(from, from + lanes, to);
}
#include "common/cpu/search/cpu_rows_body.h"
}  // namespace spherepair::portable

namespace spherepair {

void RowBlock::grow(uint targets) {
  room = 0;  // in case of an error
  const uint larger = targets + targets / 2 + 1, most = larger + row_slack;
  x.resize(most), y.resize(most), z.resize(most), radius.resize(most), key.resize(most);
  room = larger;
}

void RowBlock::end(uint targets) {
  count = targets;
  std::fill_n(&x[count], row_slack / 2, std::numeric_limits<float>::max());
  for (Buffer<float>* const component : {&y, &z, &radius}) std::fill_n(&(*component)[count], row_slack / 2, 0.0f);
  std::fill_n(&key[count], row_slack / 2, 0u);
}

std::span<const RowSimd> row_simds() {
  static const std::vector<RowSimd> runnable = [] {
    std::vector<RowSimd> all;
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
      all.push_back(avx512::row_simd("avx512"));
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) all.push_back(avx2::row_simd("avx2"));
#endif
    all.push_back(portable::row_simd("portable"));
    return all;
  }();
  return runnable;
}

}  // namespace spherepair
