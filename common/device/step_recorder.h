// SPDX-License-Identifier: MIT
// Records the launches of steps and replays them. A step is collected. When the same step comes a second time it is
// recorded and from then on replayed: not the first time, since a kernel's first launch may load it, which a recording
// forbids. Equal steps that nobody waits for are held back and submitted together, in recordings of 1, 4, 16 and 64
// steps. A call that cannot wait flushes what was collected or held back.
#pragma once

#include <list>
#include <vector>

#include "common/backend/collide_options.h"
#include "common/backend/preparations.h"
#include "common/device/launch.h"

namespace spherepair {

// A launch with all its inputs.
struct Call {
  Launch launch;  // its view is the one below
  Params params;
  BufferHandles buffers;  // the buffers that the kernel sees
  View view{};            // zeros for a kernel that takes none, so that equal calls compare equal
  bool early = false;     // need not wait for the previous launch: no barrier in Vulkan; in CUDA a
                          // programmatic launch, whose kernel may wait itself
};

// The launches and recordings of an API. All members throw BackendError.
class StepApi {
 public:
  virtual ~StepApi() = default;
  using Recording = std::shared_ptr<void>;
  virtual void launch_call(const Call& call) = 0;
  virtual Recording record(const std::vector<Call>& calls, uint steps) = 0;
  virtual void replay(const Recording& recording) = 0;
};

class StepRecorder {
 public:
  // Adds its launches, replays and recordings to these counts.
  StepRecorder(StepApi& api, WorkCounts& work, Preparations& prepared) : api_(api), work_(work), prepared_(prepared) {}

  void begin(uint most_steps);  // begins a step; its recording may hold up to this many
  bool collecting() const { return collecting_; }
  void add(const Call& call) { calls_.push_back(call); }
  void end();    // ends the step: launches it or holds it back
  void flush();  // submits what was collected or held back; the next step is submitted at once

 private:
  struct Step {
    std::vector<Call> calls;
    std::array<StepApi::Recording, graph_sizes.size()> recordings{};  // one for each of graph_sizes; null: not made yet
  };
  void release();
  void launch_calls();
  bool recall();
  void replay(size_t size);

  static constexpr size_t remembered = 8;  // steps: enough for several searches that take turns

  StepApi& api_;
  WorkCounts& work_;
  Preparations& prepared_;
  bool collecting_ = false;
  std::vector<Call> calls_;   // of the current step
  std::list<Step> steps_;     // earlier steps, the latest first
  uint most_ = 1, next_ = 1;  // largest recording, and the next one, in steps
  uint held_ = 0;             // copies of the latest step that are not launched yet
};

}  // namespace spherepair
