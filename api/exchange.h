// SPDX-License-Identifier: MIT
// Spheres that one GPU API moves and another searches or draws.
#pragma once

#include "api/open.h"

namespace spherepair {

class Exchange {
 public:
  // way: imported: on the GPU, between Vulkan and CUDA; host: through the host's memory, between any two devices. Both
  // backends must outlive the exchange and hold as many spheres as now. Throws BackendError that says what is missing.
  Exchange(Backend& from, Backend& to, Transfer way);

  // Gives `to` the positions and radii of `from`, 16 bytes a sphere; see DevicePositions::positions_changed. Waits.
  void run();

  uint64_t bytes() const { return bytes_; }  // of a run

 private:
  uint64_t common_bytes() const;

  Backend &from_, &to_;
  uint64_t bytes_;
  DeviceCopy copy_;
};

}  // namespace spherepair
