// SPDX-License-Identifier: MIT
#include "bench/check/rounding_reach.h"

#include <fmt/format.h>

namespace spherepair {
namespace {

uint64_t pairs_of(Search& search, const Scene& scene, std::vector<vec4> spheres, CollideOptions options) {
  Scene other{.name = scene.name, .velocities = std::vector<vec4>(spheres.size(), vec4{0, 0, 0, 0})};
  other.positions = std::move(spheres);
  other.equal_radii = false;
  options.want_pairs = false;
  search.upload(other);
  search.collide(options);
  return search.collisions().pairs;
}

}  // namespace

uint64_t pairs_within_reach(Search& search, const Scene& scene, const Rounding& rounding,
                            const CollideOptions& options) {
  if (rounding.reach.empty()) return 0;
  const uint64_t possible = pairs_of(search, scene, grown(scene.positions, rounding.reach), options);
  return possible - pairs_of(search, scene, shrunk(scene.positions, rounding.reach), options);
}

std::string reach_warning(uint64_t pairs, const Rounding& rounding, bool of_points) {
  if (pairs == 0) return "";
  return fmt::format(
      "WARNING: {} so close to {} that rounding the file's numbers to float32, which moves a {} "
      "by up to {}, can decide {}. The float32 {} are decided exactly. To have fewer such pairs, write "
      "positions relative to a point near the spheres, or in numbers that float32 represents.",
      pairs == 1 ? "1 pair is" : fmt::format("{} pairs are", pairs), of_points ? "the cutoff" : "touching",
      of_points ? "point" : "surface", at_most(rounding.largest), pairs == 1 ? "it" : "them",
      of_points ? "points" : "spheres");
}

}  // namespace spherepair
