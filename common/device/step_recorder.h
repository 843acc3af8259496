// SPDX-License-Identifier: MIT
// The launches of steps, recorded and replayed. A step is collected; when it comes a second time it is recorded (a
// kernel's first launch may load it, which a recording does not allow) and replayed from then on. Equal steps that
// nobody waits for are held back and go out together, in recordings of 1, 4, 16 and 64 steps. Whatever cannot wait
// flushes what was collected or held back.
#pragma once

#include <list>
#include <vector>

#include "common/backend/collide_options.h"
#include "common/backend/preparations.h"
#include "common/device/launch.h"

namespace spherepair {

// A launch, with all that it was handed.
struct Call {
  Launch launch;  // whose view is the one below
  Params params;
  BufferHandles buffers;  // as the kernel sees them
  View view{};            // zeros for a kernel that takes none: another view is no other call of it
  bool early = false;     // need not wait for the launch before: no barrier in Vulkan; in CUDA a programmatic launch,
                          // whose kernel may wait itself
};

// How an API launches and records; throws BackendError.
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
  // Counts launches, replays and recordings there.
  StepRecorder(StepApi& api, WorkCounts& work, Preparations& prepared) : api_(api), work_(work), prepared_(prepared) {}

  void begin(uint most_steps);  // a step, of which a recording may hold so many
  bool collecting() const { return collecting_; }
  void add(const Call& call) { calls_.push_back(call); }
  void end();    // of the step: launches or holds it
  void flush();  // launches what was collected or held back; the next step goes out at once

 private:
  struct Step {
    std::vector<Call> calls;
    std::array<StepApi::Recording, graph_sizes.size()> recordings{};  // by graph_sizes; null: not made yet
  };
  void release();
  void launch_calls();
  bool recall();
  void replay(size_t size);

  static constexpr size_t remembered = 8;  // steps: those of several searches by turns stay recorded

  StepApi& api_;
  WorkCounts& work_;
  Preparations& prepared_;
  bool collecting_ = false;
  std::vector<Call> calls_;   // of this step
  std::list<Step> steps_;     // that came before, the latest first
  uint most_ = 1, next_ = 1;  // steps of a recording at most, and of the next one
  uint held_ = 0;             // steps like the latest that are not launched yet
};

}  // namespace spherepair
