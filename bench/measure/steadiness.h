// SPDX-License-Identifier: MIT
// Tells which times decide nothing: those of a busy machine, and those that scatter.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/io/machine_load.h"
#include "bench/measure/statistics.h"

namespace spherepair {

class Session;

constexpr double widest_interval = 2;  // high over low of an interval that may still decide

// The reasons why a time decides nothing; empty if it may decide. others: share of the machine's cores that other
// programs kept busy.
std::vector<std::string> unsteady(const Interval& interval, std::optional<double> others);

// Timings of a session.
struct TimingCounts {
  uint64_t all = 0, unsteady = 0;
  void add(bool is_unsteady) { ++all, unsteady += is_unsteady; }
};

// Watches the machine during a study, and warns readers about its times.
class StudyLoad {
 public:
  explicit StudyLoad(const Clocks& clocks);  // takes 0.2 s; make it before the study's own work
  StudyLoad(const StudyLoad&) = delete;
  StudyLoad& operator=(const StudyLoad&) = delete;

  std::vector<std::string> warnings(const Session& session) const;  // the session's warnings and those about times
  std::string text(const Session& session) const;                   // warnings about times, below tables

 private:
  std::vector<std::string> own(const Session& session) const;
  Clocks clocks_;
  std::optional<double> start_;
  OtherPrograms since_;
};

}  // namespace spherepair
