// SPDX-License-Identifier: MIT
// Google Benchmark's view of the same timing core, for its compare.py: every method on every backend. A repetition is
// one sample of K steps; its time is that of one step.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <set>

#include "context.h"
#include "study.h"

namespace spherepair {
namespace {

struct Case {
  const char* backend;
  Method method;
};
constexpr Case cases[] = {{"cpu", Method::sequential},      {"cpu", Method::parallel},
                          {"glsl", Method::collide_group},  {"glsl", Method::collide_tiled},
                          {"glsl", Method::collide_square}, {"glsl", Method::collide_triangle},
                          {"cuda", Method::collide_group},  {"cuda", Method::collide_tiled},
                          {"cuda", Method::collide_square}, {"cuda", Method::collide_triangle}};

// One scene for all, uploaded once; each case is checked against the reference before its first sample.
struct Bench {
  Session session{{}, {}};
  SceneOptions scene;
  Sampling sampling;
  std::map<std::string, uint64_t> batches;  // of the checked cases

  Bench() {
    const bool hardware = std::ranges::any_of(session.backends(), [](const auto& b) { return on_hardware(*b); });
    scene.n = hardware ? 16384 : 4096;
    const Scene made = make_scene(scene);
    for (const auto& backend : session.backends()) backend->upload(made);
  }

  uint64_t checked_batch(const Asked& asked, const Contender& contender) {
    const auto known = batches.find(label(asked));
    if (known != batches.end()) return known->second;
    const Asked reference = reference_for(session, asked.options, scene.n);
    const Answer expected = ask(session, reference, false);
    require_equal(session, {scene, 0}, reference, expected, asked, ask(session, asked, false));
    return batches[label(asked)] = choose_batch(contender, sampling);
  }
};

void sample_case(benchmark::State& state, Bench& bench, Backend& backend, Method method, uint block) {
  const Asked asked{&backend, {.method = method, .block = block}};
  const Contender contender{label(asked), &backend, [&](Backend& b) { b.collide(asked.options); }};
  uint64_t batch = 0;
  try {
    batch = bench.checked_batch(asked, contender);
  } catch (const DifferenceFound& difference) {
    return state.SkipWithError(difference.what());
  }
  for (auto _ : state) state.SetIterationTime(time_batch(contender, batch) / double(batch));
  const double n = double(bench.scene.n);
  state.counters["n"] = n;
  if (uses_blocks(asked)) state.counters["block"] = block;
  state.counters["K"] = double(batch);
  if (method != Method::collide_group)
    state.counters["pairs"] = benchmark::Counter(n * (n - 1) / 2, benchmark::Counter::kIsIterationInvariantRate);
}

void register_cases(Bench& bench) {
  for (const auto& [name, method] : cases) {
    Backend* backend = bench.session.find(name);
    if (!backend) continue;
    for (uint block : block_sizes()) {
      const bool blocks = uses_blocks({backend, {.method = method}});
      const std::string title =
          fmt::format("{}/{}{}", name, method_name(method), blocks ? fmt::format("/{}", block) : "");
      benchmark::RegisterBenchmark(title.c_str(),
                                   [&bench, backend, method = method, block](benchmark::State& state) {
                                     sample_case(state, bench, *backend, method, block);
                                   })
          ->UseManualTime()
          ->Iterations(1)
          ->Repetitions(bench.sampling.rounds)
          ->Unit(benchmark::kMillisecond);
      if (!blocks) break;
    }
  }
}

void add_context(const Session& session) {
  const json context = capture_context({});
  benchmark::AddCustomContext("commit", build_info.commit);
  benchmark::AddCustomContext("compiler", fmt::format("{} {}", build_info.compiler, build_info.flags));
  benchmark::AddCustomContext("cuda_compiler", build_info.cuda_compiler);
  benchmark::AddCustomContext("cpu", context["machine"]["cpu"].get<std::string>());
  for (const json& backend : session.to_json()) {
    const std::string name = backend.at("name");
    benchmark::AddCustomContext(name, backend.at(backend.at("open") ? "device" : "reason").get<std::string>());
    if (!backend.at("open")) continue;
    for (const auto& [what, value] : backend.at("details").items())
      benchmark::AddCustomContext(name + " " + what, value.get<std::string>());
  }
}

}  // namespace
}  // namespace spherepair

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  try {
    spherepair::Bench bench;
    spherepair::add_context(bench.session);
    spherepair::register_cases(bench);
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    fmt::print(stderr, "spherepair_bench: {}\n", error.what());
    return 3;
  }
  benchmark::Shutdown();
  return 0;
}
