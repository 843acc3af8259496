// SPDX-License-Identifier: MIT
#include "bench/measure/comparisons.h"

#include <fmt/format.h>

#include <stdexcept>

#include "common/scene/counted.h"

namespace spherepair {
namespace {

constexpr const char* kind_names[] = {"sets", "states"};

}  // namespace

void Comparisons::require_complete() const {
  for (const auto& [backend, counts] : counts_)
    for (const Kind kind : {sets, states})
      if (counts.made[kind] != counts.planned[kind])
        throw std::logic_error(
            fmt::format("comparisons of {} of {}: {} planned, but {} made: an error of the harness; this run does not "
                        "show equality",
                        kind_names[kind], backend, counts.planned[kind], counts.made[kind]));
}

uint64_t Comparisons::made(Kind kind) const {
  uint64_t sum = 0;
  for (const auto& [backend, counts] : counts_) sum += counts.made[kind];
  return sum;
}

std::string Comparisons::text() const {
  return fmt::format("{} and {} compared, as many as planned", counted(made(sets), "set"),
                     counted(made(states), "state"));
}

json Comparisons::to_json() const {
  json all = json::object();
  for (const auto& [backend, counts] : counts_)
    for (const Kind kind : {sets, states})
      all[backend][kind_names[kind]] = {{"planned", counts.planned[kind]}, {"made", counts.made[kind]}};
  return all;
}

}  // namespace spherepair
