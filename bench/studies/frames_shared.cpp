// SPDX-License-Identifier: MIT
#include <algorithm>

#include "bench/studies/frames.h"

namespace spherepair {
namespace {

// 1: the shorter of the two costs nothing; 0: one waits for the other. Noise may take it beyond both.
json overlap_of(double image, double step, double pipelined) {
  return {{"picture_ms", image * 1e3},
          {"step_ms", step * 1e3},
          {"pipelined_ms", pipelined * 1e3},
          {"overlap", (image + step - pipelined) / std::min(image, step)}};
}

}  // namespace

json time_transfers(const SharedTask& task, SharedDrawing& shared, const TimeStep& time) {
  json overlaps = json::array();
  Backend& cuda = *task.cuda;
  uint64_t turn = 0;
  const auto step = [&] {
    cuda.move();
    cuda.enqueue_collide(task.collide);
  };
  const double step_seconds = time("none", "step", step);
  for (const Transfer by : {Transfer::host, Transfer::registered, Transfer::imported}) {
    const std::string way = transfer_name(by);
    const auto image = [&](DrawMethod method) {
      shared.transfer(by);
      shared.draw(method, task.views[turn++ % task.views.size()]);
    };
    time("none", way, [&] { shared.transfer(by), shared.finish(); });
    for (const DrawMethod method : task.draws) {
      const std::string draw = draw_method_name(method);
      const double alone = time(draw, way, [&] { image(method), shared.finish(); });
      const double pipelined = time(draw, way + "_pipelined", [&] { image(method), step(); });
      shared.finish();
      json overlap = {{"draw", draw}, {"transfer", way}};
      overlap.update(overlap_of(alone, step_seconds, pipelined));
      overlaps.push_back(overlap);
    }
  }
  return overlaps;
}

}  // namespace spherepair
