// SPDX-License-Identifier: MIT
// The texts about a file that was read.
#include <fmt/format.h>

#include <algorithm>

#include "bench/spheres/sphere_file.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

std::pair<float, float> radius_range(const Scene& scene) {
  if (scene.size() == 0) return {0, 0};
  const auto [low, high] = std::ranges::minmax_element(scene.positions, {}, &vec4::w);
  return {low->w, high->w};
}

}  // namespace

std::string box_warning(const SphereFile& input) {
  if (input.unread_box.empty()) return "";
  return fmt::format(
      "WARNING: a comment has a word for a box, which is not read: {}; pairs across a periodic boundary are not "
      "found\n",
      in_quotes(input.unread_box));
}

std::string describe_file(const SphereFile& input) {
  std::string text = fmt::format("{}: {}", input.file, input.format);
  if (input.frames > 1)
    text += fmt::format(", frame {} of {} (counted from 0; --frame takes another)", input.frame, input.frames);
  if (!input.ignored.empty()) text += fmt::format("\nnot periodic, as asked for: {} is ignored", input.ignored);
  if (input.periodic) text += "\nperiodic: " + input.periodic->text;
  if (!input.units.empty())
    text += fmt::format("\nlengths are in {}, as the file's names say; nothing is converted", input.units);
  if (input.unread_momenta) text += "\nmomenta are not read: give velocities, momenta over masses, as velo:R:3";
  return text + "\n";
}

std::string describe_radii(const SphereFile& input) {
  const auto [low, high] = radius_range(input.scene);
  const std::string count = counted(input.scene.size(), "sphere");
  if (input.scene.size() == 0) return count + "\n";
  return fmt::format("{}, radius {}{}\n", count,
                     low == high ? fmt::format("{}", low) : fmt::format("{} to {}", low, high),
                     input.own_radii ? "" : " by --radius");
}

std::string describe_digits(const SphereFile& input) {
  if (input.scene.size() == 0) return "";
  std::string text = input.changed ? fmt::format("{} of {} {} more digits than float32 keeps\n", input.changed,
                                                 counted(input.values, "number"), input.changed == 1 ? "has" : "have")
                                   : fmt::format("float32 keeps every given digit of the {} numbers\n", input.values);
  const auto& [x, y, z] = input.rounding.shift;
  if (x != 0 || y != 0 || z != 0)
    text += fmt::format("centres shifted by ({}, {}, {}) before rounding, which changes no distance\n", 0 - x, 0 - y,
                        0 - z);
  return text;
}

std::string describe_rounding(const SphereFile& input) {
  if (input.rounding.largest == 0) return "";
  return fmt::format("rounding to float32 moves a {} by {} at most\n", input.ignores_radii ? "point" : "surface",
                     at_most(input.rounding.largest));
}

std::string describe(const SphereFile& input) {
  return describe_file(input) + box_warning(input) + describe_radii(input) + describe_digits(input) +
         describe_rounding(input);
}

json to_json(const SphereFile& input) {
  const auto [low, high] = radius_range(input.scene);
  return {{"file", input.file},
          {"format", input.format},
          {"frame", input.frame},
          {"frames", input.frames},
          {"n", input.scene.size()},
          {"radius_from", input.own_radii ? "file" : "option"},
          {"radii_not_used", input.unused_radii},
          {"smallest_radius", low},
          {"largest_radius", high},
          {"numbers", input.values},
          {"numbers_changed", input.changed},
          {"ignored", input.ignored},
          {"periodic", input.periodic ? input.periodic->text : ""},
          {"shift", input.rounding.shift},
          {"largest_rounding", input.rounding.largest}};
}

}  // namespace spherepair
