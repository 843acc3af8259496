// SPDX-License-Identifier: MIT
// Small runs with contacts, drawn at random, and the same runs cut by checkpoints: both take their steps and write
// their files as `spherepair run` does.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>

#include "bench/run/run_steps.h"

namespace spherepair {

struct DrawnRun {
  uint64_t seed = 0, n = 2, steps = 1;
  ContactLaw law = ContactLaw::spring;
  double ratio = 1;        // of radii
  double restitution = 1;  // spring alone
  double drag_a_step = 0;  // the drag times the time step
  double softness = 1;     // the default stiffness over this run's
  double steps_a_contact = 40;
  float gravity = 0;
  bool walls = false, sleeping = true;
  double fall = 0;        // gravity adds so many of the smallest radius a step to what a sphere falls in a step
  bool squeezed = false;  // the smallest is between two of the largest, which move towards it
};
std::string describe(const DrawnRun& run);

// Spheres so near each other that they touch within few steps. None where the program refuses these parameters.
std::optional<Scene> scene_of(const DrawnRun& run);

// What a run leaves: its last state, its statistics by step, and why and where it failed, if it did.
struct RunEnd {
  Backend::State state;
  MotionState saved;
  std::map<uint64_t, std::string> rows;
  std::string failure;  // without the backend's name
  uint64_t failed_step = 0;
};

// A folder for a test, in memory where the machine has one there: a checkpoint on a disk takes 10 ms.
class FastFolder {
 public:
  FastFolder();
  ~FastFolder();
  FastFolder(const FastFolder&) = delete;
  FastFolder& operator=(const FastFolder&) = delete;
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

// A run of so many steps, cut at these: there it saves a checkpoint, from which the next of the backends goes on. The
// first begins; behind the last comes the first again. Checkpoints and statistics go into the folder.
RunEnd run_with_cuts(const Scene& scene, uint64_t steps, std::span<const uint64_t> cuts,
                     std::span<Backend* const> backends, const FastFolder& folder);

// The first difference, as a sentence; empty where there is none. A cut run has more rows: those at its cuts.
std::string difference_of_ends(const RunEnd& cut, const RunEnd& whole);

// Whether any row has contacts; whether a sphere rests at the end.
bool has_contacts(const RunEnd& end);

}  // namespace spherepair
