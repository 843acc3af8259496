// SPDX-License-Identifier: MIT
// The measurements of `spherepair sets`: numbers of wrong pairs by cause.
//
// sets.json, "format": "spherepair sets 1":
//   context, backends, warnings, clocks   as in results.json (report.h, context.h)
//   settings   {n, seconds: T, seed, restitution, speed: greatest horizontal speed along x and along z, m/s}
//   motion     the set at T against the closed form's at T, one entry per method, precision, k (dt = 2^-k s) and offset
//              (metres from the origin along x and z, at the start):
//     {method, precision, k, dt, offset, backends: all found the same set,
//      right                     pairs of the closed form
//      missed, extra             of the collision step, which uses the nearest float32 positions
//      whole_missed, whole_extra with positions in the full precision
//      rms                       position error, metres}
//   storage    the set of centres moved by `offset` along x, y and z and stored in a precision, against that of the
//              centres moved without rounding:
//     {precision, offset, right, missed, extra}
//   exactness  the naive float32 predicate against the exact one, one entry per backend and scene:
//     {backend, method, scene, n, right, missed, extra, exact, naive: times of a step, as to_json(Samples)}
//   contacts   pairs that pass through each other, tested once per step; one entry per backend and distance:
//     {backend, distance: moved per step, in sums of radii, pairs, missed, expected, deviation: one sigma,
//     swept_missed: by the swept test}
#pragma once

#include "bench/check/exact_sets.h"
#include "bench/measure/session.h"
#include "bench/measure/timing.h"

namespace spherepair {

struct SetPlan {
  std::vector<MotionOptions> motions = all_motions();
  std::vector<int> steps = {};      // k of dt = 2^-k, at the origin
  int far_step = 6;                 // k at an offset
  std::vector<float> offsets = {};  // metres
  std::vector<double> distances = {0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 5.0};
  double seconds = 10;  // T
  uint64_t n = 16384, naive_n = 16384, passing = 8192;
  uint64_t seed = SceneOptions{}.seed;
  uint64_t most_software_steps = 1300;  // of a run in software OpenGL, which leaves out longer ones
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
  double distance;
  uint64_t pairs, missed, swept_missed;
  double expected() const;
  double deviation() const;
};

// The scene `random` with horizontal velocities of up to 1 m/s, centres moved by `offset` along x and z.
Scene drifting_scene(const SetPlan& plan, MotionOptions motion, int k, float offset);

// Every backend makes all runs, except software OpenGL. Throws DifferenceFound if two results differ.
std::vector<MotionSetEntry> measure_motion_sets(Session& session, const SetPlan& plan, Progress& progress);
std::vector<StorageEntry> measure_storage(const SetPlan& plan, Progress& progress);
std::vector<NaiveEntry> measure_naive(Session& session, const SetPlan& plan, Progress& progress);
std::vector<ContactEntry> measure_contacts(Session& session, const SetPlan& plan, Progress& progress);

json to_json(const MotionSetEntry& entry);
json to_json(const StorageEntry& entry);
json to_json(const NaiveEntry& entry);
json to_json(const ContactEntry& entry);

}  // namespace spherepair
