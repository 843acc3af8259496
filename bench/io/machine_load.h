// SPDX-License-Identifier: MIT
// How busy other programs keep the machine. The load average cannot tell: it counts our own threads, and those of a
// run that ended a minute ago.
#pragma once

#include <functional>
#include <optional>

namespace spherepair {

struct MachineUse {
  double busy;  // seconds since the machine started that its cores together worked, or a hypervisor took them away
  int cores;
};
// Reads /proc/stat. None where it is missing, or has zeros as in some sandboxes.
std::optional<MachineUse> machine_use(const char* path = "/proc/stat");

// Seconds: of a steady clock, of all threads of the process together on the host's cores, and of the machine's cores.
struct Clocks {
  std::function<double()> wall, cores;
  std::function<std::optional<MachineUse>()> machine = {};  // empty: not known
};
Clocks host_clocks();

constexpr double busy_share = 0.5;  // of the cores: where others take more, a time decides nothing

// Measures the share of the machine's cores that other programs keep busy.
class OtherPrograms {
 public:
  explicit OtherPrograms(const Clocks& clocks);

  // Since the construction. None where it is unknown, or less than 0.1 s ago: the machine counts in steps of 0.01 s.
  std::optional<double> share() const;

 private:
  const Clocks& clocks_;
  double wall_, own_;
  std::optional<MachineUse> machine_;
};

}  // namespace spherepair
