// SPDX-License-Identifier: MIT
#include "cuda/host/step_graph.h"

#include <fmt/format.h>

#include <bit>

#include "cuda/host/check.h"
#include "cuda/host/entries.h"

namespace spherepair {
namespace {

void launch_on(cudaStream_t stream, const Call& call) {
  Params p = call.params;
  KernelBuffers buffers = std::bit_cast<KernelBuffers>(call.buffers);
  View view = call.view;
  uint steps = call.launch.steps;
  void* arguments[] = {&p, &buffers, steps ? static_cast<void*>(&steps) : &view};
  cudaLaunchAttribute attribute{};
  if (call.early) {
    attribute.id = cudaLaunchAttributeProgrammaticStreamSerialization;
    attribute.val.programmaticStreamSerializationAllowed = 1;
  } else {
    attribute.id = cudaLaunchAttributeCooperative;
    attribute.val.cooperative = steps != 0;
  }
  cudaLaunchConfig_t config{};
  config.gridDim = dim3(call.launch.groups[0], call.launch.groups[1], call.launch.groups[2]);
  config.blockDim = dim3(call.launch.block);
  config.stream = stream;
  config.attrs = &attribute;
  config.numAttrs = call.early || steps ? 1 : 0;
  cuda_check(cudaLaunchKernelExC(&config, entry_of(call.launch), arguments),
             fmt::format("launching {} with {} threads a block", stage_name(call.launch), call.launch.block));
}

}  // namespace

StepGraphs::~StepGraphs() {
  if (stream_) cudaStreamDestroy(stream_);
}

void StepGraphs::launch_call(const Call& call) { launch_on(launches_on_, call); }

StepApi::Recording StepGraphs::record(const std::vector<Call>& calls, uint steps) {
  if (!stream_) cuda_check(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "creating a stream");
  cuda_check(cudaStreamBeginCapture(stream_, cudaStreamCaptureModeThreadLocal), "beginning to capture a step");
  cudaGraph_t graph = nullptr;
  try {
    for (uint step = 0; step < steps; ++step)
      for (const Call& call : calls) launch_on(stream_, call);
  } catch (const BackendError&) {
    cudaStreamEndCapture(stream_, &graph);  // otherwise no later step could be captured
    throw;
  }
  cuda_check(cudaStreamEndCapture(stream_, &graph), "capturing a step");
  cudaGraphExec_t made = nullptr;
  const cudaError_t error = cudaGraphInstantiate(&made, graph, 0);
  cudaGraphDestroy(graph);
  cuda_check(error, "making a graph of a step");
  return {made, cudaGraphExecDestroy};
}

void StepGraphs::replay(const Recording& recording) {
  cuda_check(cudaGraphLaunch(static_cast<cudaGraphExec_t>(recording.get()), nullptr), "launching the graph of a step");
}

}  // namespace spherepair
