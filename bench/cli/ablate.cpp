// SPDX-License-Identifier: MIT
#include "bench/cli/ablate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/formats/files.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/io/output_files.h"
#include "bench/options/options.h"
#include "bench/studies/ablation_study.h"

namespace spherepair {
namespace {

Table table_of(const AblationStudy& study) {
  return {"Ablation: time of one step with each optimisation or API feature on and off",
          {{"", "backend", "", true},
           {"", "option", "", true},
           {"", "n", ""},
           {"", "on", "ms"},
           {"", "off", "ms"},
           {"", "off/on", "times"},
           {"", "when on", "", true}},
          study.rows,
          study.left_out};
}

json to_json(const AblationSeconds& spent) {
  return {{"opening", spent.opening},
          {"uploading", spent.uploading},
          {"checking", spent.checking},
          {"timing", spent.timing}};
}

std::string spent_text(const AblationSeconds& spent) {
  return fmt::format("Timing took {:.1f} s, checking {:.1f} s, scenes and uploads {:.1f} s, opening backends {:.1f} s",
                     spent.timing, spent.checking, spent.uploading, spent.opening);
}

void check_names(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Ablation& ablation : ablation_list())
    if (!std::ranges::count(known, ablation.name)) known.push_back(ablation.name);
  for (const std::string& name : names) require_known("ablation", name, known);
}

}  // namespace

int ablate_command(const CommandLine& line, const AblateOptions& options) {
  require_known_backends(options.backends);
  check_names(options.names);
  OutputFiles().write("--json", options.json_file);
  Session session(options.backends, line.open, line.opener);
  const bool hardware = std::ranges::any_of(session.backends(), [](const auto& b) { return on_hardware(*b); });
  std::vector<uint64_t> sizes = options.sizes;
  if (sizes.empty()) sizes = hardware ? std::vector<uint64_t>{16384, 1000000} : std::vector<uint64_t>{16384};
  for (const std::string& warning : session.warnings()) fmt::print(stderr, "{}\n", warning);
  json record = {{"complete", false},
                 {"context", capture_context(line.words)},
                 {"backends", session.to_json()},
                 {"clocks", json::array({query_clocks()})}};
  std::optional<AblationStudy> study;
  const auto write = [&] {
    record["spent_s"] = to_json(study->spent);
    record["left_out"] = study->left_out;
    record["measurements"] = study->measurements;
    write_file(options.json_file, json_text(record));
  };
  study.emplace(session, line.open, options, write);
  study->run(sizes);
  record["complete"] = true;
  record["clocks"].push_back(query_clocks());
  write();
  fmt::print("{}{}\n", table_of(*study).text(), spent_text(study->spent));
  return kOk;
}

std::shared_ptr<AblateOptions> add_ablate_options(CLI::App& command) {
  auto options = std::make_shared<AblateOptions>();
  std::string help = "Only these of:\n";
  for (const Ablation& ablation : ablation_list())
    help += fmt::format("    {:<22} {}{}\n", ablation.name, ablation.summary,
                        *ablation.backend ? fmt::format(" ({})", ablation.backend) : "");
  command.add_option("--backends", options->backends, "Only these, and each must open: cpu,glsl,cuda")->delimiter(',');
  command.add_option("--names", options->names, help)->delimiter(',');
  command.add_option("--n", options->sizes, "Numbers of spheres (default 16384, with a GPU also 1000000)")
      ->delimiter(',')
      ->check(positive_range);
  command.add_option("--packing-fraction", options->packing_fraction, "Packing fraction of the spheres")
      ->check(fraction_range)
      ->capture_default_str();
  command.add_option("--rounds", options->rounds, "Rounds of each timing")
      ->check(whole_number(1, 1000))
      ->capture_default_str();
  command.add_option("--json", options->json_file, "Output file")->capture_default_str();
  command.footer("Example:\n  spherepair ablate --backends glsl,cuda --n 16384,1000000,10000000");
  return options;
}

}  // namespace spherepair
