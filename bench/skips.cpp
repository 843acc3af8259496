// SPDX-License-Identifier: MIT
#include "skips.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>

#include "answers.h"
#include "arguments.h"
#include "context.h"
#include "files.h"
#include "frames.h"
#include "options.h"
#include "replaced_file.h"
#include "skip_list.h"
#include "timing.h"

namespace spherepair {
namespace {

constexpr uint64_t brute_force_up_to = 100000;  // spheres; beyond, the CPU's grid is the reference

json work_json(const WorkCounts& before, const WorkCounts& after) {
  const double steps = double(after.steps - before.steps);
  const auto each = [&](uint64_t WorkCounts::*count) { return double(after.*count - before.*count) / steps; };
  return {{"launches", each(&WorkCounts::launches)},     {"sorts", each(&WorkCounts::sorts)},
          {"plans", each(&WorkCounts::plans)},           {"orders_kept", each(&WorkCounts::orders_kept)},
          {"cells_kept", each(&WorkCounts::cells_kept)}, {"graphs_replayed", each(&WorkCounts::graphs_replayed)}};
}

Scene in_the_wind(Scene scene) {
  for (vec4& velocity : scene.velocities) velocity = {64, 0, 0, 0};
  scene.gravity = 0;
  return scene;
}

class SkipStudy {
 public:
  SkipStudy(Session& session, const CommandLine& line, const SkipsOptions& options)
      : session_(session), open_(line.open), options_(options) {
    sampling_.rounds = options.rounds;
    sampling_.fewest_rounds = std::min(sampling_.fewest_rounds, options.rounds);
    sampling_.software_seconds = 0.01;
  }

  void run(uint64_t n) {
    scene_options_.name = "uniform";
    scene_options_.n = n;
    scene_options_.packing_fraction = options_.packing_fraction;
    scene_ = make_scene(scene_options_);
    ordered_ = in_cell_order(scene_);
    for (const auto& backend : session_.backends())
      for (const Skip& skip : skip_list())
        if (applies(skip, *backend)) time(skip, *backend);
  }

  std::vector<std::vector<std::string>> rows;
  json measurements = json::array();
  std::vector<std::string> left_out;

 private:
  bool applies(const Skip& skip, const Backend& backend) const {
    const bool wanted = options_.names.empty() || std::ranges::count(options_.names, skip.name);
    return wanted && (*skip.backend == 0 || backend.info().name == skip.backend);
  }

  // The same set both ways, by what neither uses where that is affordable.
  void check(const Skip& skip, const Scene& scene, Backend& on, Backend& off) {
    const bool brute = scene.size() <= brute_force_up_to;
    Asked reference = reference_for(session_, {}, scene.size());
    if (!brute) reference.options.method = Method::collide_grid;
    if (reference.backend != &on) reference.backend->upload(scene);
    const Answer expected = ask(session_, reference, false);
    for (const Asked& asked : {Asked{&on, skip.on}, Asked{&off, skip.off}})
      require_equal(session_, {scene_options_, 0}, reference, expected, asked,
                    ask(session_, asked, asked.options.want_pairs));
  }

  void time(const Skip& skip, Backend& backend) {
    const Scene scene = skip.wind ? in_the_wind(scene_) : skip.ordered ? ordered_ : scene_;
    std::unique_ptr<Backend> other;  // where both ways need a backend of their own
    OpenOptions open = open_;
    if (skip.open_off) open.*skip.open_off = false;
    if (skip.open_off || skip.wind) other = open_backend(backend.info().name, open);
    Backend& off = other ? *other : backend;
    const auto leave_out = [&](const std::exception& error) {
      left_out.push_back(fmt::format("{} {} of {}: {}", backend.info().name, skip.name, scene.size(), error.what()));
    };
    try {
      if (skip.open_off && off.info().details == backend.info().details)
        throw std::invalid_argument("this driver does not offer it");
      for (Backend* one : std::set{&backend, &off}) one->upload(scene);
      check(skip, scene, backend, off);
    } catch (const BackendError& error) {
      return leave_out(error);
    } catch (const std::invalid_argument& error) {  // a trick that this device lacks
      return leave_out(error);
    }
    const std::string name = fmt::format("{} {}", backend.info().name, skip.name);
    const auto step = [&](const CollideOptions& options, bool reads) {
      return [=, wind = skip.wind](Backend& b) {
        if (wind) b.move();
        b.collide(options);
        if (reads) b.collisions();
      };
    };
    const std::vector<Contender> contenders = {{name + " on", &backend, step(skip.on, false), true},
                                               {name + " off", &off, step(skip.off, skip.reads_off), true}};
    const std::vector<Samples> samples = measure(contenders, sampling_, progress_);
    for (size_t k = 0; k < 2; ++k) record(skip, contenders[k], samples[k], k == 0);
    const Contest verdict = contest(samples[0], samples[1]);
    rows.push_back({backend.info().name, skip.name, std::to_string(scene.size()),
                    format_ms(samples[0].median_seconds()), format_ms(samples[1].median_seconds()),
                    verdict.differ ? format_percent(verdict.ratio - 1) : "no difference seen", skip.summary});
  }

