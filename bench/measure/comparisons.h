// SPDX-License-Identifier: MIT
// Counts the comparisons that a run planned and made, by backend: a run that compared less than planned shows no
// equality.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "bench/io/report.h"

namespace spherepair {

class Comparisons {
 public:
  enum Kind { sets, states };

  // Plans comparisons of `backend` with the reference. Call it before the first comparison.
  void plan(const std::string& backend, Kind kind, uint64_t count) { counts_[backend].planned[kind] += count; }
  void made(const std::string& backend, Kind kind) { ++counts_[backend].made[kind]; }

  // Throws std::logic_error that names a backend for which made and planned differ.
  void require_complete() const;

  uint64_t made(Kind kind) const;
  std::string text() const;  // 1234 sets and 56 states compared, as many as planned
  json to_json() const;      // by backend: planned and made

 private:
  struct Counts {
    uint64_t planned[2] = {}, made[2] = {};
  };
  std::map<std::string, Counts> counts_;
};

}  // namespace spherepair
