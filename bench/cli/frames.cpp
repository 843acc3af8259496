// SPDX-License-Identifier: MIT
// spherepair frames
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/formats/files.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/studies/frames_study.h"
#include "bench/studies/study_report.h"
#include "bench/viewer/window.h"

namespace spherepair {

int frames_command(const CommandLine& line, const FramesOptions& options) {
  for (const std::string& draw : options.draws) draw_method_from_name(draw);
  for (const std::string& place : options.places) require_known("camera position", place, {"outside", "inside"});
  for (const std::string& work : options.works)
    require_known("work", work, {"frame", "frame_all", "lit", "loop", "view"});
  most_by_draw(options.most);
  const std::filesystem::path folder = prepare_results(options.results, files_of_study("frames"));
  const StudyLoad load(line.clocks);
  std::unique_ptr<Window> window;
  OpenOptions open = line.open;
  if (options.window) {
    window = open_window("spherepair frames", options.width, options.height, true);
    open.window = &window->context();
  }
  Session session(options.backends, open, line.opener);
  fmt::print("{}\n", session.summary());
  for (const std::string& warning : load.warnings(session)) fmt::print("{}\n", wrapped(warning, "* ", "  "));
  json record = {{"format", "spherepair frames 1"}, {"context", capture_context(line.words)},
                 {"backends", session.to_json()},   {"width", options.width},
                 {"height", options.height},        {"packing_fraction", options.packing_fraction},
                 {"window", options.window}};
  const auto show = [&](Drawing& drawing) {
    if (!window) return;
    window->next(Present::never);
    if (!drawing.show(window->texture(options.width, options.height))) window->upload(drawing.image());
    window->show();
  };
  FramesStudy study(session, options, show);
  std::vector<uint64_t> measured;
  const auto page = [&](size_t width) {
    std::string text;
    for (const uint64_t n : measured) text += study.text_of(n, width) + "\n";
    return text + load.text(session);
  };
  for (const uint64_t n : options.sizes) {
    study.measure_size(n);
    measured.push_back(n);
    fmt::print("{}\n", study.text_of(n, kTextWidth));
    std::fflush(stdout);
    record["clocks"].push_back(query_clocks());
    record["warnings"] = load.warnings(session);
    record["frames"] = study.frames;
    record["left_out"] = study.left_out;
    if (options.transfer) record["overlaps"] = study.overlaps;
    write_file(folder / "frames.json", json_text(record));
    write_page(folder, "frames", page, samples_csv(study.frames));
  }
  fmt::print("{}", load.text(session));
  fmt::print("Results: {}\n", (folder / "frames.json").string());
  return kOk;
}

}  // namespace spherepair
