// SPDX-License-Identifier: MIT
#include "cuda/host/step_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "cuda/host/check.h"

namespace spherepair {
namespace {

template <typename T>
bool same_bytes(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

bool same_call(const KernelCall& a, const KernelCall& b) {
  return a.entry == b.entry && a.groups.x == b.groups.x && a.groups.y == b.groups.y && a.groups.z == b.groups.z &&
         a.block == b.block && same_bytes(a.p, b.p) && same_bytes(a.w, b.w) && same_bytes(a.v, b.v) &&
         a.early == b.early && a.steps == b.steps;
}

}  // namespace

void launch_call(const KernelCall& call, cudaStream_t stream) {
  Params p = call.p;
  KernelBuffers w = call.w;
  View v = call.v;
  uint steps = call.steps;
  void* arguments[] = {&p, &w, steps ? static_cast<void*>(&steps) : &v};
  cudaLaunchAttribute attribute{};
  if (call.early) {
    attribute.id = cudaLaunchAttributeProgrammaticStreamSerialization;
    attribute.val.programmaticStreamSerializationAllowed = 1;
  } else {
    attribute.id = cudaLaunchAttributeCooperative;
    attribute.val.cooperative = steps != 0;
  }
  cudaLaunchConfig_t config{};
  config.gridDim = call.groups;
  config.blockDim = dim3(call.block);
  config.stream = stream;
  config.attrs = &attribute;
  config.numAttrs = call.early || steps ? 1 : 0;
  cuda_check(cudaLaunchKernelExC(&config, call.entry, arguments),
             fmt::format("launching {} with {} threads a block", call.name, call.block));
}

StepGraph::~StepGraph() {
  for (Step& step : steps_) destroy(step);
  if (stream_) cudaStreamDestroy(stream_);
}

void StepGraph::destroy(Step& step) {
  for (cudaGraphExec_t graph : step.graphs)
    if (graph) cudaGraphExecDestroy(graph);
}

void StepGraph::begin(uint most_steps) {
  if (collecting_ || most_steps != most_) flush();  // collecting: a step that an error ended
  most_ = most_steps;
  collecting_ = true;
}

void StepGraph::flush() {
  release();
  launch_calls();
  next_ = 1;
}

void StepGraph::launch_calls() {
  collecting_ = false;
  const Calls calls = std::exchange(calls_, {});
  for (const KernelCall& call : calls) launch_call(call, nullptr), ++work_.launches;
}

cudaGraphExec_t StepGraph::capture(uint steps) {
  if (!stream_) cuda_check(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "creating a stream");
  cuda_check(cudaStreamBeginCapture(stream_, cudaStreamCaptureModeThreadLocal), "beginning to capture a step");
  cudaGraph_t graph = nullptr;
  try {
    for (uint step = 0; step < steps; ++step)
      for (const KernelCall& call : steps_.front().calls) launch_call(call, stream_);
  } catch (const BackendError&) {
    cudaStreamEndCapture(stream_, &graph);  // else no later step could be captured
    throw;
  }
  cuda_check(cudaStreamEndCapture(stream_, &graph), "capturing a step");
  cudaGraphExec_t made = nullptr;
  const cudaError_t error = cudaGraphInstantiate(&made, graph, 0);
  cudaGraphDestroy(graph);
  cuda_check(error, "making a graph of a step");
  ++prepared_.captures;
  return made;
}

void StepGraph::replay(size_t size) {
  cudaGraphExec_t& graph = steps_.front().graphs[size];
  if (!graph) graph = capture(graph_sizes[size]);
  cuda_check(cudaGraphLaunch(graph, nullptr), "launching the graph of a step");
  ++work_.launches;
  ++work_.graphs_replayed;
}

// The longest graphs first.
void StepGraph::release() {
  for (size_t size = graph_sizes.size(); size-- > 0;)
    for (; held_ >= graph_sizes[size]; held_ -= graph_sizes[size]) replay(size);
}

// Whether this step came before; it is the latest then.
bool StepGraph::recall() {
  const auto found =
      std::ranges::find_if(steps_, [&](const Step& step) { return std::ranges::equal(calls_, step.calls, same_call); });
  if (found == steps_.end()) return false;
  if (found != steps_.begin()) {
    release();  // those like the one that was the latest
    next_ = 1;
    steps_.splice(steps_.begin(), steps_, found);
  }
  return true;
}

void StepGraph::end() {
  if (!collecting_) return;
  if (!recall()) {
    release();
    steps_.push_front({calls_});
    launch_calls();
    next_ = 1;
    if (steps_.size() <= remembered) return;
    destroy(steps_.back());
    return steps_.pop_back();
  }
  collecting_ = false;
  calls_.clear();
  if (++held_ < next_) return;
  release();
  next_ = std::min(4 * next_, most_);
}

}  // namespace spherepair
