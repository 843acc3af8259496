// SPDX-License-Identifier: MIT
// Compiles one body for several instruction sets; the program picks one when it starts.
#include "common/cpu/search/cpu_simd.h"

#include "common/cpu/search/cpu_vectors.h"

#ifdef __x86_64__
BEGIN_TARGET("avx512f,avx512dq,avx2,fma")
namespace spherepair::avx512 {
constexpr uint vectors = 4;
inline Floats both(Floats a, Floats b) { return _mm512_and_ps(a, b); }
inline uint near_lanes(Floats margin) { return 0xFFFFu & ~uint(_mm512_movepi32_mask(_mm512_castps_si512(margin))); }
#include "common/cpu/search/cpu_simd_body.h"
}  // namespace spherepair::avx512
END_TARGET

BEGIN_TARGET("avx2,fma")
namespace spherepair::avx2 {
constexpr uint vectors = 2;
inline Floats both(Floats a, Floats b) { return _mm256_and_ps(a, b); }
inline uint near_lanes(Floats margin) { return 0xFFu & ~uint(_mm256_movemask_ps(margin)); }
#include "common/cpu/search/cpu_simd_body.h"
}  // namespace spherepair::avx2
END_TARGET
#endif

namespace spherepair::portable {
constexpr uint vectors = 2;
inline Floats both(Floats a, Floats b) { return Floats(Ints(a) & Ints(b)); }
inline uint near_lanes(Floats margin) {
  const Ints sign = ~Ints(margin) >> 31;
  return uint((sign[0] & 1) | (sign[1] & 2) | (sign[2] & 4) | (sign[3] & 8));
}
#include "common/cpu/search/cpu_simd_body.h"
}  // namespace spherepair::portable

namespace spherepair {

const Simd& best_simd() {
  static const Simd best = [] {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx512dq")) return Simd{"avx512", avx512::form_columns, avx512::find_near};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
      return Simd{"avx2", avx2::form_columns, avx2::find_near};
#endif
    return Simd{"portable", portable::form_columns, portable::find_near};
  }();
  return best;
}

}  // namespace spherepair