  void record(const Skip& skip, const Contender& contender, const Samples& samples, bool on) {
    const WorkCounts before = contender.backend->work_counts();
    for (int k = 0; k < 4; ++k) contender.step(*contender.backend);
    json row = {{"table", "skips"},
                {"n", scene_options_.n},
                {"scene", scene_json(scene_options_)},
                {"skip", skip.name},
                {"on", on},
                {"order", skip.ordered ? "warm" : "cold"},
                {"work_a_step", work_json(before, contender.backend->work_counts())}};
    row.update(to_json(samples));
    measurements.push_back(std::move(row));
  }

  Session& session_;
  OpenOptions open_;
  const SkipsOptions& options_;
  Sampling sampling_;
  Progress progress_;
  SceneOptions scene_options_;
  Scene scene_, ordered_;
};

Table table_of(const SkipStudy& study) {
  return {"What is saved: one collision step with each skip or trick, and without",
          {{"", "backend", "", true},
           {"", "skip or trick", "", true},
           {"", "n", ""},
           {"", "on", "ms"},
           {"", "off", "ms"},
           {"", "off costs", "%"},
           {"", "what", "", true}},
          study.rows,
          study.left_out};
}

void check_names(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Skip& skip : skip_list())
    if (!std::ranges::count(known, skip.name)) known.push_back(skip.name);
  for (const std::string& name : names) require_known("skip", name, known);
}

}  // namespace

int skips_command(const CommandLine& line, const SkipsOptions& options) {
  require_known_backends(options.backends);
  check_names(options.names);
  check_writable(options.json_file);
  Session session(options.backends, line.open);
  const bool hardware = std::ranges::any_of(session.backends(), [](const auto& b) { return on_hardware(*b); });
  std::vector<uint64_t> sizes = options.sizes;
  if (sizes.empty()) sizes = hardware ? std::vector<uint64_t>{16384, 1000000} : std::vector<uint64_t>{16384};
  for (const std::string& warning : session.warnings()) fmt::print(stderr, "{}\n", warning);
  json record = {{"context", capture_context(line.words)},
                 {"backends", session.to_json()},
                 {"clocks", json::array({query_clocks()})}};
  SkipStudy study(session, line, options);
  for (const uint64_t n : sizes) study.run(n);
  record["clocks"].push_back(query_clocks());
  record["left_out"] = study.left_out;
  record["measurements"] = study.measurements;
  write_file(options.json_file, json_text(record));
  fmt::print("{}", table_of(study).text());
  return kOk;
}

std::shared_ptr<SkipsOptions> add_skips_options(CLI::App& command) {
  auto options = std::make_shared<SkipsOptions>();
  std::string help = "Only these of:\n";
  for (const Skip& skip : skip_list())
    help += fmt::format("    {:<22} {}{}\n", skip.name, skip.summary,
                        *skip.backend ? fmt::format(" ({})", skip.backend) : "");
  command.add_option("--backends", options->backends, "Only these, and each must open: cpu,glsl,cuda")->delimiter(',');
  command.add_option("--names", options->names, help)->delimiter(',');
  command.add_option("--n", options->sizes, "Numbers of spheres (default 16384, with a GPU 1000000 too)")
      ->delimiter(',')
      ->check(positive_range);
  command.add_option("--packing-fraction", options->packing_fraction, "Of the spheres")->capture_default_str();
  command.add_option("--rounds", options->rounds, "Rounds of each timing")
      ->check(whole_number(1, 1000))
      ->capture_default_str();
  command.add_option("--json", options->json_file, "The record")->capture_default_str();
  command.footer("Example:\n  spherepair skips --backends glsl,cuda --n 16384,1000000,10000000");
  return options;
}

}  // namespace spherepair
