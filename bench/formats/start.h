// SPDX-License-Identifier: MIT
// Makes the start of a run: a named scene, spheres from a file, or a checkpoint; and its motion.
#pragma once

#include <optional>

#include "bench/io/motion_choice.h"
#include "bench/io/output_files.h"
#include "bench/io/report.h"
#include "common/backend/motion.h"
#include "common/scene/motion_state.h"
#include "common/scene/scene.h"

namespace spherepair {

struct StartOptions {
  SceneOptions scene;
  std::string input_file;                                                 // spheres from a file, instead of a scene
  std::optional<double> radius;                                           // of the spheres of that file
  std::optional<uint64_t> frame;                                          // of that file
  std::vector<std::string> columns;                                       // of that file
  bool decimal_comma = false;                                             // of that file, if it is text
  bool ignore_periodic = false;                                           // of that file
  bool species = false;                                                   // whether species of that file are kept
  MotionChoice motion = {.method = motion_name(MotionMethod::anchored)};  // the default: the best in error and time
  std::string resume_file;                                                // a checkpoint, instead of all of the above
};

struct Start {
  Scene scene;
  std::string label, notes;
  json record;
  std::optional<MotionState> motion = {};  // of a resumed run
  uint64_t step = 0;                       // steps done
  bool at_rest = false;                    // the spheres are a file's and none has a velocity
  std::vector<std::string> species = {};   // names, if species were kept ...
  std::vector<uint> species_index = {};    // ... and the index into them of each sphere
  std::string file = {};                   // the file that the spheres come from ...
  bool unread_species = false;             // ... has species that were not asked for
  int length_exponent = 0;                 // lengths are 2^this times the file's: drawing_scale.h
};

// Makes the scene or reads the file or checkpoint. threads: 0: all cores.
Start start_of(const StartOptions& options, int threads);

// A start for each frame of an XYZ file.
std::vector<Start> start_of_frames(const StartOptions& options, int threads);

// A line that says where moving spheres bounce.
std::string plane_text(const Scene& scene);

// Lines with the parameters of contacts, and a warning if the time step is longer than a tenth of a contact. Empty
// without contacts.
std::string describe_contacts(const Scene& scene);

// Warns that --spheres writes no species; empty if the start's file has none.
std::string species_warning(const Start& start);

// Declares --input and --resume as inputs.
void add_inputs(OutputFiles& files, const StartOptions& options);

// Uploads the scene, or resumes from the checkpoint.
void upload_start(const Start& start, Motion& motion);

}  // namespace spherepair
