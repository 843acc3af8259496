// SPDX-License-Identifier: MIT
// The grid's shorter loops on vectors. cpu_grid_simd.cpp includes this file once for each instruction set, inside a
// namespace that defines `lanes`; hence no include guard.

// Appends the candidate pairs of a quad, one by one.
inline void append_each(Candidates& found, uint first, uint at, uint64_t near, uint64_t open) {
  for (; near; near &= near - 1) {
    const uint bit = uint(std::countr_zero(near));
    found.mine[found.size] = first + bit / lanes;
    found.other[found.size++] = (at + bit % lanes) | (open >> bit & 1 ? UNDECIDED_BIT : 0);
  }
}

// Computes slot_of in a dense grid, with all three axes in one vector.
inline void find_dense_slots(const vec4* spheres, uint count, const GridParams& g, uint* slots) {
  typedef float Axes __attribute__((vector_size(16)));
  typedef int Cells __attribute__((vector_size(16)));
  typedef uint Strides __attribute__((vector_size(16)));
  const float scale = cells_per_metre(0, g);
  const Axes origin = {g.origin_x, g.origin_y, g.origin_z, 0}, lowest = {0, 0, 0, 0}, scales = {scale, scale, scale, 0};
  const Axes highest = {float(int(g.cells_x) - 1), float(int(g.cells_y) - 1), float(int(g.cells_z) - 1), 0};
  const Strides strides = {1, g.cells_x, g.cells_x * g.cells_y, 0};
  for (uint k = 0; k < count; ++k) {
    Axes place = (Axes{spheres[k].x, spheres[k].y, spheres[k].z, 0} - origin) * scales;
    place = place > lowest ? place : lowest;  // NaN goes to the lowest cell
    place = place < highest ? place : highest;
    const Strides parts = Strides(__builtin_convertvector(place, Cells)) * strides;
    slots[k] = parts[0] + parts[1] + parts[2];
  }
}

inline void find_slots(const vec4* spheres, const float* radii, uint count, const GridParams& g, uint* slots) {
  if (g.hash_mask == 0) return find_dense_slots(spheres, count, g, slots);
  for (uint k = 0; k < count; ++k) {
    vec4 sphere = spheres[k];
    if (radii) sphere.w = radii[k];
    slots[k] = slot_of(sphere, g);
  }
}

inline Fingerprint mix(const Candidates& candidates, const uint* id, uint64_t* keys) {
  uint64_t a = 0, b = 0;
  for (uint k = 0; k < candidates.size; ++k) {
    const uint i = id[candidates.mine[k]], j = id[candidates.other[k]];
    const uint first = i < j ? i : j, second = i < j ? j : i;
    keys[k] = uint64_t(first) << 32 | second;
    a += pair_mix_a(first, second);
    b += pair_mix_b(first, second);
  }
  return {a, b};
}
