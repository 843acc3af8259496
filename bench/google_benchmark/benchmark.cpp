// SPDX-License-Identifier: MIT
// Google Benchmark's interface to the timing core, for its compare.py. A repetition is a turn of batches of up to K
// steps; its time is that of one step.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "bench/google_benchmark/benchmark_rows.h"
#include "bench/google_benchmark/list_rows.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/io/scene_text.h"
#include "bench/options/command.h"
#include "bench/options/options.h"
#include "bench/options/program_threads.h"
#include "bench/options/run_action.h"
#include "bench/studies/study_sampling.h"

namespace spherepair {
namespace {

struct BenchOptions {
  std::vector<std::string> backends, scenes = {"random"};
  std::vector<uint64_t> sizes;  // empty: by machine
  std::vector<uint> blocks;
  int rounds = Sampling{}.rounds;
};

std::vector<SceneOptions> chosen_scenes(const BenchOptions& options, const Session& session) {
  const bool hardware = std::ranges::any_of(session.backends(), [](const auto& b) { return on_hardware(*b); });
  std::vector<uint64_t> sizes = options.sizes;
  if (sizes.empty()) sizes = {hardware ? 16384u : 4096u};
  std::vector<SceneOptions> scenes;
  for (const std::string& name : options.scenes)
    for (uint64_t n : sizes) {
      SceneOptions scene = parse_scene(name, SceneOptions{}.seed);
      if (!scene.groups) scene.n = n;
      check_options(scene);
      scenes.push_back(scene);
      if (scene.groups) break;  // an arrangement defines n
    }
  return scenes;
}

void sample_row(benchmark::State& state, BenchScene& scene, const BenchRow& row, const Sampling& sampling,
                bool& wrong) {
  BatchPlan plan;
  try {
    plan = scene.check(row, sampling);
  } catch (const DifferenceFound& difference) {
    wrong = true;
    return state.SkipWithError(difference.what());
  }
  for (auto _ : state) state.SetIterationTime(scene.sample(row, plan, sampling));
  const double n = double(scene.options().n);
  state.SetLabel(parameters_of(row, scene.options()));
  state.counters["n"] = n;
  state.counters["K"] = double(plan.steps.back());
  if (row.work != Work::collide) return;
  if (uses_blocks({row.backend, row.options})) state.counters["block"] = row.options.block;
  if (row.options.method != Method::collide_group)
    state.counters["pairs"] = benchmark::Counter(n * (n - 1) / 2, benchmark::Counter::kIsIterationInvariantRate);
}

void register_row(BenchScene& scene, const BenchRow& row, const Sampling& sampling, bool& wrong) {
  const std::string title = fmt::format("{}/{}/n:{}", row.name, scene_label(scene.options()), scene.options().n);
  benchmark::RegisterBenchmark(
      title.c_str(),
      [&scene, row, &sampling, &wrong](benchmark::State& state) { sample_row(state, scene, row, sampling, wrong); })
      ->UseManualTime()
      ->Iterations(1)
      ->Repetitions(sampling.rounds)
      ->Unit(benchmark::kMillisecond);
}

void add_context(const Session& session) {
  benchmark::AddCustomContext("commit", build_info.commit);
  benchmark::AddCustomContext("compiler", fmt::format("{} {}", build_info.compiler, build_info.flags));
  benchmark::AddCustomContext("cuda_compiler", build_info.cuda_compiler);
  for (const json& backend : session.to_json()) {
    const std::string name = backend.at("name");
    benchmark::AddCustomContext(name, backend.at(backend.at("open") ? "device" : "reason").get<std::string>());
    if (!backend.at("open")) continue;
    for (const auto& [what, value] : session.find(backend.at("name"))->info().details)
      benchmark::AddCustomContext(name + " " + what, value);
  }
}

int run_all(Session& session, const std::vector<SceneOptions>& scenes, const std::vector<BenchRow>& rows,
            const Sampling& sampling) {
  bool wrong = false;
  std::vector<std::unique_ptr<BenchScene>> made;
  for (const SceneOptions& scene : scenes) {
    made.push_back(std::make_unique<BenchScene>(session, scene));
    for (const BenchRow& row : rows) register_row(*made.back(), row, sampling, wrong);
  }
  register_list_rows(session, wrong);
  benchmark::RunSpecifiedBenchmarks();
  return wrong ? kDifference : kOk;
}

void add_options(CLI::App& app, BenchOptions& options, OpenOptions& open) {
  add_list(app, "--backends", options.backends, "Only these, and each must open: cpu,opengl,cuda,vulkan");
  add_list(app, "--scenes", options.scenes, "E.g. random,uniform,aligned:8x16");
  add_list(app, "--n", options.sizes, "Numbers of spheres (default 16384 with a GPU, else 4096)")
      ->transform(positive_range);
  add_list(app, "--blocks", options.blocks, "Only these group sizes: 32,64,128,256,512,1024");
  add_rounds_option(app, options.rounds);
  add_number(app, "--threads", open.threads, whole_number(0, 4096), "Threads of the CPU backend; 0: all cores");
  app.footer(
      "All other options go to Google Benchmark, e.g. --benchmark_filter=triangle --benchmark_out=times.json\n"
      "--benchmark_enable_random_interleaving=true");
}

int bench_command(int argc, char** argv) {
  CLI::App app("Checks, then times every backend's motion, steps, launches, methods and lists with Google Benchmark.");
  BenchOptions options;
  OpenOptions open;
  add_options(app, options, open);
  app.allow_extras();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kOk : kUsage;
  }
  std::vector<std::string> rest = app.remaining();
  std::vector<char*> words = {argv[0]};
  for (std::string& word : rest) words.push_back(word.data());
  int count = int(words.size());
  benchmark::Initialize(&count, words.data());
  if (benchmark::ReportUnrecognizedArguments(count, words.data())) return kUsage;
  const std::vector<uint> blocks = parse_blocks(options.blocks);
  start_team(open.threads);
  Session session(backend_ids(options.backends), open);
  const Sampling sampling = study_sampling(options.rounds);
  const std::vector<SceneOptions> scenes = chosen_scenes(options, session);
  const std::vector<BenchRow> rows = bench_rows(session, blocks);
  add_context(session);
  const int code = run_all(session, scenes, rows, sampling);
  benchmark::Shutdown();
  return code;
}

}  // namespace
}  // namespace spherepair

int main(int argc, char** argv) {
  spherepair::wait_passively(argv);
  return spherepair::run_action([&] { return spherepair::bench_command(argc, argv); });
}
