// SPDX-License-Identifier: MIT
// spherepair frames
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/cli/study_run.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/studies/frames_study.h"

namespace spherepair {

int frames_command(const CommandLine& line, const FramesOptions& options) {
  for (const std::string& draw : options.draws) draw_method_from_name(draw);
  for (const std::string& place : options.places) require_known("camera position", place, {"outside", "inside"});
  for (const std::string& work : options.works) require_known("work", work, {"frame", "frame_all", "lit", "loop"});
  most_by_draw(options.most);
  StudyRun run(line, "frames", options.results, options.backends);
  run.record.update({{"format", "spherepair frames 1"},
                     {"width", options.width},
                     {"height", options.height},
                     {"packing_fraction", options.packing_fraction}});
  FramesStudy study(run.session(), options);
  for (const uint64_t n : options.sizes) {
    study.measure_size(n);
    run.record["clocks"].push_back(query_clocks());
    run.record["frames"] = study.frames;
    run.record["left_out"] = study.left_out;
    if (options.transfer) run.record["overlaps"] = study.overlaps;
    run.write();
  }
  const auto tables = [&](size_t width) {
    std::string text;
    for (const uint64_t n : options.sizes) text += study.text_of(n, width) + "\n";
    return text;
  };
  return run.finish(tables, study.frames);
}

}  // namespace spherepair
