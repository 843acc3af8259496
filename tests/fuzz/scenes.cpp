// SPDX-License-Identifier: MIT
// Scenes of any parameters: made, moved and searched on the CPU backend, or refused.
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

namespace {

SceneOptions options_of(Values& values) {
  SceneOptions options;
  options.name = values.among(scene_kinds()).name;
  options.motion = values.among(all_motions());
  options.n = values.next<uint8_t>();
  options.seed = values.next<uint16_t>();
  if (values.next<uint8_t>() % 2) options.groups = values.next<uint8_t>(), options.group_size = values.next<uint8_t>();
  for (float* number : {&options.radius, &options.radius_ratio, &options.offset, &options.dt, &options.restitution})
    if (values.next<uint8_t>() % 2) *number = values.next<float>();
  if (values.next<uint8_t>() % 2) options.packing_fraction = values.next<double>();
  return options;
}

}  // namespace

FUZZ(scenes) {
  Values values(data, size);
  const SceneOptions options = options_of(values);
  unless_refused([&] {
    fuzzed_backend().upload(make_scene(options));
    for (int step = 0; step < 3; ++step) fuzzed_backend().move();
    require_one_set();
    return true;
  });
}
