// SPDX-License-Identifier: MIT
// How many pairs are wrong, and what makes them so: what `spherepair sets` measures.
//
// sets.json, "format": "spherepair sets 1":
//   context, backends, warnings, clocks   as in results.json (report.h, context.h)
//   settings   {n, seconds: T, seed, restitution, speed: horizontal, up to so many m/s along x and z}
//   motion     the set at T against that of the closed form at T, one entry for each method, precision, k (dt = 2^-k s)
//              and offset (metres from the origin along x and z, at the start):
//     {method, precision, k, dt, offset, backends: that found this same set,
//      right                     pairs of the closed form
//      missed, extra             of the collision step, which takes the nearest float32 positions
//      whole_missed, whole_extra if it took positions with all bits of the precision
//      rms                       position error, metres}
//   storage    the set of centres moved by `offset` along x, y and z and stored in a precision, against that of the
//              centres moved without rounding:
//     {precision, offset, right, missed, extra}
//   exactness  the naive float32 predicate against the exact one, one entry for each backend and scene:
//     {backend, method, scene, n, right, missed, extra, exact, naive: times of a step, as to_json(Samples)}
//   contacts   pairs that pass through each other, `way` radii sums a step, tested once a step; one for each backend:
//     {backend, way, pairs, missed, expected, deviation: one sigma, swept_missed: by the swept test}
#pragma once

#include "bench/check/exact_sets.h"
#include "bench/measure/session.h"
#include "bench/measure/timing.h"

namespace spherepair {

struct SetPlan {
  std::vector<MotionOptions> motions = all_motions();
  std::vector<int> steps = {};      // k of dt = 2^-k, at the origin
  int far_step = 6;                 // k away from it
  std::vector<float> offsets = {};  // metres
  std::vector<double> ways = {0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 5.0};
  double seconds = 10;  // T
  uint64_t n = 16384, naive_n = 16384, passing = 8192;
  uint64_t seed = SceneOptions{}.seed;
  uint64_t most_software_steps = 1300;  // where OpenGL is software; longer runs are left to the others
  Sampling sampling = {};
};

struct MotionSetEntry {
  MotionOptions motion;
  int k;
  float offset;
  std::vector<std::string> backends;
  SetError found, whole;
  double rms;
};
struct StorageEntry {
  Precision precision;
  float offset;
  SetError error;
};
struct NaiveEntry {
  std::string method, scene;
  uint64_t n;
  SetError error;
  Samples exact, naive;
};
struct ContactEntry {
  std::string backend;
  double way;
  uint64_t pairs, missed, swept_missed;
  double expected() const;
  double deviation() const;
};

// The scene `random` with horizontal velocities of up to 1 m/s, centres moved by `offset` along x and z.
Scene drifting_scene(const SetPlan& plan, MotionOptions motion, int k, float offset);

// Every backend runs all of it, but for OpenGL in software. Throws DifferenceFound when two answer differently.
std::vector<MotionSetEntry> measure_motion_sets(Session& session, const SetPlan& plan, Progress& progress);
std::vector<StorageEntry> measure_storage(const SetPlan& plan, Progress& progress);
std::vector<NaiveEntry> measure_naive(Session& session, const SetPlan& plan, Progress& progress);
std::vector<ContactEntry> measure_contacts(Session& session, const SetPlan& plan, Progress& progress);

json to_json(const MotionSetEntry& entry);
json to_json(const StorageEntry& entry);
json to_json(const NaiveEntry& entry);
json to_json(const ContactEntry& entry);

}  // namespace spherepair
