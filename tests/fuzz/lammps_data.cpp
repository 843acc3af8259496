// SPDX-License-Identifier: MIT
// LAMMPS data files: what is read is a scene that every backend takes, or one in a periodic box.
#include <tuple>

#include "bench/spheres/sphere_file.h"
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

FUZZ(lammps_data) {
  const std::string file = input_file("spheres.data", text_of(data, size));
  const SphereFileOptions own_radii = {.ignore_periodic = true, .threads = 1};
  const SphereFileOptions one_radius = {.radius = 0.5f, .species = true, .ignore_periodic = true, .threads = 1};
  const SphereFileOptions named = {.radius = 0.5f, .columns = {"_", "x", "y", "z"}, .exact = true, .threads = 1};
  for (const SphereFileOptions& options : {own_radii, one_radius, named}) {
    const auto input = unless_refused([&] { return read_sphere_file(file, options); });
    if (!input) continue;
    check_scene(input->scene);
    for (const uint species : input->species_index) std::ignore = input->species.at(species);
    require(options.exact != input->periodic.empty(), "the box is lost");
    require(input->given.set.size() == (options.exact ? input->size() : 0), "rounded spheres");
    describe(*input);
    to_json(*input).dump();
  }
}
