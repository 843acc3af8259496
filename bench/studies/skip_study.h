// SPDX-License-Identifier: MIT
// The measurements of spherepair skips.
#pragma once

#include "bench/check/answers.h"
#include "bench/measure/timing.h"
#include "bench/studies/skip_list.h"

namespace spherepair {

struct SkipsOptions {
  std::vector<std::string> backends, names;  // empty: all that open, all skips and tricks
  std::vector<uint64_t> sizes;               // empty: one that suits the machine
  double packing_fraction = 0.3;
  int rounds = 11;
  std::string json_file = "skips.json";
};

// Seconds of the host, by what for.
struct SkipSeconds {
  double opening = 0, uploading = 0, checking = 0, timing = 0;
};

class SkipStudy {
 public:
  // `written` is called after every row, so that nothing timed is lost.
  SkipStudy(Session& session, const OpenOptions& open, const SkipsOptions& options, std::function<void()> written);

  void run(const std::vector<uint64_t>& sizes);

  std::vector<std::vector<std::string>> rows;  // of the table
  json measurements = json::array();
  std::vector<std::string> left_out;
  SkipSeconds spent;

 private:
  struct Turn {  // both ways of one skip on one backend
    const Skip* skip;
    Backend *on, *off;
  };

  std::vector<Turn> turns();
  const Scene& scene(Spheres kind);
  void hold(Backend& backend, Spheres kind);
  const Answer& expected(Spheres kind);
  Asked reference();
  void check(const Turn& turn);
  void check_sets(const Turn& turn);
  void check_moves(const Turn& turn);
  void take(Turn turn);
  void time(const Turn& turn);
  void record(const Turn& turn, const Contender& contender, const Samples& samples, bool on);

  Session& session_;
  OpenOptions open_;
  const SkipsOptions& options_;
  std::function<void()> written_;
  Sampling sampling_;
  Progress progress_;
  SceneOptions scene_options_;
  std::map<Spheres, Scene> scenes_;            // of this size, made when first asked for
  std::map<Spheres, Answer> expected_;         // of the reference
  std::map<const Backend*, Spheres> holding_;  // what each backend was given and has not moved on from
};

}  // namespace spherepair
