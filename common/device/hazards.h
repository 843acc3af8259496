// SPDX-License-Identifier: MIT
// Decides which launches may run at the same time: launches of which none writes what another uses.
#pragma once

#include "common/device/launch.h"

namespace spherepair {

class Hazards {
 public:
  // Whether the launch may start while the launches since the last wait still run; it then joins them. Otherwise, or if
  // `must_wait`, it waits for all of them.
  bool overlaps(const Launch& launch, const BufferHandles& buffers, bool must_wait = false) {
    const Uses uses = uses_of(launch);
    const bool alone = must_wait || launch.depends || &buffers != buffers_ || ((reads_ | writes_) & uses.writes) ||
                       (writes_ & uses.reads);
    buffers_ = &buffers;
    reads_ = alone ? uses.reads : reads_ | uses.reads;
    writes_ = alone ? uses.writes : writes_ | uses.writes;
    return !alone;
  }
  void forget() { buffers_ = nullptr; }  // the next launch waits

 private:
  const BufferHandles* buffers_ = nullptr;  // the buffers whose slots these are
  Slots reads_ = 0, writes_ = 0;            // slots that the launches since the last wait read and write
};

}  // namespace spherepair
