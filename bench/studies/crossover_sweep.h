// SPDX-License-Identifier: MIT
// The measurements of spherepair crossover.
#pragma once

#include <map>
#include <set>

#include "bench/check/step_result.h"
#include "bench/measure/timing.h"

namespace spherepair {

struct CrossoverOptions {
  std::vector<std::string> backends;  // empty: all that open
  std::vector<uint64_t> sizes;        // empty: 64 to 2^15
  std::vector<std::string> kinds;     // of spheres, see sphere_kinds(); empty: all
  int rounds = 11;
  double most_ms = 50;  // of a step: slower contenders are not tried at more spheres
  std::string json_file = "crossover.json";
};

struct SphereKind {
  const char *name, *summary, *scene;
  double packing_fraction = 0.3;
  float radius_ratio = 1;
};
std::span<const SphereKind> sphere_kinds();

// Groups in which collide_square is timed, and its name among the ways.
constexpr uint square_groups[] = {32, 64, 128};
std::string square_way(uint block);

// A way to find all pairs that is timed.
struct Way {
  Backend* backend;
  std::string name;  // square_way, another method of all pairs, dense, hashed, or auto
  bool grid;
  CollideOptions options;
};

// What one backend needs for n spheres of a kind.
struct Timing {
  std::string backend, kind;
  uint64_t n;
  std::map<std::string, double> all_pairs = {}, grid = {};  // seconds by way; those not tried are missing
  double automatic = 0;                                     // seconds
  std::string took = {}, best = {};  // what auto stood for; the fastest of the others, empty without any
  double over_best = 1;              // auto's time over that of the best fixed choice
  bool slower = false;               // another choice, by more than 10 % and more than the samples' own spread explains

  bool grid_ahead() const;
};
json to_json(const Timing& timing);

class CrossoverSweep {
 public:
  // `written` is called after every scene, so that nothing timed is lost.
  CrossoverSweep(Session& session, const CrossoverOptions& options, std::function<void()> written);

  // Larger and larger scenes of each kind, as long as auto is not too slow.
  void run(std::span<const SphereKind> kinds, const std::vector<uint64_t>& sizes);

  std::vector<Timing> timings;
  json measurements = json::array();
  std::vector<std::string> given_up;  // what was not tried at more spheres, and why

 private:
  void measure_scene(const SphereKind& kind, const SceneOptions& options);
  void check(const SceneOptions& options, const StepResult& expected, const std::vector<Way>& ways);
  void time(const SphereKind& kind, const SceneOptions& scene, const std::vector<Way>& ways);
  void give_up_if_slow(const Way& way, const Timing& at, double seconds, double fastest);
  void record(const SphereKind& kind, const SceneOptions& scene, const Way& way, const Samples& samples);

  Session& session_;
  const CrossoverOptions& options_;
  std::function<void()> written_;
  Sampling sampling_;
  Progress progress_;
  std::set<std::string> slow_;  // "backend way", of the kind at hand
};

}  // namespace spherepair
