// SPDX-License-Identifier: MIT
// The launches of one collision step as a CUDA graph: collected, captured when they come a second time (a kernel's
// first launch loads it, which a capture does not allow), and from the third on replayed in one call. Whatever cannot
// wait for the end of the step makes them launches one by one.
#pragma once

#include <cuda_runtime.h>

#include <vector>

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
  StepGraph() = default;
  ~StepGraph();
  StepGraph(const StepGraph&) = delete;
  StepGraph& operator=(const StepGraph&) = delete;

  void begin();
  bool collecting() const { return collecting_; }
  void add(const KernelCall& call) { calls_.push_back(call); }
  size_t size() const { return calls_.size(); }
  void flush();  // launches what was collected
  bool end();    // true when all went out as one graph that was there already
  uint64_t captures() const { return captures_; }

 private:
  void capture();
  void drop();

  bool collecting_ = false;
  std::vector<KernelCall> calls_, last_;  // of this step and of the one before
  cudaStream_t stream_ = nullptr;         // to capture on; the default stream cannot be
  cudaGraphExec_t graph_ = nullptr;
  uint64_t captures_ = 0;
};

}  // namespace spherepair
