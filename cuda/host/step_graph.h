// SPDX-License-Identifier: MIT
// The launches of collision steps as CUDA graphs. A step is collected; when it comes a second time it is captured (a
// kernel's first launch loads it, which a capture does not allow) and replayed from then on. Equal steps that nobody
// waits for are held back and go out together, in graphs of 1, 4, 16 and 64 steps: a dependent kernel costs 1.3 us in a
// graph of one step, 0.8 in one of 64. Whatever cannot wait flushes what was collected or held back.
#pragma once

#include <cuda_runtime.h>

#include <array>
#include <list>
#include <vector>

#include "common/backend/collide_options.h"
#include "common/backend/preparations.h"
#include "common/shared/view.h"
#include "cuda/kernels.h"

namespace spherepair {

struct KernelCall {
  const char* name;
  Entry entry;
  dim3 groups;
  uint block;
  Params p;
  KernelBuffers w;
  View v;      // zeros for a kernel that takes none: another view is no other call of it
  bool early;  // may begin before the launch before is done, for which the kernel itself waits
  uint steps;  // of persistent_steps, which takes them in place of a view; 0: another kernel
};
void launch_call(const KernelCall& call, cudaStream_t stream);  // throws BackendError

class StepGraph {
 public:
  // Counts launches, replays and captures there.
  StepGraph(WorkCounts& work, Preparations& prepared) : work_(work), prepared_(prepared) {}
  ~StepGraph();
  StepGraph(const StepGraph&) = delete;
  StepGraph& operator=(const StepGraph&) = delete;

  void begin(uint most_steps);  // a step, of which a graph may hold so many
  bool collecting() const { return collecting_; }
  void add(const KernelCall& call) { calls_.push_back(call); }
  void end();    // of the step: launches or holds it
  void flush();  // launches what was collected or held back; the next step goes out at once

 private:
  using Calls = std::vector<KernelCall>;
  struct Step {
    Calls calls;
    std::array<cudaGraphExec_t, graph_sizes.size()> graphs{};  // by graph_sizes; null: not captured yet
  };
  void release();
  void launch_calls();
  bool recall();
  void replay(size_t size);
  cudaGraphExec_t capture(uint steps);
  static void destroy(Step& step);

  static constexpr size_t remembered = 8;  // steps: those of several searches by turns stay captured

  WorkCounts& work_;
  Preparations& prepared_;
  bool collecting_ = false;
  Calls calls_;                    // of this step
  std::list<Step> steps_;          // that came before, the latest first
  uint most_ = 1, next_ = 1;       // steps of a graph at most, and of the next one
  uint held_ = 0;                  // steps like the latest that are not launched yet
  cudaStream_t stream_ = nullptr;  // to capture on; the default stream cannot be
};

}  // namespace spherepair
