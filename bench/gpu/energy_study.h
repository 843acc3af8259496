// SPDX-License-Identifier: MIT
// The measurements of spherepair energy.
#pragma once

#include "bench/check/step_result.h"
#include "bench/gpu/energy_window.h"
#include "bench/measure/timing.h"

namespace spherepair {

struct EnergyOptions {
  std::vector<std::string> backends = {};  // empty: all that open
  std::vector<std::string> works = {"all_pairs", "warm", "cold"};
  std::vector<uint64_t> sizes = {};  // empty: by work
  double seconds = 10;               // of a window
  int windows = 5;                   // of each row
  std::string results = {};          // folder; empty: a new one
};

// The timed works: all pairs of a gas by collide_triangle; the grid of the same gas in cell order; and in random order,
// which the grid sorts first.
const std::vector<std::string>& energy_works();

class EnergyStudy {
 public:
  // Calls `write` after every window, so that an interrupted run keeps its measurements. `library`: NVML's.
  EnergyStudy(Session& session, const EnergyOptions& options, std::function<void()> write,
              const std::string& library = "libnvidia-ml.so.1");

  void run();

  json measurements = json::array();  // an entry a row, see spherepair energy

 private:
  struct Row {
    std::string work;
    uint64_t n;
    Configuration configuration;
    std::vector<EnergyWindow> windows = {};
    std::optional<double> others = {};  // the largest share of the cores that other programs kept busy in a window
  };

  const Scene& scene(const Row& row);
  std::vector<Row> all_rows() const;
  void check(const std::vector<Row>& rows);
  void measure_idle();
  void measure(Row& row);
  json to_json(const Row& row) const;
  const std::string& uuid_of(const Row& row) const { return row.configuration.backend->info().uuid; }

  Session& session_;
  const EnergyOptions& options_;
  std::function<void()> write_;
  Progress progress_;
  std::map<std::string, GpuMeter> meters_;                    // by UUID
  std::map<std::string, MeanPower> idle_;                     // the same
  std::map<std::pair<std::string, uint64_t>, Scene> scenes_;  // by work and size
};

}  // namespace spherepair
