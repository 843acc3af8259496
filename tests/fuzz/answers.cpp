// SPDX-License-Identifier: MIT
// Any float32 numbers as spheres of an NPY file: every method finds one set of pairs. The first byte says whether all
// radii are equal.
#include <fmt/format.h>

#include "bench/spheres/sphere_file.h"
#include "tests/fuzz/fuzz.h"
#include "tests/support/sphere_files.h"

using namespace spherepair;

FUZZ(answers) {
  Values values(data, size);
  const bool equal_radii = values.next<uint8_t>() % 2;
  const auto radius = equal_radii ? std::optional<double>(values.next<float>()) : std::nullopt;
  const size_t columns = equal_radii ? 3 : 4, row = columns * sizeof(float);
  const size_t rows = std::min<size_t>(values.rest().size() / row, 200);
  const std::string header = npy_header("<f4", fmt::format("({}, {})", rows, columns));
  const std::string file = npy_file(header, std::string(values.rest().substr(0, rows * row)));
  const auto input = unless_refused(
      [&] { return read_sphere_file(input_file("spheres.npy", file), {.radius = radius, .threads = 1}); });
  if (!input) return;
  fuzzed_backend().upload(input->scene);
  require_one_set();
}
