// SPDX-License-Identifier: MIT
// NPZ: what is read is a scene that every backend takes, or one in a periodic box.
#include "bench/spheres/sphere_file.h"
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string file = input_file("spheres.npz", text_of(data, size));
  const SphereFileOptions own_radii = {.take_periodic = true, .threads = 1};
  const SphereFileOptions one_radius = {
      .radius = 0.5f, .columns = {"pos=positions"}, .take_periodic = true, .threads = 1};
  for (const SphereFileOptions& options : {own_radii, one_radius}) {
    const auto input = unless_refused([&] { return read_sphere_file(file, options); });
    if (!input) continue;
    check_scene(input->scene);
    if (input->periodic) require(input->periodic->set.size() == input->scene.size(), "spheres outside the box");
    describe(*input);
    to_json(*input).dump();
  }
  return 0;
}
