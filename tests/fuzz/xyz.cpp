// SPDX-License-Identifier: MIT
// XYZ, extended XYZ and LAMMPS dumps (ITEM is their first word): every backend takes the scene that is read.
#include <tuple>

#include "bench/spheres/sphere_file.h"
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

FUZZ(xyz) {
  const std::string_view text = text_of(data, size);
  const std::string file = input_file(text.starts_with("ITEM") ? "spheres.dump" : "spheres.xyz", text);
  const SphereFileOptions own_radii = {.threads = 1}, one_radius = {.radius = 0.5f, .threads = 1};
  const SphereFileOptions second = {.radius = 0.5f, .frame = 1, .threads = 1};
  for (const SphereFileOptions& options : {own_radii, one_radius, second}) {
    const auto input = unless_refused([&] { return read_sphere_file(file, options); });
    if (!input) continue;
    check_scene(input->scene);
    describe(*input);
    to_json(*input).dump();
  }
  const SphereFileOptions with_species = {.radius = 0.5f, .species = true, .threads = 1};
  const auto frames = unless_refused([&] { return read_sphere_frames(file, with_species); });
  if (!frames) return;
  for (const SphereFile& frame : *frames) {
    check_scene(frame.scene);
    for (const uint species : frame.species_index) std::ignore = frame.species.at(species);
  }
}
