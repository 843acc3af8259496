// SPDX-License-Identifier: MIT
// Measures how busy other programs keep the machine. The load average counts our own threads, too, and threads of a run
// that ended a minute ago.
#pragma once

#include <functional>
#include <optional>

namespace spherepair {

struct MachineUse {
  double busy;  // seconds of all cores since the machine started in which they worked or a hypervisor took them away
  int cores;
};
// Reads /proc/stat. None if it is missing or has zeros, as in some sandboxes.
std::optional<MachineUse> machine_use(const char* path = "/proc/stat");

// Seconds of a steady clock, of the host's cores for all threads of this process, and of the machine's cores.
struct Clocks {
  std::function<double()> wall, cores;
  std::function<std::optional<MachineUse>()> machine = {};  // empty: not known
};
Clocks host_clocks();

constexpr double busy_share = 0.5;  // of the cores: if other programs take more, a time decides nothing

// Measures the share of the machine's cores that other programs keep busy.
class OtherPrograms {
 public:
  explicit OtherPrograms(const Clocks& clocks);

  // The share since the construction. None if it is unknown, or within 0.1 s: the machine counts in steps of 0.01 s.
  std::optional<double> share() const;

 private:
  const Clocks& clocks_;
  double wall_, own_;
  std::optional<MachineUse> machine_;
};

}  // namespace spherepair
