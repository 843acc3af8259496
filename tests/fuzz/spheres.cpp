// SPDX-License-Identifier: MIT
// Spheres as text, a line each: what is read and checked is found to have one set of pairs by every method.
#include "bench/spheres/sphere_file.h"
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

FUZZ(spheres) {
  const std::string file = input_file("spheres.txt", text_of(data, size));
  const auto read = unless_refused([&] { return read_sphere_file(file, {.threads = 1}); });
  if (!read) return;
  check_scene(read->scene);
  describe(*read);
  if (read->scene.size() > 200) return;
  fuzzed_backend().upload(read->scene);
  require_one_set();
}
