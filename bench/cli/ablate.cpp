// SPDX-License-Identifier: MIT
#include "bench/cli/studies.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/formats/files.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/options/options.h"
#include "bench/studies/ablation_study.h"
#include "bench/studies/study_report.h"
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

json to_json(const AblationSeconds& spent) {
  return {{"opening", spent.opening},
          {"uploading", spent.uploading},
          {"checking", spent.checking},
          {"timing", spent.timing}};
}

std::string spent_text(const AblationSeconds& spent) {
  return fmt::format("Seconds: timing {:.1f}, checking {:.1f}, scenes and uploads {:.1f}, opening {:.1f}", spent.timing,
                     spent.checking, spent.uploading, spent.opening);
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
  const std::filesystem::path folder = prepare_results(options.results, files_of_study("ablate"));
  const StudyLoad load(line.clocks);
  Session session(options.backends, line.open, line.opener);
  require_offered(options.names, session);
  const bool hardware = std::ranges::any_of(session.backends(), [](const auto& b) { return on_hardware(*b); });
  std::vector<uint64_t> sizes = options.sizes;
  if (sizes.empty()) sizes = hardware ? std::vector<uint64_t>{16384, 1000000} : std::vector<uint64_t>{16384};
  for (const std::string& warning : load.warnings(session)) fmt::print(stderr, "{}\n", warning);
  json record = {{"complete", false},
                 {"context", capture_context(line.words)},
                 {"backends", session.to_json()},
                 {"clocks", json::array({query_clocks()})}};
  std::optional<AblationStudy> study;
  const auto write = [&] {
    record["spent_s"] = to_json(study->spent);
    record["warnings"] = load.warnings(session);
    record["left_out"] = study->left_out;
    record["measurements"] = study->measurements;
    write_file(folder / "ablate.json", json_text(record));
  };
  study.emplace(session, line.open, options, write);
  study->run(sizes);
  record["complete"] = true;
  record["clocks"].push_back(query_clocks());
  write();
  const auto page = [&](size_t width) {
    return tables_of(*study, width) + load.text(session) + spent_text(study->spent) + "\n";
  };
  report_page(folder, "ablate", page, study->measurements);
  fmt::print("Results: {}\n", (folder / "ablate.json").string());
  return kOk;
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
