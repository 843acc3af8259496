// SPDX-License-Identifier: MIT
#include "common/image/colouring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/scene/known_name.h"

namespace spherepair {
namespace {

constexpr std::array known = {"contacts", "radius", "speed", "species"};
// Okabe and Ito's palette, which colour-blind people can tell apart.
constexpr std::array<uint, COLOURS> species_palette = {0x56B4E9, 0xE69F00, 0x009E73, 0xCC79A7,
                                                       0xF0E442, 0x0072B2, 0xD55E00, 0x999999};

std::string range_label(const std::string& low, const std::string& high) {
  return low == high ? low : low + "–" + high;
}

// The borders as text, with the fewest digits, at least three, that tell them apart.
std::vector<std::string> texts_of(const std::vector<double>& borders) {
  std::vector<std::string> texts;
  for (int digits = 3; digits <= 9; ++digits) {
    texts.clear();
    for (const double border : borders) texts.push_back(fmt::format("{:.{}g}", border, digits));
    if (std::ranges::adjacent_find(texts) == texts.end()) break;
  }
  return texts;
}

}  // namespace

ColourBy colour_by_name(const std::string& name) {
  for (size_t k = 0; k < known.size(); ++k)
    if (name == known[k]) return ColourBy(k);
  throw std::invalid_argument("--color: " + unknown_name("quantity", name, {known.begin(), known.end()}));
}
const char* name_of(ColourBy by) { return known[size_t(by)]; }

void check_colour_range(ColourBy by, double low, double high) {
  if (by != ColourBy::speed && by != ColourBy::radius)
    throw std::invalid_argument(fmt::format("--color-range is of radius and speed, not of {}: omit it", name_of(by)));
  if (!(low >= 0 && low < high))
    throw std::invalid_argument(fmt::format("--color-range is {},{}, but must ascend from 0 or more", low, high));
}

std::vector<double> values_of(ColourBy by, Search& search, const Motion::State& state) {
  std::vector<double> values(state.positions.size());
  if (by == ColourBy::contacts) std::ranges::copy(search.counts(), values.begin());
  for (size_t i = 0; i < values.size(); ++i) {
    const vec4& v = state.velocities[i];
    if (by == ColourBy::radius) values[i] = double(state.positions[i].w);
    if (by == ColourBy::speed) values[i] = std::hypot(double(v.x), double(v.y), double(v.z));
  }
  return values;
}

Colouring::Colouring(ColourBy by, const std::vector<double>& values, const std::string& unit, bool clipped)
    : title_(by == ColourBy::contacts ? "contacts" : fmt::format("{}{}", name_of(by), unit)) {
  highest_ = *std::ranges::max_element(values);
  by == ColourBy::contacts ? choose_contacts(values) : choose_range(values, clipped);
}

// Up to seven contacts each number is a class. Else the classes are 0 and seven equal ranges up to the 98 % quantile.
void Colouring::choose_contacts(std::vector<double> values) {
  palette_ = contact_look().palette;
  limits_ = {1};
  labels_ = {"0"};
  std::erase(values, 0.0);
  std::ranges::sort(values);
  const bool few = highest_ < COLOURS;
  for (int k = 2; few && k < COLOURS; ++k) limits_.push_back(k);
  if (few) highest_ = COLOURS - 1;
  if (!few) limits_[0] = values.front();
  for (int k = 1; !few && k < COLOURS - 1; ++k) {
    const double above = values[values.size() * 98 / 100] + 1 - limits_[0];
    const double border = std::ceil(limits_[0] + above * k / (COLOURS - 1));
    if (border > limits_.back()) limits_.push_back(border);
  }
  for (size_t k = 0; k < limits_.size(); ++k) {
    const double last = k + 1 < limits_.size() ? limits_[k + 1] - 1 : limits_[k];
    labels_.push_back(range_label(fmt::format("{}", limits_[k]), fmt::format("{}", last)));
  }
  labels_.back() = fmt::format("{}+", limits_.back());
  if (limits_[0] > 1) labels_[0] = fmt::format("under {}", limits_[0]);
}

// Chooses equal intervals, or equal ratios if the values differ more than tenfold and none is 0.
void Colouring::choose_range(const std::vector<double>& values, bool clipped) {
  const double low = *std::ranges::min_element(values);
  palette_ = range_look(COLOUR_BY_RADIUS, 0, 1).palette;
  std::vector<double> borders = {low};
  const bool ratios = low > 0 && highest_ > 10 * low;
  for (int k = 1; low < highest_ && k <= COLOURS; ++k) {
    const double share = double(k) / COLOURS;
    borders.push_back(ratios ? low * std::pow(highest_ / low, share) : low + (highest_ - low) * share);
  }
  const std::vector<std::string> texts = texts_of(borders);
  if (texts.size() == 1) labels_ = texts, palette_[0] = palette_[COLOURS / 2];
  for (size_t k = 0; k + 1 < texts.size(); ++k) labels_.push_back(range_label(texts[k], texts[k + 1]));
  if (texts.size() > 2) labels_.back() = texts[texts.size() - 2] + "+";  // later images may have more
  if (clipped) labels_.front() = "under " + texts[1];
  if (borders.size() > 1) limits_.assign(borders.begin() + 1, borders.end() - 1);
}

Colouring::Colouring(const std::vector<std::string>& names, const std::vector<double>& values)
    : title_("species"), palette_(species_palette), class_of_name_(names.size()) {
  highest_ = double(names.size());
  std::vector<uint64_t> spheres(names.size());
  for (const double value : values) ++spheres[size_t(value)];
  std::vector<size_t> order(names.size());
  std::iota(order.begin(), order.end(), size_t(0));
  const bool shared = names.size() > COLOURS;
  if (shared) std::ranges::stable_sort(order, std::greater(), [&](size_t k) { return spheres[k]; });
  const size_t alone = shared ? COLOURS - 1 : names.size();
  for (size_t k = 0; k < order.size(); ++k) class_of_name_[order[k]] = uint(std::min(k, alone));
  for (size_t k = 0; k < alone; ++k) labels_.push_back(names[order[k]]);
  if (!shared) return;
  labels_.push_back(fmt::format("{} others", names.size() - alone));
  grouping_ = fmt::format("{} species, but {} colours: the {} rarest share one", names.size(), int(COLOURS),
                          names.size() - alone);
}

std::vector<uint> Colouring::classes(const std::vector<double>& values) const {
  std::vector<uint> classes(values.size());
  for (size_t i = 0; i < values.size(); ++i)
    classes[i] = class_of_name_.empty() ? uint(std::ranges::upper_bound(limits_, values[i]) - limits_.begin())
                                        : class_of_name_[size_t(values[i])];
  return classes;
}

Look Colouring::look() const {
  Look look{.palette = palette_};
  look.colour_by = COLOUR_BY_CLASS;
  return look;
}

Legend Colouring::legend() const {
  Legend legend{title_, {}, {}};
  for (size_t k = 0; k < labels_.size(); ++k) legend.keys.push_back({palette_[k], labels_[k]});
  return legend;
}

}  // namespace spherepair
