// SPDX-License-Identifier: MIT
#include <algorithm>

#include "bench/studies/frames.h"

namespace spherepair {
namespace {

// 1: the shorter of the two costs nothing; 0: one waits for the other. Noise may take it beyond both.
json overlap_of(double picture, double step, double pipelined) {
  return {{"picture_ms", picture * 1e3},
          {"step_ms", step * 1e3},
          {"pipelined_ms", pipelined * 1e3},
          {"overlap", (picture + step - pipelined) / std::min(picture, step)}};
}

}  // namespace

json time_hand_overs(const SharedTask& task, SharedDrawing& shared, const TimeStep& time) {
  json overlaps = json::array();
  Backend& cuda = *task.cuda;
  uint64_t turn = 0;
  const auto step = [&] {
    cuda.move();
    cuda.collide(task.collide);
  };
  const double step_seconds = time("none", "step", step);
  for (const HandOver by : {HandOver::host, HandOver::registered, HandOver::imported}) {
    const std::string way = hand_over_name(by);
    const auto picture = [&](DrawMethod method) {
      shared.hand_over(by);
      shared.draw(method, task.views[turn++ % task.views.size()]);
    };
    time("none", way, [&] { shared.hand_over(by), shared.finish(); });
    for (const DrawMethod method : task.draws) {
      const std::string draw = draw_method_name(method);
      const double alone = time(draw, way, [&] { picture(method), shared.finish(); });
      const double pipelined = time(draw, way + "_pipelined", [&] { picture(method), step(); });
      shared.finish();
      json overlap = {{"draw", draw}, {"hand_over", way}};
      overlap.update(overlap_of(alone, step_seconds, pipelined));
      overlaps.push_back(overlap);
    }
  }
  return overlaps;
}

}  // namespace spherepair
