// SPDX-License-Identifier: MIT
// The backends of this process: the open ones, the missing ones with the reason, and the times of first steps.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/open.h"
#include "bench/io/report.h"
#include "bench/measure/comparisons.h"
#include "bench/measure/steadiness.h"
#include "common/backend/backend.h"

namespace spherepair {

// open_backend; a test replaces it to open backends that return wrong results.
using Opener = std::function<std::unique_ptr<Backend>(const std::string& name, const OpenOptions& options)>;

class Session {
 public:
  // With an empty list, opens every available backend and notes the missing ones; a named backend must open.
  Session(const std::vector<std::string>& names, const OpenOptions& options, const Opener& opener = open_backend);

  const std::vector<std::unique_ptr<Backend>>& backends() const { return backends_; }
  const OpenOptions& options() const { return options_; }
  std::vector<Backend*> devices() const;  // all but the CPU
  Backend* find(const std::string& name) const;

  // Two devices whose times are compared: each with the baseline, which is CUDA, else the first device.
  struct Versus {
    Backend *device, *baseline;
  };
  std::vector<Versus> contests() const;

  // The CPU, or the first open backend: the others are compared with it.
  Backend& reference() const { return *backends_.front(); }

  // Comparisons of the whole run: every check plans its own, and every comparison that finds equality counts.
  Comparisons comparisons;

  TimingCounts timings;  // of the whole run

  // Runs a complete search. Keeps the time of a kernel's first use in this process, which compiles it.
  void collide(Search& search, const CollideOptions& options);
  double first_seconds(const Search& search, const CollideOptions& options) const;

  // The device timer's reading of an empty kernel in seconds, measured once an API: shorter readings of stages mean
  // nothing. None without a timer.
  std::optional<double> timer_floor(Backend& backend);

  // Bytes of the GPU's L2 cache, from CUDA, also for OpenGL on the same GPU. None if nothing reports it.
  std::optional<uint64_t> l2_bytes(const Backend& backend) const;

  std::string summary() const;                // one line per backend, missing ones with the reason
  std::vector<std::string> warnings() const;  // about the validity of the results
  json to_json() const;

 private:
  struct Missing {
    std::string name, reason;
  };
  OpenOptions options_;
  std::vector<std::unique_ptr<Backend>> backends_;
  std::vector<Missing> missing_;
  std::map<std::string, double> first_, timer_floors_;
};

bool on_hardware(const Backend& backend);  // a GPU: neither the CPU nor OpenGL or Vulkan in software
// ", " and the last transfer of spheres to OpenGL's pipeline; empty without a transfer.
std::string transfer_in_words(const Drawing& drawing);

std::string device_label(const BackendInfo& info);

}  // namespace spherepair
