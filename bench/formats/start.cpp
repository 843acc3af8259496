// SPDX-License-Identifier: MIT
#include "bench/formats/start.h"

#include <fmt/format.h>

#include "bench/formats/checkpoint.h"
#include "bench/formats/sphere_file.h"
#include "bench/io/scene_text.h"

namespace spherepair {

namespace {

Start start_from_checkpoint(const std::string& file) {
  Checkpoint saved = read_checkpoint(file);
  const json record = {{"file", file}, {"n", saved.scene.size()}, {"step", saved.step}};
  const std::string label = fmt::format("{} from step {}", saved.scene.name, saved.step);
  return {std::move(saved.scene), label, "", record, std::move(saved.motion), saved.step};
}

}  // namespace

Start start_of(const StartOptions& options, int threads) {
  if (!options.resume_file.empty()) return start_from_checkpoint(options.resume_file);
  const std::string& file = options.input_file;
  if (file.empty()) {
    SceneOptions scene = options.scene;
    choose_motion(scene, options.motion);
    return {make_scene(scene), scene_label(scene), "", scene_json(scene)};
  }
  SphereFile input = read_sphere_file(file, {.radius = options.radius,
                                             .frame = options.frame,
                                             .columns = options.columns,
                                             .ignore_periodic = options.ignore_periodic,
                                             .threads = threads});
  choose_motion(input.scene, options.motion);
  const std::string notes = describe(input), label = input.scene.name;
  const json record = to_json(input);
  return {std::move(input.scene), label, notes, record, std::nullopt, 0, std::move(input.rounding)};
}

void add_inputs(OutputFiles& files, const StartOptions& options) {
  files.read("--input", options.input_file);
  files.read("--resume", options.resume_file);
}

void upload_start(const Start& start, Backend& backend) {
  start.motion ? backend.resume(start.scene, *start.motion) : backend.upload(start.scene);
}

}  // namespace spherepair
