// SPDX-License-Identifier: MIT
#include "bench/image/drawing_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/io/numbers.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

constexpr double least_radius = 0x1p-30, most = 0x1p50;  // in_camera's limits (draw.h) for radii and distances
constexpr int wanted_exponent = 30;                      // of the farthest number: far from the eye is far below `most`

double farthest(const vec4& s) {
  return std::max({std::abs(double(s.x)), std::abs(double(s.y)), std::abs(double(s.z)), double(s.w)});
}

struct Sizes {
  double smallest = INFINITY, largest = 0;  // radius above 0; coordinate or radius
};
Sizes sizes_of(const std::vector<Start>& starts) {
  Sizes sizes;
  for (const Start& start : starts)
    for (const vec4& s : start.scene.positions) {
      if (s.w > 0) sizes.smallest = std::min(sizes.smallest, double(s.w));
      sizes.largest = std::max(sizes.largest, farthest(s));
    }
  return sizes;
}

bool keeps_all_bits(const std::vector<Start>& starts, int exponent) {
  const auto kept = [&](float x) { return std::ldexp(std::ldexp(x, exponent), -exponent) == x; };
  return std::ranges::all_of(starts, [&](const Start& start) {
    return std::ranges::all_of(start.scene.positions,
                               [&](const vec4& s) { return kept(s.x) && kept(s.y) && kept(s.z) && kept(s.w); });
  });
}

}  // namespace

void fit_for_drawing(std::vector<Start>& starts, CameraOptions& camera, std::string& ground) {
  const Sizes sizes = sizes_of(starts);
  const bool drawable = sizes.smallest >= least_radius && sizes.largest <= most / 16;
  if (!starts.front().at_rest || sizes.largest == 0 || drawable) return;
  const int exponent = wanted_exponent - std::ilogb(sizes.largest);
  if (!keeps_all_bits(starts, exponent)) return;
  for (Start& start : starts) {
    start.length_exponent = exponent;
    start.scene.plane = -std::ldexp(1.0f, wanted_exponent + 2);  // below all: a start lifts spheres onto the plane
    for (vec4& s : start.scene.positions)
      s = {std::ldexp(s.x, exponent), std::ldexp(s.y, exponent), std::ldexp(s.z, exponent), std::ldexp(s.w, exponent)};
  }
  for (std::vector<double>* point : {&camera.eye, &camera.target})
    for (double& x : *point) x = std::ldexp(x, exponent);
  camera.near = std::ldexp(camera.near, exponent);
  if (const auto height = real_number_of(ground, -1e15, 1e15))
    ground = fmt::format("{}", std::ldexp(*height, exponent));
}

std::string undrawn_text(const Start& start, std::span<const vec4> spheres) {
  const auto small = std::ranges::count_if(spheres, [](const vec4& s) { return s.w < least_radius; });
  const auto large = std::ranges::count_if(spheres, [](const vec4& s) { return farthest(s) > most; });
  const auto length = [&](double x) { return std::ldexp(x, -start.length_exponent); };
  std::string text;
  if (small)
    text += fmt::format("{} of {} not drawn: the smallest radius that is drawn is {:.3g}\n", small,
                        counted(spheres.size(), "sphere"), length(least_radius));
  if (large)
    text += fmt::format("{} of {} not drawn: the largest radius or coordinate that is drawn is {:.3g}\n", large,
                        counted(spheres.size(), "sphere"), length(most));
  return text;
}

void refuse_blank_image(const Start& start, std::span<const vec4> spheres) {
  if (spheres.empty())
    throw std::invalid_argument(fmt::format("{} has no spheres, so the image would be blank", start.label));
  throw std::invalid_argument(
      undrawn_text(start, spheres) +
      "no sphere is in the image: leave out --eye and --target to have all in view, or turn the camera, or give a "
      "larger --size if they are smaller than a pixel");
}

}  // namespace spherepair
