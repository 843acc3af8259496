// SPDX-License-Identifier: MIT
#include "bench/legend/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/legend/font.h"

namespace spherepair {
namespace {

constexpr uint ink = 0x303030;

struct Item {
  std::string text;
  const LegendKey* key = nullptr;
  double x = 0;
  int row = 0;
};

// Lengths in ems.
constexpr double margin = 0.6, gap = 1.1, gap_before_facts = 2.5, row_height = 1.5, swatch = 0.9, swatch_room = 1.2;

double width_of(const Item& item, double size) {
  return text_width(item.text, size) + (item.key ? swatch_room * size : 0);
}

// Places the items from left to right in rows. If they do not fit into one row, the facts begin a row of their own.
std::vector<Item> lay_out(const Legend& legend, double size, double width) {
  std::vector<Item> items = {{legend.title}};
  for (const LegendKey& key : legend.keys) items.push_back({key.label, &key});
  const size_t first_fact = items.size();
  for (const std::string& fact : legend.facts) items.push_back({fact});
  double all = (margin + gap_before_facts) * size;
  for (const Item& item : items) all += width_of(item, size) + gap * size;
  double x = margin * size;
  int row = 0;
  for (size_t k = 0; k < items.size(); ++k) {
    const double end = x + width_of(items[k], size) + margin * size;
    const bool next_row = (k == first_fact && all > width) || (end > width && x > margin * size);
    if (next_row) x = margin * size, ++row;
    if (k == first_fact && !next_row) x += gap_before_facts * size;
    items[k].x = x;
    items[k].row = row;
    x += width_of(items[k], size) + gap * size;
  }
  return items;
}

}  // namespace

std::vector<std::string> legend_labels(const Look& look) {
  std::vector<std::string> labels;
  for (size_t k = 0; k < look.palette.size(); ++k) {
    if (look.colour_by == COLOUR_BY_CONTACTS) {
      labels.push_back(std::to_string(k));
    } else {
      labels.push_back(fmt::format("{}{:.3g}", k == 0 ? "< " : "", look.limits[k == 0 ? 0 : k - 1]));
    }
  }
  labels.back() += "+";
  return labels;
}

Legend legend_of(const Look& look, const std::vector<std::string>& facts) {
  Legend legend{std::array{"contacts", "speed in m/s, at least", "radius in m, at least"}[look.colour_by], {}, facts};
  const std::vector<std::string> labels = legend_labels(look);
  for (size_t k = 0; k < labels.size(); ++k) legend.keys.push_back({look.palette[k], labels[k]});
  return legend;
}

std::optional<LegendStrip> LegendStrip::within(const Legend& widest, uint width, uint height) {
  const double size = std::max(10.0, height / 42.0);
  const std::vector<Item> items = lay_out(widest, size, width);
  const uint needed = uint(std::ceil((row_height * (items.back().row + 1) + margin) * size));
  const auto too_wide = [&](const Item& item) { return item.x + width_of(item, size) > width; };
  if (2 * needed > height || std::ranges::any_of(items, too_wide)) return std::nullopt;
  return LegendStrip(size, width, needed);
}

void LegendStrip::append_to(std::vector<uint>& image, const Legend& legend) const {
  const size_t above = image.size() / width_;
  image.resize(image.size() + size_t(width_) * height_, ~0u);
  Canvas canvas(image, width_, uint(above) + height_);
  for (int x = 0; x < int(width_); ++x) canvas.blend(x, int(above), 0xD0D0D0, 1);
  for (const Item& item : lay_out(legend, size_, width_)) {
    const double baseline = double(above) + (margin / 2 + row_height * (item.row + 1) - 0.4) * size_;
    double x = item.x;
    if (item.key) {
      canvas.square({x, std::round(baseline - 0.8 * size_)}, std::round(swatch * size_), item.key->colour);
      x += swatch_room * size_;
    }
    draw_text(canvas, item.text, {x, baseline}, size_, ink);
  }
}

}  // namespace spherepair
