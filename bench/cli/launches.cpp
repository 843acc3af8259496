// SPDX-License-Identifier: MIT
// spherepair launches: launches.json has an entry of `measurements` for each size, work and path:
//   n, scene, work   empty, all_pairs or grid, see LaunchWork; of empty, n is the first size, and no sphere takes part
//   backend, path    see LaunchPath
//   work_per_step    launches, of which a replayed graph is one; kernels; waits, graphs_replayed, overlapped, early
//   us_per_kernel    the step's time over its kernels
//   host_ns_per_step, host_ns_per_launch   the host's time from the first call that enqueues 64 steps to the last one's
//                    return, before the wait at their end, over the steps or their launches
// and the timing core's fields, all paths of a size and a work in one contest. left_out lists untimed paths with the
// reason.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/cli/studies.h"
#include "bench/cli/study_run.h"
#include "bench/options/options.h"

namespace spherepair {
namespace {

const char* title_of(LaunchWork work) {
  switch (work) {
    case LaunchWork::empty:
      return "Launches of a step: a chain of empty kernels of one group";
    case LaunchWork::all_pairs:
      return "Launches of a step: a move and all pairs";
    case LaunchWork::grid:
      break;
  }
  return "Launches of a step: the grid, spheres in random order, which it sorts first";
}

// A table for each work.
std::string tables_of(const LaunchStudy& study, size_t width) {
  std::string text;
  for (const auto& [work, rows] : study.rows)
    text += Table{title_of(work),
                  {{"", "n", ""},
                   {"", "backend", "", true},
                   {"", "path", "", true},
                   {"time of a", "step", "us"},
                   {"time of a", "kernel", "us"},
                   {"host, for a", "step", "ns"},
                   {"host, for a", "launch", "ns"},
                   {"fixed cost", "a sample", "us"},
                   {"", "to fastest", "", true}},
                  rows,
                  {}}
                .text(width) +
            "\n";
  for (const std::string& one : study.left_out) text += wrapped(one, "* left out: ", "  ", width) + "\n";
  return text +
         "* host: until all is enqueued, before the wait\n"
         "* What each path is: spherepair launches --help\n";
}

void require_device(const Session& session) {
  if (session.devices().empty())
    throw BackendError("launches times those of a GPU API, and none of opengl, cuda and vulkan is open:\n" +
                       session.summary());
}

}  // namespace

int launches_command(const CommandLine& line, const LaunchesOptions& options) {
  StudyRun run(line, "launches", options.results, options.backends);
  require_device(run.session());
  std::vector<uint64_t> sizes = options.sizes;
  if (sizes.empty()) sizes = {64, 256, 1024};
  if (options.sizes.empty() && run.hardware()) sizes.insert(sizes.end(), {4096, 16384, 65536});
  LaunchStudy study(run.session(), options, [&] {
    run.record["left_out"] = study.left_out;
    run.record["measurements"] = study.measurements;
    run.write();
  });
  study.run(sizes);
  return run.finish([&](size_t width) { return tables_of(study, width); }, study.measurements);
}

std::shared_ptr<LaunchesOptions> add_launches_options(CLI::App& command) {
  auto options = std::make_shared<LaunchesOptions>();
  add_backends_option(command, options->backends);
  add_list(command, "--n", options->sizes,
           "Numbers of spheres (default 64, 256, 1024, with a GPU also 4096, 16384, 65536)")
      ->transform(positive_range);
  add_rounds_option(command, options->rounds);
  add_results_option(command, options->results, "launches.json, .txt and .csv");
  std::string paths = "Paths:\n";
  for (const LaunchPath& path : launch_paths())
    paths += fmt::format("  {:<30} {}\n", fmt::format("{} {}", path.backend, path.name), path.summary);
  command.footer(paths + "Example:\n  spherepair launches --backends opengl,vulkan,cuda --n 64,1024,16384");
  return options;
}

}  // namespace spherepair
