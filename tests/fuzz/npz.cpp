// SPDX-License-Identifier: MIT
// NPZ: what is read is a list's problem, in a periodic box or not.
#include "bench/spheres/sphere_file.h"
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

FUZZ(npz) {
  const std::string file = input_file("spheres.npz", text_of(data, size));
  const SphereFileOptions own_radii = {.exact = true, .threads = 1};
  const SphereFileOptions one_radius = {.radius = 0.5f, .columns = {"pos=positions"}, .exact = true, .threads = 1};
  for (const SphereFileOptions& options : {own_radii, one_radius}) {
    const auto input = unless_refused([&] { return read_sphere_file(file, options); });
    if (!input) continue;
    require(input->scene.size() == 0 && input->given.set.radii.size() == input->size(), "rounded spheres");
    describe(*input);
    to_json(*input).dump();
  }
}
