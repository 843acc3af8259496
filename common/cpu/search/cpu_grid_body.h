// SPDX-License-Identifier: MIT
// The grid's search on vectors. cpu_grid_simd.cpp includes this file once for each instruction set, inside a namespace
// that defines Floats, lanes, load, spread, fused, not_above, below and append; hence no include guard.

// A run: consecutive spheres of one row of cells, in a few groups, all tested against the same rows of cells.
constexpr uint groups_at_once = 16, row_chunk = 64;
struct Run {
  uint first, count, level;
  Cell cell;                                                    // of the first sphere
  vec4 low, high;                                               // box of the centres; high.w: largest radius
  float group_low[groups_at_once], group_high[groups_at_once];  // along x, of each group's centres

  uint groups() const { return (count + spheres_at_once - 1) / spheres_at_once; }
};

// The float32 filter on vectors. near(): spheres are not certainly apart. sure(): near spheres certainly collide.
template <bool equal_radii>
struct Filter;

template <>
struct Filter<true> {
  Floats apart_above, collide_below;
  explicit Filter(const SearchParams& p) : apart_above(spread(p.apart_above)), collide_below(spread(p.collide_below)) {}
  uint near(Floats s, Floats) const { return not_above(s, apart_above); }
  uint sure(Floats s, Floats) const { return below(s, collide_below); }
};

template <>
struct Filter<false> {
  Floats scale, offset, most;
  explicit Filter(const SearchParams& p)
      : scale(spread(p.filter_scale)), offset(spread(p.filter_offset)), most(spread(bits_float(0x7F7FFFFFu))) {}
  uint near(Floats s, Floats r) const { return not_above(s, fused(r * r, scale, offset)); }
  uint sure(Floats s, Floats r) const {
    const Floats q = r * r;
    return below(fused(s, scale, offset), q) & not_above(q, most);
  }
};

template <bool hashed, bool equal_radii>
class Searcher {
 public:
  Searcher(const CellOrder& order, const Params& p, Candidates& found, CandidateSink& sink)
      : order_(order), p_(p), cells_{p.grid}, filter_(p.search), found_(found), sink_(sink) {}

  void search(uint first, uint last) {
    while (first < last) {
      const Run run = take_run(first, last);
      for (uint level = run.level; level <= p_.grid.top_level; ++level)
        if (p_.grid.levels >> level & 1) test_level(run, level);
      first += run.count;
    }
  }

 private:
  vec4 sphere(uint place) const {
    return {order_.x[place], order_.y[place], order_.z[place], equal_radii ? p_.radius : order_.radius[place]};
  }

  // Whether this is the last cell, which holds everything beyond. Its spheres may be too far apart to be tested as a
  // row of cells.
  static bool is_last(int cell) { return cell <= -MOST_CELLS || cell >= MOST_CELLS; }

  // Whether the run may go on at `place`. A run of hashed cells ends with its row, and before the row wraps around to
  // slots that the run already uses.
  bool continues(const Run& run, uint place) const {
    if (!hashed) return true;
    if (is_last(run.cell.x) || is_last(run.cell.y) || is_last(run.cell.z)) return false;
    const vec4 s = sphere(place);
    return stands_in_row(s, run.level, run.cell.y, run.cell.z, p_.grid) &&
           uint(cells_.own(s, run.level).x) - uint(run.cell.x) < row_chunk;
  }

  Run take_run(uint first, uint last) const {
    Run run;
    const vec4 s = sphere(first);
    run.first = first;
    run.level = level_of(s.w, p_.grid);
    run.cell = cells_.own(s, run.level);
    uint end = std::min(last, first + groups_at_once * spheres_at_once);
    if (!hashed) end = std::min(end, order_.begin[cells_.row(0, run.cell.y, run.cell.z) + p_.grid.cells_x]);
    run.count = 1;
    while (first + run.count < end && continues(run, first + run.count)) ++run.count;
    bound(run);
    return run;
  }

  void bound(Run& run) const {
    const float most = bits_float(0x7F800000u);  // infinity
    run.low = {most, most, most, most}, run.high = {-most, -most, -most, 0};
    for (uint g = 0; g < run.groups(); ++g) {
      const uint begin = run.first + g * spheres_at_once,
                 end = std::min(begin + spheres_at_once, run.first + run.count);
      float low = most, high = -most;
      for (uint i = begin; i < end; ++i) {
        const vec4 s = sphere(i);
        low = std::min(low, s.x), high = std::max(high, s.x);
        run.low.y = std::min(run.low.y, s.y), run.high.y = std::max(run.high.y, s.y);
        run.low.z = std::min(run.low.z, s.z), run.high.z = std::max(run.high.z, s.z);
        run.high.w = std::max(run.high.w, s.w);
      }
      run.group_low[g] = low, run.group_high[g] = high;
    }
  }

  // Tests a run against the rows of cells in reach on one level. On the spheres' own level only the half of the
  // neighbourhood after their own row is tested.
  void test_level(const Run& run, uint level) {
    const float reach = cells_.reach(run.high.w, level);
    const Cell low = cells_.lowest(run.low, reach, level), high = cells_.highest(run.high, reach, level);
    int first[groups_at_once], last[groups_at_once];
    for (uint g = 0; g < run.groups(); ++g) {
      first[g] = cells_.lowest({run.group_low[g], 0, 0, 0}, reach, level).x;
      last[g] = cells_.highest({run.group_high[g], 0, 0, 0}, reach, level).x;
    }
    const bool half = level == run.level;
    if (half) test_own_row(run, last);
    int y = half ? run.cell.y + 1 : low.y;
    for (int z = half ? run.cell.z : low.z; z <= high.z; ++z) {
      for (; y <= high.y; ++y) test_row(run, level, y, z, first, last);
      y = low.y;
    }
  }

