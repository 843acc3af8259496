// SPDX-License-Identifier: MIT
// The Gram filter on vectors. cpu_simd.cpp includes this file once for each instruction set, inside a namespace that
// defines Floats, lanes, vectors, load, spread, fused, both and near_lanes; hence no include guard.

inline void form_columns(ColumnTile& tile, vec4 origin, float share) {
  for (uint c = 0; c < tile_columns; ++c) {
    const vec4 sphere = {tile.x[c], tile.y[c], tile.z[c], tile.radius[c]};
    const vec4 form = gram_form(sphere, origin, share);
    tile.x[c] = form.x;
    tile.y[c] = form.y;
    tile.z[c] = form.z;
    tile.w[c] = -form.w;
  }
}

// Lists the columns near each row. A few vectors of columns stay in registers while all rows pass. A margin is negative
// if row and column cannot collide. One branch tests all columns at once, since a near one is rare.
template <bool equal_radii>
inline void find_near_columns(const ColumnTile& tile, uint columns, const RowTile& rows, NearList& list) {
  static_assert(vectors * lanes >= least_columns && tile_columns % (vectors * lanes) == 0);
  uint size = 0;
  for (uint first = 0; first < columns; first += vectors * lanes) {
    Floats x[vectors], y[vectors], z[vectors], minus_w[vectors], radius[vectors];
    for (uint v = 0; v < vectors; ++v) {
      const uint at = first + v * lanes;
      x[v] = load(tile.x + at), y[v] = load(tile.y + at), z[v] = load(tile.z + at), minus_w[v] = load(tile.w + at);
      if (!equal_radii) radius[v] = load(tile.radius + at);
    }
    for (uint r = 0; r < rows.count; ++r) {
      const vec4& form = rows.form[r];
      const Floats fx = spread(form.x), fy = spread(form.y), fz = spread(form.z), fw = spread(form.w);
      Floats margin[vectors];
      for (uint v = 0; v < vectors; ++v) {
        Floats product = fused(fx, x[v], fused(fy, y[v], fused(fz, z[v], minus_w[v])));
        if (!equal_radii) product = fused(spread(rows.radius[r]), radius[v], product);
        margin[v] = product - fw;
      }
      Floats all = margin[0];
      for (uint v = 1; v < vectors; ++v) all = both(all, margin[v]);
      if (near_lanes(all) == 0) [[likely]]
        continue;
      uint64_t bits = 0;
      for (uint v = 0; v < vectors; ++v) bits |= uint64_t(near_lanes(margin[v])) << (v * lanes);
      list.entry[size++] = {uint16_t(r), uint16_t(first), bits};
    }
  }
  list.size = size;
}

inline void find_near(const ColumnTile& tile, uint columns, const RowTile& rows, bool equal_radii, NearList& list) {
  equal_radii ? find_near_columns<true>(tile, columns, rows, list)
              : find_near_columns<false>(tile, columns, rows, list);
}
