// SPDX-License-Identifier: MIT
#include "cuda/host/step_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
  if (graph_) cudaGraphExecDestroy(graph_);
  if (stream_) cudaStreamDestroy(stream_);
}

void StepGraph::begin() {
  flush();  // of a step that an error ended
  collecting_ = true;
}

void StepGraph::flush() {
  collecting_ = false;
  for (const KernelCall& call : calls_) launch_call(call, nullptr);
  calls_.clear();
}

void StepGraph::drop() {
  if (graph_) cuda_check(cudaGraphExecDestroy(std::exchange(graph_, nullptr)), "giving a graph back");
}

void StepGraph::capture() {
  if (!stream_) cuda_check(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "creating a stream");
  cuda_check(cudaStreamBeginCapture(stream_, cudaStreamCaptureModeThreadLocal), "beginning to capture a step");
  cudaGraph_t graph = nullptr;
  try {
    for (const KernelCall& call : calls_) launch_call(call, stream_);
  } catch (const BackendError&) {
    cudaStreamEndCapture(stream_, &graph);  // else no later step could be captured
    throw;
  }
  cuda_check(cudaStreamEndCapture(stream_, &graph), "capturing a step");
  const cudaError_t error = cudaGraphInstantiate(&graph_, graph, 0);
  cudaGraphDestroy(graph);
  cuda_check(error, "making a graph of a step");
  ++captures_;
}

bool StepGraph::end() {
  if (!collecting_) return false;
  if (!std::ranges::equal(calls_, last_, same_call)) {
    drop();
    last_ = calls_;
    flush();
    return false;
  }
  collecting_ = false;
  const bool there = graph_ != nullptr;
  if (!there) capture();
  calls_.clear();
  cuda_check(cudaGraphLaunch(graph_, nullptr), "launching the graph of a step");
  return there;
}

}  // namespace spherepair
