// SPDX-License-Identifier: MIT
// Spheres as text, a line each: what is read and checked is found to have one set of pairs by every method.
#include "bench/formats/files.h"
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string file = input_file("spheres.txt", text_of(data, size));
  const auto scene = unless_refused([&] {
    const Scene read = read_spheres(file);
    check_scene(read);
    return read;
  });
  if (!scene || scene->size() > 200) return 0;
  fuzzed_backend().upload(*scene);
  require_one_set();
  return 0;
}
