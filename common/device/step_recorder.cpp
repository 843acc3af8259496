// SPDX-License-Identifier: MIT
#include "common/device/step_recorder.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace spherepair {
namespace {

template <typename T>
bool same_bytes(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

// The launch's other fields show in the buffers and the parameters.
bool same_call(const Call& a, const Call& b) {
  return a.launch.kernel == b.launch.kernel && a.launch.block == b.launch.block && a.launch.groups == b.launch.groups &&
         a.launch.steps == b.launch.steps && a.early == b.early && same_bytes(a.params, b.params) &&
         same_bytes(a.buffers, b.buffers) && same_bytes(a.view, b.view) && a.launch.variant == b.launch.variant;
}

}  // namespace

void StepRecorder::begin(uint most_steps) {
  if (collecting_ || most_steps != most_) flush();  // collecting_: an error ended the last step
  most_ = most_steps;
  collecting_ = true;
}

void StepRecorder::flush() {
  release();
  launch_calls();
  next_ = 1;
}

void StepRecorder::launch_calls() {
  collecting_ = false;
  for (const Call& call : std::exchange(calls_, {})) api_.launch_call(call), ++work_.launches;
}

void StepRecorder::replay(size_t size) {
  StepApi::Recording& recording = steps_.front().recordings[size];
  if (!recording) {
    recording = api_.record(steps_.front().calls, graph_sizes[size]);
    ++prepared_.captures;
  }
  api_.replay(recording);
  ++work_.launches;
  ++work_.graphs_replayed;
  work_.kernels_replayed += steps_.front().calls.size() * graph_sizes[size];
}

// Replays what is held, with the longest recordings first.
void StepRecorder::release() {
  for (size_t size = graph_sizes.size(); size-- > 0;)
    for (; held_ >= graph_sizes[size]; held_ -= graph_sizes[size]) replay(size);
}

// Whether this step came before; it then becomes the latest.
bool StepRecorder::recall() {
  const auto found =
      std::ranges::find_if(steps_, [&](const Step& step) { return std::ranges::equal(calls_, step.calls, same_call); });
  if (found == steps_.end()) return false;
  if (found != steps_.begin()) {
    release();  // replays held copies of the previous latest
    next_ = 1;
    steps_.splice(steps_.begin(), steps_, found);
  }
  return true;
}

void StepRecorder::end() {
  if (!collecting_) return;
  if (!recall()) {
    release();
    steps_.push_front({calls_});
    launch_calls();
    next_ = 1;
    if (steps_.size() > remembered) steps_.pop_back();
    return;
  }
  collecting_ = false;
  calls_.clear();
  if (++held_ < next_) return;
  release();
  next_ = std::min(4 * next_, most_);
}

}  // namespace spherepair
