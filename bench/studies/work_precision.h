// SPDX-License-Identifier: MIT
// Error and run time of every motion method: the measurements of `spherepair precision`.
//
// precision.json, "format": "spherepair precision 1":
//   context, backends, warnings, clocks   as in results.json (report.h, context.h)
//   settings   {seconds: T, error_n, time_n, seed, restitution}
//   errors     one entry per method, precision, k (dt = 2^-k s) and backend:
//     {method, precision, k, dt, backend,
//      rms, largest                position error at T against the closed form, metres
//      rms_over_time, largest_over_time   their maxima over T/16, 2T/16 ... T
//      energy                      largest relative change of a sphere's energy at T}
//   times      one entry per method, precision, k, work and backend; work is "move", for `anchored` also
//              "move and evaluate" (positions evaluated at every step, as a collision step needs them):
//     {method, precision, k, dt, work, backend, n, bouncing: share of the spheres that bounce in a step,
//      seconds_per_sphere_step, low, high   median and its 95 % interval, seconds
//      bytes_per_sphere_step       minimum memory traffic of the kernel; null if it depends on the bounces
//      sample                      as to_json(Samples)}
//   copies     copying positions to velocities on each device, the peak rate of every step:
//     {backend, n, bytes_per_second, sample}
#pragma once

#include "bench/measure/session.h"
#include "bench/measure/timing.h"

namespace spherepair {

struct PrecisionPlan {
  std::vector<MotionOptions> motions = all_motions();
  std::vector<int> error_steps, time_steps;  // k of dt = 2^-k
  double seconds = 10;                       // T
  uint64_t error_n = 100, time_n = 1 << 22;
  uint64_t seed = SceneOptions{}.seed;
  uint64_t most_software_steps = 3000;  // of an error run in software OpenGL, which leaves out longer ones
  Sampling sampling;
};

struct ErrorEntry {
  MotionOptions motion;
  int k;
  std::string backend;
  double rms, largest, rms_over_time, largest_over_time, energy;
};

struct TimeEntry {
  MotionOptions motion;
  int k;
  std::string work, backend;
  uint64_t n;
  double bouncing;
  Samples samples;
  double per_sphere() const { return samples.median_seconds() / double(n); }
};

struct CopyEntry {
  std::string backend;
  uint64_t n;
  Samples samples;
  double bytes_per_second() const { return 2 * sizeof(vec4) * double(n) / samples.median_seconds(); }
};

// Minimum memory traffic per sphere of the kernels of one step; none if it depends on the bounces.
std::optional<uint64_t> bytes_per_sphere_step(const TimeEntry& entry);

// Measures on every backend. Throws DifferenceFound if the final states differ in any bit.
std::vector<ErrorEntry> measure_errors(Session& session, const PrecisionPlan& plan, Progress& progress);
// Times backends in interleaved rounds, on spheres that have bounced for some time. First compares the states after
// some steps; throws DifferenceFound.
std::vector<TimeEntry> measure_times(Session& session, const PrecisionPlan& plan, Progress& progress);

// Measures on every device, at the size of the timings.
std::vector<CopyEntry> measure_copies(Session& session, const PrecisionPlan& plan, Progress& progress);

json to_json(const ErrorEntry& entry);
json to_json(const TimeEntry& entry);
json to_json(const CopyEntry& entry);

}  // namespace spherepair
