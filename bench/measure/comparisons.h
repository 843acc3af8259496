// SPDX-License-Identifier: MIT
// How many comparisons a run planned and how many it made, backend by backend: equality that was not looked at is not
// shown.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "bench/io/report.h"

namespace spherepair {

class Comparisons {
 public:
  enum Kind { sets, states };

  // `who`: the name of the backend that is compared with the reference. Plans are made before any of it is done.
  void plan(const std::string& who, Kind kind, uint64_t count) { of_[who].planned[kind] += count; }
  void made(const std::string& who, Kind kind) { ++of_[who].made[kind]; }

  // Throws std::logic_error that names the backend where the numbers made are not those planned.
  void require_complete() const;

  uint64_t made(Kind kind) const;
  std::string text() const;  // 1234 sets and 56 states compared, as many as planned
  json to_json() const;      // by backend: planned and made

 private:
  struct Counts {
    uint64_t planned[2] = {}, made[2] = {};
  };
  std::map<std::string, Counts> of_;
};

}  // namespace spherepair
