// SPDX-License-Identifier: MIT
// Where a run starts: a scene by name, or spheres from a file.
#pragma once

#include <optional>

#include "report.h"
#include "scene.h"

namespace spherepair {

struct StartOptions {
  SceneOptions scene;
  std::string input_file;         // spheres from a file, in place of a scene
  std::optional<float> radius;    // of the spheres of that file
  std::optional<uint64_t> frame;  // of that file
};

struct Start {
  Scene scene;
  std::string label, notes;
  json record;
};

// A scene, a file of another program, or one of our own text files, in which every sphere has its radius. threads: 0
// takes all cores.
Start start_of(const StartOptions& options, int threads);

}  // namespace spherepair
