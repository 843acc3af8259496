// SPDX-License-Identifier: MIT
// The measurements of spherepair crossover.
#pragma once

#include <map>
#include <set>

#include "crossover.h"
#include "session.h"
#include "timing.h"

namespace spherepair {

struct SphereKind {
  const char *name, *summary, *scene;
  double packing_fraction = 0.3;
  float radius_ratio = 1;
};
std::span<const SphereKind> sphere_kinds();

// A way to find all pairs that is timed.
struct Way {
  Backend* backend;
  const char* name;  // all pairs, dense, hashed, auto
  CollideOptions options;
};

// What one backend needs for n spheres of a kind.
struct Timing {
  std::string backend, kind;
  uint64_t n;
  std::map<std::string, double> seconds;  // by way; those not tried are missing
  std::string took;                       // what auto stood for
  double over_best;                       // auto's time over that of the best fixed choice
  bool slower;                            // by more than 10 %, and more than the samples' own spread explains

  bool grid_ahead() const;
};

class CrossoverSweep {
 public:
  CrossoverSweep(Session& session, const CrossoverOptions& options);

  // Larger and larger scenes, as long as auto is not too slow.
  void walk(const SphereKind& kind, const std::vector<uint64_t>& sizes);

  std::vector<Timing> timings;
  json measurements = json::array();

 private:
  void measure_scene(const SphereKind& kind, const SceneOptions& options);
  void check(const SceneOptions& options, const Scene& scene, const std::vector<Way>& ways);
  void time(const SphereKind& kind, const SceneOptions& scene, const std::vector<Way>& ways);
  void record(const SphereKind& kind, const SceneOptions& scene, const Way& way, const Samples& samples);

  Session& session_;
  const CrossoverOptions& options_;
  Sampling sampling_;
  Progress progress_;
  std::set<std::string> slow_;  // "backend way"
};

}  // namespace spherepair