  void test_own_row(const Run& run, const int* last) {
    const uint row = cells_.row(run.level, run.cell.y, run.cell.z);
    for (uint g = 0; g < run.groups(); ++g) {
      const uint begin = run.first + g * spheres_at_once,
                 count = std::min(spheres_at_once, run.first + run.count - begin);
      const uint slot = cells_.slot(row, last[g]), end = order_.begin[slot + 1];
      const bool wraps = hashed && slot < cells_.slot(row, run.cell.x);
      test_pair<true>(begin, count, begin + 1, wraps ? p_.n : end, run.level, run.cell.y, run.cell.z);
      if (wraps) test_pair<false>(begin, count, 0, end, run.level, run.cell.y, run.cell.z);
    }
  }

  void test_row(const Run& run, uint level, int y, int z, const int* first, const int* last) {
    const uint row = cells_.row(level, y, z);
    for (uint g = 0; g < run.groups(); ++g) {
      const uint begin = run.first + g * spheres_at_once,
                 count = std::min(spheres_at_once, run.first + run.count - begin);
      const uint from = cells_.slot(row, first[g]), to = cells_.slot(row, last[g]);
      if (hashed && to < from) {
        test_pair<false>(begin, count, order_.begin[from], p_.n, level, y, z);
        test_pair<false>(begin, count, 0, order_.begin[to + 1], level, y, z);
      } else {
        test_pair<false>(begin, count, order_.begin[from], order_.begin[to + 1], level, y, z);
      }
    }
  }

  // Tests `count` spheres from `first` on against those from `begin` to `end`. half: both are in one row, so only later
  // spheres count.
  template <bool half>
  void test_pair(uint first, uint count, uint begin, uint end, uint level, int y, int z) {
    for (uint at = begin; at < end; at += lanes) {
      if (found_.size + spheres_at_once * lanes > candidates_at_once) sink_.take(found_);
      const Floats xs = load(order_.x + at), ys = load(order_.y + at), zs = load(order_.z + at);
      Floats radii = xs;
      if (!equal_radii) radii = load(order_.radius + at);
      for (uint i = first; i < first + count; i += quad) {
        uint64_t near = 0, open = 0;
        for (uint k = 0; k < quad; ++k) {
          const Floats dx = xs - spread(order_.x[i + k]), dy = ys - spread(order_.y[i + k]);
          const Floats dz = zs - spread(order_.z[i + k]);
          const Floats s = fused(dz, dz, fused(dy, dy, dx * dx));
          Floats r = s;
          if (!equal_radii) r = radii + spread(order_.radius[i + k]);
          const uint is_near = filter_.near(s, r);
          near |= uint64_t(is_near) << (k * lanes);
          open |= uint64_t(is_near & ~filter_.sure(s, r)) << (k * lanes);
        }
        near &= meant<half>(i, first + count - i, at, end - at);
        if (hashed && near) near = in_row(near, at, level, y, z);
        append(found_, i, at, near, open);
      }
    }
  }

  // Masks the candidate pairs of a quad from i on with a vector from `at` on: none beyond the last sphere, and with
  // `half` none with itself or an earlier sphere.
  template <bool half>
  static uint64_t meant(uint i, uint count, uint at, uint others) {
    constexpr uint64_t every = lanes == 16 ? 0x0001000100010001u : lanes == 8 ? 0x01010101u : 0x1111u;
    uint64_t bits = others < lanes ? every * ((1u << others) - 1) : every * ((1u << lanes) - 1);
    if (count < quad) bits &= (uint64_t(1) << (count * lanes)) - 1;
    if (!half || i + quad <= at) return bits;
    for (uint k = 0; k < quad; ++k)
      if (i + k >= at) bits &= ~(((uint64_t(2) << (i + k - at)) - 1) << (k * lanes));
    return bits;
  }

  // Keeps the candidate pairs with spheres of this row: other rows may use the same slots.
  uint64_t in_row(uint64_t near, uint at, uint level, int y, int z) const {
    uint64_t kept = 0;
    for (uint64_t rest = near; rest; rest &= rest - 1) {
      const uint bit = uint(std::countr_zero(rest));
      if (stands_in_row(sphere(at + bit % lanes), level, y, z, p_.grid)) kept |= uint64_t(1) << bit;
    }
    return kept;
  }

  const CellOrder order_;
  const Params& p_;
  const CellMap<hashed> cells_;
  const Filter<equal_radii> filter_;
  Candidates& found_;
  CandidateSink& sink_;
};

inline void find_candidates(const CellOrder& order, const Params& p, uint first, uint last, Candidates& found,
                            CandidateSink& sink) {
  const bool hashed = p.grid.hash_mask != 0, equal_radii = order.radius == nullptr;
  if (hashed) {
    equal_radii ? Searcher<true, true>(order, p, found, sink).search(first, last)
                : Searcher<true, false>(order, p, found, sink).search(first, last);
  } else {
    equal_radii ? Searcher<false, true>(order, p, found, sink).search(first, last)
                : Searcher<false, false>(order, p, found, sink).search(first, last);
  }
}

inline GridSimd grid_simd(const char* name) { return {name, find_slots, find_candidates, mix}; }
