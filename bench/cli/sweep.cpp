// SPDX-License-Identifier: MIT
// spherepair sweep: the time of a collision step against the number of spheres, one JSON file per configuration:
//   format         "spherepair sweep 1"
//   context, backends, clocks, seed   as in results.json of compare
//   peak_rates     bytes per second that each GPU copies, lane-instructions per second
//   measurements   one entry for each backend and method: n, scene, order (cold: random; warm: cell order),
//                  method, block, the set's pairs, colliding_spheres and fingerprint, checked_against, floor (bytes or
//                  instructions), floor_ms and share_of_floor where the peak rate is known, and the timing core's
//                  fields: median_ms, interval_ms, samples_ms, device_stages_ms ...
//   left_out       backend, method and reason of whatever was requested but not timed
#include "bench/cli/studies.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "bench/formats/files.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/io/scene_text.h"
#include "bench/options/options.h"
#include "bench/studies/study_sampling.h"
#include "bench/studies/sweep_point.h"
#include "common/files/file_bytes.h"
#include "common/scene/counted.h"
#include "common/shared/hash.h"

namespace spherepair {
namespace {

constexpr const char* kFormat = "spherepair sweep 1";

// Whether the file exists and is complete.
bool is_record(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return false;
  const json found = json::parse(FileBytes(file).bytes(), nullptr, false);
  return found.is_object() && found.value("format", json()) == kFormat;
}

// A hash of the key in 16 hexadecimal digits.
std::string hash_of(const json& key) {
  uint64_t hash = 0;
  for (const unsigned char letter : json_line(key)) hash = splitmix64(hash ^ letter);
  return hex64(hash);
}

std::vector<uint64_t> default_sizes(const Session& session) {
  std::vector<uint64_t> sizes = {64, 256, 1024, 4096, 16384, 65536, 262144, 1'000'000};
  const bool hardware = std::ranges::any_of(session.backends(), [](const auto& b) { return on_hardware(*b); });
  if (hardware) sizes.insert(sizes.end(), {10'000'000, 100'000'000, 1'000'000'000});
  return sizes;
}

std::vector<SweepPoint> points_of(const Session& session, const SweepCommandOptions& options) {
  std::vector<SweepPoint> points;
  for (const uint64_t n : options.sizes.empty() ? default_sizes(session) : options.sizes)
    for (const double fraction : options.packing_fractions)
      for (const std::string& order : options.orders) {
        require_known("order", order, {"cold", "warm"});
        points.push_back({.n = n,
                          .packing_fraction = fraction,
                          .in_cell_order = order == "warm",
                          .methods = parse_methods(options.methods),
                          .block = options.block});
        check_options(scene_of(points.back()));
      }
  return points;
}

// Measures peak rates in the same run, so that each time can be stated as a share of the floor.
PeakRates measure_peak_rates(Session& session, const Sampling& sampling, Progress& progress) {
  PeakRates peak_rates{.issue = issue_rate(session), .copy = {}};
  for (Backend* device : session.devices())
    if (on_hardware(*device)) peak_rates.copy[device] = copy_rate(session, *device, sampling, progress);
  return peak_rates;
}

json to_json(const PeakRates& peak_rates) {
  json all = {{"instructions_per_second", std::isfinite(peak_rates.issue) ? json(peak_rates.issue) : json(nullptr)},
              {"copied_bytes_per_second", json::object()}};
  for (const auto& [device, rate] : peak_rates.copy) all["copied_bytes_per_second"][device->info().name] = rate;
  return all;
}

class Sweep {
 public:
  Sweep(const CommandLine& line, const SweepCommandOptions& options)
      : line_(line), options_(options), load_(line.clocks), session_(options.backends, line.open, line.opener) {
    sampling_ = study_sampling(options.rounds);
    sampling_.longest = 0.1;
  }

  int run() {
    fmt::print("{}", session_.summary());
    for (const std::string& warning : load_.warnings(session_)) fmt::print("{}\n", wrapped(warning, "* ", "  "));
    const std::vector<SweepPoint> points = points_of(session_, options_);
    std::vector<std::string> files;
    for (const SweepPoint& point : points) files.push_back(file_name(point));
    const std::filesystem::path folder = prepare_results(options_.results, files);
    size_t skipped = 0;
    for (size_t k = 0; k < points.size(); ++k) {
      const bool written = options_.resume && is_record(folder / files[k]);
      fmt::print("{} {}{}\n", files[k], label(points[k]), written ? ": already written" : "");
      std::fflush(stdout);
      if (written)
        ++skipped;
      else
        write_file(folder / files[k], text_of(points[k]));
    }
    fmt::print("{}Results: {}\n{} of {} timed, {} already written\n", load_.text(session_), folder.string(),
               points.size() - skipped, counted(points.size(), "configuration"), skipped);
    return kOk;
  }

 private:
  std::string file_name(const SweepPoint& point) const {
    json key = {{"scene", scene_json(scene_of(point))},
                {"order", point.in_cell_order},
                {"rounds", sampling_.rounds},
                {"block", point.block},
                {"commit", build_info.commit}};
    for (const Method method : point.methods) key["methods"].push_back(method_name(method));
    for (const auto& backend : session_.backends()) key["devices"].push_back(backend->info().device);
    return fmt::format("grid-{}-{}-{}-{}.json", point.n, point.packing_fraction, point.in_cell_order ? "warm" : "cold",
                       hash_of(key).substr(0, 8));
  }

  std::string text_of(const SweepPoint& point) {
    if (!peak_rates_) peak_rates_ = measure_peak_rates(session_, sampling_, progress_);
    json clocks = json::array({{{"when", "before"}, {"gpus", query_clocks()}}});
    const PointTimes times = time_point(session_, point, *peak_rates_, sampling_, progress_);
    clocks.push_back({{"when", "after"}, {"gpus", query_clocks()}});
    progress_.clear();
    return json_text({{"format", kFormat},
                      {"context", capture_context(line_.words)},
                      {"backends", session_.to_json()},
                      {"warnings", load_.warnings(session_)},
                      {"seed", point.seed},
                      {"peak_rates", to_json(*peak_rates_)},
                      {"clocks", clocks},
                      {"measurements", times.measurements},
                      {"left_out", times.left_out}});
  }

  const CommandLine& line_;
  const SweepCommandOptions& options_;
  const StudyLoad load_;  // constructed before the session
  Session session_;
  Sampling sampling_;
  std::optional<PeakRates> peak_rates_;  // measured when first needed
  Progress progress_;
};

}  // namespace

std::shared_ptr<SweepCommandOptions> add_sweep_options(CLI::App& command) {
  auto options = std::make_shared<SweepCommandOptions>();
  add_backends_option(command, options->backends);
  add_list(command, "--methods", options->methods, "Only these methods (see run --help)");
  add_list(command, "--n", options->sizes, "Numbers of spheres (default: 64 to 10^6, with a GPU to 10^9)")
      ->transform(positive_range);
  add_list(command, "--packing-fractions", options->packing_fractions, "Packing fractions of the scene `uniform`")
      ->check(fraction_range);
  add_list(command, "--orders", options->orders,
           "Order of the spheres: cold (random, so that each step sorts) or warm (cell order)");
  add_block_option(command, options->block);
  add_rounds_option(command, options->rounds);
  add_results_option(command, options->results, "a JSON file per configuration");
  command
      .add_flag("--resume", options->resume, "Skip configurations that this commit has already written to the folder")
      ->needs("--results");
  command.footer(
      "Each file holds one configuration: every backend and method, checked against each other, then timed.\n"
      "Example:\n  spherepair sweep --results sweep --resume");
  return options;
}

int sweep_command(const CommandLine& line, const SweepCommandOptions& options) {
  if (options.block) parse_blocks({options.block});
  return Sweep(line, options).run();
}

}  // namespace spherepair
