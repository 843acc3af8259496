// SPDX-License-Identifier: MIT
#include <algorithm>

#include "bench/studies/frames.h"

namespace spherepair {
namespace {

// The share of the shorter time that is hidden: 1: completely; 0: no overlap. Noise may push it outside [0, 1].
json overlap_of(double frame, double step, double pipelined) {
  return {{"frame_ms", frame * 1e3},
          {"step_ms", step * 1e3},
          {"pipelined_ms", pipelined * 1e3},
          {"overlap", (frame + step - pipelined) / std::min(frame, step)}};
}

}  // namespace

json time_transfers(const TransferTask& task, const TimeStep& time) {
  json overlaps = json::array();
  Backend& cuda = *task.cuda;
  uint64_t turn = 0;
  const auto step = [&] {
    cuda.move();
    cuda.enqueue_collide(task.collide);
  };
  const double step_seconds = time("none", "step", step, true);
  for (const Transfer transfer : cuda.transfers()) {
    const std::string name = transfer_name(transfer);
    const auto transfer_and_draw = [&](DrawMethod method) {
      cuda.enqueue_draw(task.views[turn++ % task.views.size()],
                        {.method = method, .transfer = transfer, .reuse_unchanged = false});
    };
    time(
        "none", name, [&] { cuda.transfer(transfer), cuda.finish(); }, false);
    for (const DrawMethod method : task.draws) {
      const std::string draw = draw_method_name(method);
      const double alone = time(
          draw, name, [&] { transfer_and_draw(method), cuda.finish(); }, false);
      const double pipelined = time(
          draw, name + "_pipelined", [&] { transfer_and_draw(method), step(); }, true);
      cuda.finish();
      json overlap = {{"draw", draw}, {"transfer", name}};
      overlap.update(overlap_of(alone, step_seconds, pipelined));
      overlaps.push_back(overlap);
    }
  }
  return overlaps;
}

}  // namespace spherepair
