// SPDX-License-Identifier: MIT
// The measurements of spherepair crossover.
#pragma once

#include <map>
#include <set>

#include "bench/check/step_result.h"
#include "bench/measure/timing.h"

namespace spherepair {

struct CrossoverOptions {
  std::vector<std::string> backends = {};  // empty: all that open
  std::vector<uint64_t> sizes = {};        // empty: 64 to 2^15
  std::vector<std::string> kinds = {};     // of spheres, see sphere_kinds(); empty: all
  int rounds = 11;
  double most_ms = 50;       // of a step: slower methods are not timed with more spheres
  std::string results = {};  // folder; empty: a new one
};

struct SphereKind {
  const char *name, *summary, *scene;
  double packing_fraction = 0.3;
  float radius_ratio = 1;
};
std::span<const SphereKind> sphere_kinds();

// Group sizes of collide_square, and its name among the ways.
constexpr uint square_groups[] = {32, 64, 128};
std::string square_way(uint block);

// A timed way to find all pairs.
struct Way {
  Backend* backend;
  std::string name;  // square_way(), another method of all pairs, dense, hashed or auto
  bool grid;
  CollideOptions options;
};

// Times of one backend for n spheres of one kind.
struct Timing {
  std::string backend, kind;
  uint64_t n;
  std::map<std::string, double> all_pairs = {}, grid = {};  // seconds by way; without stopped ways
  double automatic = 0;                                     // seconds
  std::set<std::string> unsteady = {};                      // ways, auto among them, whose times decide nothing
  std::string chosen = {}, best = {};  // auto's choice; the fastest other way, empty if there is none
  Contest over_best = {};              // auto against `best`
};
json to_json(const Timing& timing);

// Whether auto takes more than 1.1x the time of the best fixed way, by the interval of the rounds' ratios.
enum class Loss { within, beyond, undecided };
Loss loss_of(const Timing& timing);

class CrossoverSweep {
 public:
  // Calls `write` after every scene, so that an interrupted run keeps its measurements.
  CrossoverSweep(Session& session, const CrossoverOptions& options, std::function<void()> write);

  // Times scenes of increasing size for each kind, until auto is too slow.
  void run(std::span<const SphereKind> kinds, const std::vector<uint64_t>& sizes);

  std::vector<Timing> timings;
  json measurements = json::array();
  std::vector<std::string> stopped;  // ways that were not timed with more spheres, with the reason

 private:
  void measure_scene(const SphereKind& kind, const SceneOptions& options);
  void check(const SceneOptions& options, const StepResult& expected, const std::vector<Way>& ways);
  void time(const SphereKind& kind, const SceneOptions& scene, const std::vector<Way>& ways);
  void stop_if_slow(const Way& way, const Timing& at, double seconds, double fastest);
  void compare(Timing& timing, const std::vector<Way>& ways, const std::vector<Samples>& samples);
  void record(const SphereKind& kind, const SceneOptions& scene, const Way& way, const Samples& samples);

  Session& session_;
  const CrossoverOptions& options_;
  std::function<void()> write_;
  Sampling sampling_;
  Progress progress_;
  std::set<std::string> slow_;  // stopped ways of the current kind, as "backend way"
};

}  // namespace spherepair
