// SPDX-License-Identifier: MIT
#include "start.h"

#include <fmt/format.h>

#include "answers.h"
#include "files.h"
#include "sphere_file.h"

namespace spherepair {

Start start_of(const StartOptions& options, int threads) {
  const std::string& file = options.input_file;
  if (file.empty()) return {make_scene(options.scene), scene_label(options.scene), "", scene_json(options.scene)};
  if (is_sphere_file(file)) {
    SphereFile input = read_sphere_file(file, {.radius = options.radius, .frame = options.frame, .threads = threads});
    const std::string notes = describe(input), label = input.scene.name;
    const json record = to_json(input);
    return {std::move(input.scene), label, notes, record};
  }
  if (options.radius || options.frame)
    throw std::invalid_argument(fmt::format("{} has a radius on each line and no frames: leave {} out", file,
                                            options.radius ? "--radius" : "--frame"));
  Scene scene = read_spheres(file);
  const json record = {{"file", file}, {"n", scene.size()}};
  const std::string label = scene.name;
  return {std::move(scene), label, "", record};
}

}  // namespace spherepair
