// SPDX-License-Identifier: MIT
// Where a run starts: a scene by name, spheres from a file, or the checkpoint of another run; and how it moves.
#pragma once

#include <optional>

#include "bench/io/motion_choice.h"
#include "bench/io/output_files.h"
#include "bench/io/report.h"
#include "common/backend/backend.h"
#include "common/scene/motion_state.h"
#include "common/scene/scene.h"

namespace spherepair {

struct StartOptions {
  SceneOptions scene;
  std::string input_file;                                                 // spheres from a file, in place of a scene
  std::optional<float> radius;                                            // of the spheres of that file
  std::optional<uint64_t> frame;                                          // of that file
  MotionChoice motion = {.method = motion_name(MotionMethod::anchored)};  // what the measurements favour
  std::string resume_file;                                                // a checkpoint, in place of all that
};

struct Start {
  Scene scene;
  std::string label, notes;
  json record;
  std::optional<MotionState> motion = {};  // of a run that goes on
  uint64_t step = 0;                       // steps done
};

// A scene, a file of another program, or one of our own text files, in which every sphere has its radius. threads: 0
// takes all cores.
Start start_of(const StartOptions& options, int threads);

// Says that --input and --resume are read.
void add_inputs(OutputFiles& files, const StartOptions& options);

// Uploads the start, or goes on from the checkpoint.
void send(const Start& start, Backend& backend);

}  // namespace spherepair
