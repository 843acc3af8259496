// SPDX-License-Identifier: MIT
// The search of rows on vectors. cpu_rows.cpp includes this file once for each instruction set, inside a namespace that
// defines Floats, lanes, load, spread, fused, not_above, below, meant, append and copy; hence no include guard.

// Copies whole vectors: the next range overwrites what is too much.
inline void collect_targets(const RowTargets& from, std::span<const TargetRange> ranges, bool sized, RowBlock& to) {
  uint end = 0;
  for (const TargetRange range : ranges) end += range.last - range.first;
  to.make_room(end);
  const RowTargets source = from;  // stores could change what it refers to
  float *x = to.x.data(), *y = to.y.data(), *z = to.z.data(), *radius = to.radius.data();
  uint* key = to.key.data();
  end = 0;
  for (const TargetRange range : ranges) {
    for (uint at = range.first, place = end; at < range.last; at += lanes, place += lanes) {
      copy(source.x + at, x + place), copy(source.y + at, y + place), copy(source.z + at, z + place);
      copy(source.key + at, key + place);
      if (sized) copy(source.radius + at, radius + place);
    }
    end += range.last - range.first;
    __builtin_prefetch(source.x + range.last + 16), __builtin_prefetch(source.y + range.last + 16);
    __builtin_prefetch(source.z + range.last + 16), __builtin_prefetch(source.key + range.last + 16);
  }
  to.end(end);
}

template <bool sized>
FoundRow find_row(RowTargets block, uint first, uint last, RowPoint point, RowLimits limits, uint* keys) {
  const Floats x = spread(point.x), y = spread(point.y), z = spread(point.z), radius = spread(point.radius);
  const Floats near_limit = spread(limits.near), sure_limit = spread(limits.sure);
  uint* end = keys;
  uint open = 0;
  for (uint at = first; at < last; at += lanes) {
    const Floats dx = load(block.x + at) - x, dy = load(block.y + at) - y, dz = load(block.z + at) - z;
    Floats s = fused(dz, dz, fused(dy, dy, dx * dx));
    if (sized) {
      const Floats reach = load(block.radius + at) + radius;
      s = s - reach * reach;
    }
    const uint near = not_above(s, near_limit) & meant(block.key + at, point.least, point.skipped);
    open |= near & ~below(s, sure_limit);
    end = append(end, block.key + at, near);
  }
  return {uint(end - keys), open != 0};
}

// A key's place in the row is the number of smaller ones: no two are equal.
inline void sort_row(uint* keys, uint count) {
  if (count < 8) {
    for (uint k = 1; k < count; ++k) {
      const uint key = keys[k];
      uint to = k;
      for (; to > 0 && keys[to - 1] > key; --to) keys[to] = keys[to - 1];
      keys[to] = key;
    }
    return;
  }
  constexpr uint most = 96;
  if (count > most) return std::sort(keys, keys + count);
  uint sorted[most];
  for (uint k = 0; k < count; ++k) {
    uint place = 0;
    for (uint other = 0; other < count; ++other) place += keys[other] < keys[k];
    sorted[place] = keys[k];
  }
  std::copy(sorted, sorted + count, keys);
}

inline void find_rows(const RowBlock& block, uint first, bool in_order, std::span<const RowPoint> points,
                      RowLimits limits, uint* keys, FoundRow* rows) {
  const RowTargets all = {block.x.data(), block.y.data(), block.z.data(), block.radius.data(), block.key.data()};
  const uint last = block.count;
  first -= first % lanes;
  for (const RowPoint& point : points) {
    *rows = limits.sized ? find_row<true>(all, first, last, point, limits, keys)
                         : find_row<false>(all, first, last, point, limits, keys);
    if (!in_order) sort_row(keys, rows->count);
    keys += rows++->count;
  }
}

inline RowSimd row_simd(const char* name) { return {name, collect_targets, find_rows}; }
