// SPDX-License-Identifier: MIT
#include "bench/io/machine_load.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>

namespace spherepair {
namespace {

constexpr double shortest = 0.1;  // seconds

double process_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

// cpu user nice system idle iowait irq softirq steal, in ticks; guests are in user and nice.
double busy_ticks(std::istringstream& counts) {
  double ticks = 0, count = 0;
  for (int column = 0; column < 8 && counts >> count; ++column)
    if (column != 3 && column != 4) ticks += count;
  return ticks;
}

}  // namespace

std::optional<MachineUse> machine_use(const char* path) {
  std::ifstream file(path);
  MachineUse use{};
  for (std::string line, name; std::getline(file, line) && line.starts_with("cpu");) {
    std::istringstream words(line);
    words >> name;
    if (name == "cpu")
      use.busy = busy_ticks(words) / double(sysconf(_SC_CLK_TCK));
    else
      ++use.cores;
  }
  return use.busy > 0 && use.cores > 0 ? std::optional(use) : std::nullopt;
}

Clocks host_clocks() {
  const auto wall = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
  return {wall, process_seconds, [] { return machine_use(); }};
}

OtherPrograms::OtherPrograms(const Clocks& clocks)
    : clocks_(clocks),
      wall_(clocks.wall()),
      own_(clocks.cores()),
      machine_(clocks.machine ? clocks.machine() : std::nullopt) {}

std::optional<double> OtherPrograms::share() const {
  const double seconds = clocks_.wall() - wall_;
  const auto now = machine_ ? clocks_.machine() : std::nullopt;
  if (!now || seconds < shortest) return {};
  const double others = now->busy - machine_->busy - (clocks_.cores() - own_);
  return std::clamp(others / seconds / now->cores, 0.0, 1.0);
}

}  // namespace spherepair
