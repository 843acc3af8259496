// SPDX-License-Identifier: MIT
// The texts about a file that was read.
#include <fmt/format.h>

#include <algorithm>

#include "bench/spheres/sphere_file.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

std::pair<double, double> radius_range(const SphereFile& input) {
  const std::vector<double>& given = input.given.set.radii;
  if (!given.empty()) return {std::ranges::min(given), std::ranges::max(given)};
  if (input.scene.size() == 0) return {0, 0};
  const auto [low, high] = std::ranges::minmax_element(input.scene.positions, {}, &vec4::w);
  return {low->w, high->w};
}

// How many digits are lost, and how far that moves a surface.
std::string describe_rounding(const SphereFile& input) {
  if (input.scene.size() == 0) return "";
  std::string text = input.changed ? fmt::format("{} of {} {} more digits than float32 keeps\n", input.changed,
                                                 counted(input.values, "number"), input.changed == 1 ? "has" : "have")
                                   : fmt::format("float32 keeps every given digit of the {} numbers\n", input.values);
  if (input.largest_rounding > 0)
    text += fmt::format("rounding to float32 moves a surface by {} at most\n", at_most(input.largest_rounding));
  return text;
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
  if (!input.periodic.empty()) text += "\nperiodic: " + input.periodic;
  if (!input.units.empty())
    text += fmt::format("\nlengths are in {}, as the file's names say; nothing is converted", input.units);
  if (input.unread_momenta) text += "\nmomenta are not read: give velocities, momenta over masses, as velo:R:3";
  return text + "\n";
}

std::string describe_radii(const SphereFile& input) {
  const auto [low, high] = radius_range(input);
  const std::string count = counted(input.size(), "sphere");
  if (input.size() == 0) return count + "\n";
  const bool rounded = input.scene.size() > 0;
  const auto text = [&](double radius) { return rounded ? fmt::to_string(float(radius)) : fmt::to_string(radius); };
  return fmt::format("{}, radius {}{}\n", count, low == high ? text(low) : text(low) + " to " + text(high),
                     input.own_radii ? "" : " by --radius");
}

std::string describe(const SphereFile& input) {
  return describe_file(input) + box_warning(input) + describe_radii(input) + describe_rounding(input);
}

json to_json(const SphereFile& input) {
  const auto [low, high] = radius_range(input);
  return {{"file", input.file},
          {"format", input.format},
          {"frame", input.frame},
          {"frames", input.frames},
          {"n", input.size()},
          {"radius_from", input.own_radii ? "file" : "option"},
          {"radii_not_used", input.unused_radii},
          {"smallest_radius", low},
          {"largest_radius", high},
          {"numbers", input.values},
          {"numbers_changed", input.changed},
          {"ignored", input.ignored},
          {"periodic", input.periodic},
          {"largest_rounding", input.largest_rounding}};
}

}  // namespace spherepair
