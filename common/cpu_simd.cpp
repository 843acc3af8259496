// SPDX-License-Identifier: MIT
// The Gram filter on whole vectors. GCC compiles it for several instruction sets and picks one when the program starts.
// This file alone may contract: the filter's bound covers both roundings.
#include "cpu_simd.h"

#ifdef __x86_64__
#define FOR_EACH_MACHINE __attribute__((target_clones("avx512f", "arch=haswell", "default")))
#else
#define FOR_EACH_MACHINE
#endif

// All lanes of a vector combined into one.
#define FOLD_BY(vector, op, distance) \
  ((vector)op __builtin_shuffle(vector, (Ints{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15} ^ (distance))))
#define FOLD(vector, op) FOLD_BY(FOLD_BY(FOLD_BY(FOLD_BY(vector, op, 8), op, 4), op, 2), op, 1)[0]

namespace spherepair {
namespace {

typedef float Floats __attribute__((vector_size(lanes * sizeof(float))));
typedef int Ints __attribute__((vector_size(lanes * sizeof(int))));

}  // namespace

FOR_EACH_MACHINE
void meet_tile(const ColumnTile& tile, const vec4 (&rows)[rows_at_once], const float (&radii)[rows_at_once],
               bool equal_radii, NearColumns& result) {
  constexpr Ints weights = {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768};
  for (uint chunk = 0; chunk < chunks; ++chunk) {
    Floats margin[rows_at_once][vectors];  // negative where row and column cannot collide
    Ints apart = ~Ints{};
    for (uint v = 0; v < vectors; ++v) {
      const uint at = chunk * chunk_columns + v * lanes;
      const Floats x = *reinterpret_cast<const Floats*>(tile.x + at), y = *reinterpret_cast<const Floats*>(tile.y + at);
      const Floats z = *reinterpret_cast<const Floats*>(tile.z + at),
                   minus_w = *reinterpret_cast<const Floats*>(tile.minus_w + at);
      for (uint r = 0; r < rows_at_once; ++r) {
        Floats product = rows[r].x * x + (rows[r].y * y + (rows[r].z * z + minus_w));
        if (!equal_radii) product += radii[r] * *reinterpret_cast<const Floats*>(tile.radius + at);
        margin[r][v] = product - rows[r].w;
        apart &= reinterpret_cast<Ints>(margin[r][v]);
      }
    }
    result.near[chunk] = FOLD(apart, &) >= 0;
    if (!result.near[chunk]) continue;
    for (uint r = 0; r < rows_at_once; ++r) {
      for (uint v = 0; v < vectors; ++v) {
        const Ints bits = ~(reinterpret_cast<Ints>(margin[r][v]) >> 31) & weights;
        result.columns[chunk][r][v] = uint16_t(FOLD(bits, |));
      }
    }
  }
}

}  // namespace spherepair
