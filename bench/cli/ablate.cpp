// SPDX-License-Identifier: MIT
#include "bench/cli/studies.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/cli/study_run.h"
#include "bench/io/arguments.h"
#include "bench/options/options.h"
#include "bench/studies/ablation_study.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

// A table for each number of spheres.
std::string tables_of(const AblationStudy& study, size_t width) {
  std::string text;
  for (const auto& [n, rows] : study.rows)
    text += Table{fmt::format("Time of a step of {} with each optimisation or API feature on and off",
                              counted(n, "sphere")),
                  {{"", "backend", "", true},
                   {"", "option", "", true},
                   {"time", "on", "ms"},
                   {"time", "off", "ms"},
                   {"", "off/on", "", true}},
                  rows,
                  {}}
                .text(width) +
            "\n";
  for (const std::string& one : study.left_out) text += wrapped(one, "* left out: ", "  ", width) + "\n";
  return text + "* What each option does: spherepair ablate --help\n";
}

void check_names(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Ablation& ablation : ablation_list())
    if (!std::ranges::count(known, ablation.name)) known.push_back(ablation.name);
  for (const std::string& name : names) require_known("ablation", name, known);
}

// Refuses ablations of a backend that is not open: they would be left out silently.
void require_offered(const std::vector<std::string>& names, const Session& session) {
  for (const std::string& name : names) {
    const auto here = [&](const Ablation& one) {
      return one.name == name && (!*one.backend || session.find(one.backend));
    };
    if (std::ranges::none_of(ablation_list(), here))
      throw std::invalid_argument(
          fmt::format("the ablation {} has no effect here: no open backend has it; see ablate --help", name));
  }
}

}  // namespace

int ablate_command(const CommandLine& line, const AblateOptions& options) {
  check_names(options.names);
  StudyRun run(line, "ablate", options.results, options.backends);
  require_offered(options.names, run.session());
  std::vector<uint64_t> sizes = options.sizes;
  if (sizes.empty()) sizes = run.hardware() ? std::vector<uint64_t>{16384, 1000000} : std::vector<uint64_t>{16384};
  AblationStudy study(run.session(), line.open, options, [&] {
    run.record["left_out"] = study.left_out;
    run.record["measurements"] = study.measurements;
    run.write();
  });
  study.run(sizes);
  return run.finish([&](size_t width) { return tables_of(study, width); }, study.measurements);
}

std::shared_ptr<AblateOptions> add_ablate_options(CLI::App& command) {
  auto options = std::make_shared<AblateOptions>();
  std::string help = "Only these of:\n";
  for (const Ablation& ablation : ablation_list())
    help += fmt::format("    {:<22} {}{}\n", ablation.name, ablation.summary,
                        *ablation.backend ? fmt::format(" ({})", ablation.backend) : "");
  add_backends_option(command, options->backends);
  add_list(command, "--names", options->names, help);
  add_list(command, "--n", options->sizes, "Numbers of spheres (default 16384, with a GPU also 1000000)")
      ->transform(positive_range);
  add_number(command, "--packing-fraction", options->packing_fraction, fraction_range,
             "Packing fraction of the spheres");
  add_rounds_option(command, options->rounds);
  add_results_option(command, options->results, "ablate.json, .txt and .csv");
  command.footer("Example:\n  spherepair ablate --backends opengl,cuda --n 16384,1000000,10000000");
  return options;
}

}  // namespace spherepair
