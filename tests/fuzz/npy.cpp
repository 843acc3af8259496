// SPDX-License-Identifier: MIT
// NPY: what is read is a scene that every backend takes.
#include "bench/spheres/sphere_file.h"
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

FUZZ(npy) {
  const std::string file = input_file("spheres.npy", text_of(data, size));
  const SphereFileOptions own_radii = {.threads = 1}, one_radius = {.radius = 0.5f, .threads = 1};
  for (const SphereFileOptions& options : {own_radii, one_radius}) {
    const auto input = unless_refused([&] { return read_sphere_file(file, options); });
    if (!input) continue;
    check_scene(input->scene);
    describe(*input);
    to_json(*input).dump();
  }
}
