// SPDX-License-Identifier: MIT
#include "bench/image/ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "common/image/antialiased_image.h"
#include "common/scene/known_name.h"

namespace spherepair {
namespace {

double lowest_of(std::span<const vec4> spheres, const Vector& up) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const vec4& s : spheres)
    lowest = std::min(lowest, double(s.x) * up[0] + double(s.y) * up[1] + double(s.z) * up[2] - double(s.w));
  return lowest;
}

double height_of(const std::string& text) {
  double height = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), height);
  if (error == std::errc() && end == text.data() + text.size() && std::abs(height) < 1e15) return height;
  const std::string nearest = nearest_name(text, {"none", "plane", "lowest"});
  throw std::invalid_argument(fmt::format("--ground {}: {} none, plane, lowest or a height in metres below 1e15", text,
                                          nearest.empty() ? "give" : fmt::format("did you mean {}? Give", nearest)));
}

}  // namespace

Bounds bounds_of_all(const std::vector<Start>& starts, std::span<const vec4> spheres) {
  Bounds all = bounds_of(spheres);
  for (size_t k = 1; k < starts.size(); ++k) {
    if (starts[k].scene.size() == 0) continue;
    const Bounds more = bounds_of(starts[k].scene.positions);
    for (int axis = 0; axis < 3; ++axis) {
      all.low[axis] = std::min(all.low[axis], more.low[axis]);
      all.high[axis] = std::max(all.high[axis], more.high[axis]);
    }
  }
  return all;
}

void place_ground(Look& look, const std::string& wanted, const std::vector<Start>& starts,
                  std::span<const vec4> spheres, const Vector& up) {
  const Start& first = starts.front();
  const std::string ground = !wanted.empty() ? wanted : first.at_rest ? "lowest" : "plane";
  if (ground == "none") return;
  if (ground == "plane") {
    if (first.at_rest)
      throw std::invalid_argument(
          fmt::format("--ground plane: the spheres of {} are at rest and have no plane; give lowest", first.label));
    return put_ground(look, {0, 1, 0}, double(first.scene.plane));  // for any up direction of the camera
  }
  const double length = std::hypot(up[0], up[1], up[2]);
  const Vector normal = {up[0] / length, up[1] / length, up[2] / length};
  if (ground != "lowest") return put_ground(look, normal, height_of(ground));
  double height = lowest_of(spheres, normal);
  for (size_t k = 1; k < starts.size(); ++k) height = std::min(height, lowest_of(starts[k].scene.positions, normal));
  put_ground(look, normal, height);
}

}  // namespace spherepair
