// SPDX-License-Identifier: MIT
// Small random runs with contacts, and the same runs cut by checkpoints. Both step and write files like `spherepair
// run`.
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
  double fall = 0;        // g dt^2 in smallest radii: how much farther a sphere falls in each next step
  bool squeezed = false;  // the smallest sphere is between two of the largest, which move towards it
};
std::string describe(const DrawnRun& run);

// Spheres so near each other that they touch within a few steps. None if the program refuses these parameters.
std::optional<Scene> scene_of(const DrawnRun& run);

// The result of a run: its last state, its statistics by step, and the step and the reason of a failure.
struct RunEnd {
  Motion::State state;
  MotionState saved;
  std::map<uint64_t, std::string> rows;
  std::string failure;  // without the backend's name
  uint64_t failed_step = 0;
};

// A folder for a test, in memory if the machine has such a folder: a checkpoint on a disk takes 10 ms.
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

// Makes a run of `steps` steps, cut at `cuts`: at each cut it saves a checkpoint, from which the next backend
// continues. The first backend begins; after the last comes the first again. Checkpoints and statistics go into the
// folder.
RunEnd run_with_cuts(const Scene& scene, uint64_t steps, std::span<const uint64_t> cuts,
                     std::span<Backend* const> backends, const FastFolder& folder);

// The first difference as a sentence; empty if there is none. A cut run has additional rows at its cuts.
std::string difference_of_ends(const RunEnd& cut, const RunEnd& whole);

// Whether any row has contacts; whether a sphere rests at the end.
bool has_contacts(const RunEnd& end);

}  // namespace spherepair
