// SPDX-License-Identifier: MIT
#include "bench/google_benchmark/list_rows.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <map>
#include <random>

#include "common/lists/device_lists.h"
#include "common/lists/pair_list.h"

namespace spherepair {
namespace {

using Clock = std::chrono::steady_clock;

ListBox box_of(const Point3& edges) {
  return {{{{edges[0], 0, 0}, {0, edges[1], 0}, {0, 0, edges[2]}}}, {true, true, true}};
}

// Appends a system: cells of a crystal with the lattice constant `a` along x, y and z.
void add_crystal(ListProblem& problem, std::array<int, 3> cells, double a, const std::vector<Point3>& basis) {
  if (problem.set.offsets.empty()) problem.set.offsets = {0};
  for (int x = 0; x < cells[0]; ++x)
    for (int y = 0; y < cells[1]; ++y)
      for (int z = 0; z < cells[2]; ++z)
        for (const Point3& at : basis)
          problem.set.points.push_back({(x + at[0]) * a, (y + at[1]) * a, (z + at[2]) * a});
  problem.set.offsets.push_back(problem.set.points.size());
  problem.boxes.push_back(box_of({cells[0] * a, cells[1] * a, cells[2] * a}));
}

const std::vector<Point3> caesium_chloride = {{0, 0, 0}, {0.5, 0.5, 0.5}};
const std::vector<Point3> face_centred = {{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}};

ListProblem crystal(double cutoff, std::array<int, 3> cells, double a, const std::vector<Point3>& basis, int systems) {
  ListProblem problem;
  problem.cutoff = cutoff;
  for (int b = 0; b < systems; ++b) add_crystal(problem, cells, a, basis);
  return problem;
}

// Random points of which spheres with the cutoff as their diameter would fill this part of a unit cube.
ListProblem packed(uint64_t n, double fraction) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> along(0, 1);
  ListProblem problem;
  problem.set.points.resize(n);
  for (Point3& point : problem.set.points)
    for (double& x : point) x = along(random);
  problem.set.offsets = {0, n};
  problem.boxes = {ListBox{}};
  problem.cutoff = std::cbrt(6 * fraction / (3.14159265358979 * double(n)));
  return problem;
}

// As many other random points ask for their neighbours among these, in no order.
ListProblem asked(uint64_t n, double fraction) {
  ListProblem problem = packed(2 * n, 2 * fraction);  // whose cutoff is that of n points
  const auto middle = problem.set.points.begin() + ptrdiff_t(n);
  problem.asks = true;
  problem.queries.points.assign(middle, problem.set.points.end());
  problem.queries.offsets = {0, n};
  problem.set.points.resize(n);
  problem.set.offsets = {0, n};
  return problem;
}

// A million points on a cubic lattice, 0.1 apart. Each is moved along each axis by up to `off` times 0.1.
ListProblem cubic(double off, double cutoff) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> moved(-off, off);
  ListProblem problem;
  for (int k = 0; k < 1000000; ++k)
    problem.set.points.push_back(
        {(k % 100 + moved(random)) * 0.1, (k / 100 % 100 + moved(random)) * 0.1, (k / 10000 + moved(random)) * 0.1});
  problem.set.offsets = {0, problem.set.size()};
  problem.boxes = {ListBox{}};
  problem.cutoff = cutoff;
  return problem;
}

struct ListScene {
  const char* name;
  ListProblem (*make)();
  bool wants_shifts;
  bool is_large;  // for devices that make lists
};
// Lengths of crystals in angstroms: caesium chloride, and fcc with 42 neighbours within 5.
constexpr ListScene scenes[] = {{"cscl-128-6",
                                 [] {
                                   return crystal(6, {4, 4, 4}, 4.119, caesium_chloride, 1);
                                 },
                                 true, false},
                                {"fcc-512x64-5",
                                 [] {
                                   return crystal(5, {2, 2, 4}, 3.8, face_centred, 512);
                                 },
                                 true, false},
                                {"cscl-137842-6",
                                 [] {
                                   return crystal(6, {41, 41, 41}, 4.119, caesium_chloride, 1);
                                 },
                                 true, true},
                                {"cscl-137842-15",
                                 [] {
                                   return crystal(15, {41, 41, 41}, 4.119, caesium_chloride, 1);
                                 },
                                 true, true},
                                {"fcc-524288-5",
                                 [] {
                                   return crystal(5, {32, 64, 64}, 3.8, face_centred, 1);
                                 },
                                 true, true},
                                {"fcc-512x2048-5",
                                 [] {
                                   return crystal(5, {8, 8, 8}, 3.8, face_centred, 512);
                                 },
                                 true, true},
                                {"packed-1e6", [] { return packed(1000000, 0.3); }, false, true},
                                {"packed-1e7", [] { return packed(10000000, 0.3); }, false, true},
                                // Which stage decides about the six neighbours of each point.
                                {"cubic-1e6-by-float32", [] { return cubic(0, 0.105); }, false, true},
                                {"cubic-1e6-by-float64", [] { return cubic(1e-9, 0.1); }, false, true},
                                {"cubic-1e6-by-integers", [] { return cubic(0, 0.1); }, false, true},
                                {"queries-1e6-sparse", [] { return asked(1000000, 0.3); }, false, true},
                                {"queries-1e6-dense", [] { return asked(1000000, 5); }, false, true}};

struct Timed {
  int64_t pairs;
  double seconds;
  std::map<std::string, double> stages = {};  // microseconds of each kernel, on the device's timer
};

// The device that makes a backend's lists; null: the host makes them through a search.
Device* list_device(Backend& backend) {
  Device* const device = backend.device();
  return device && device->capabilities().makes_lists ? device : nullptr;
}

// Points and columns stay in the device's memory.
Timed time_on_device(Device& device, const ListProblem& problem, bool wants_shifts) {
  DeviceLists lists(device);
  lists.begin(problem);
  lists.write_points(problem);
  lists.count();
  const int64_t pairs = lists.found().pairs;
  lists.set_columns(LIST_WANTS_FIRST | LIST_WANTS_SECOND | (wants_shifts ? LIST_WANTS_SHIFTS : 0), pairs);
  const auto run = [&](int turns) {
    device.wait();
    const auto start = Clock::now();
    for (int turn = 0; turn < turns; ++turn) lists.count(), lists.fill();
    device.wait();
    return std::chrono::duration<double>(Clock::now() - start).count() / turns;
  };
  const double once = (run(1), run(1));
  Timed timed{pairs, run(std::clamp(int(0.05 / once), 1, 200))};
  device.time_stages(true);
  run(1);
  for (const StageTime& stage : device.stage_times()) timed.stages[stage.stage] += stage.seconds * 1e6;
  device.time_stages(false);
  return timed;
}

Timed time_on_host(Search& search, const ListProblem& problem) {
  const auto start = Clock::now();
  const auto list = list_pairs(search, problem);
  return {int64_t(list.size()), std::chrono::duration<double>(Clock::now() - start).count()};
}

// The list's pairs in one number.
uint64_t hash_of(Search& search, const ListProblem& problem) {
  uint64_t hash = 0;
  for (const ListedPair& pair : list_pairs(search, problem))
    for (const uint64_t word : {uint64_t(pair.first), uint64_t(pair.second), uint64_t(uint32_t(pair.shift[0])),
                                uint64_t(uint32_t(pair.shift[1])), uint64_t(uint32_t(pair.shift[2]))})
      hash = (hash ^ word) * 0x9E3779B97F4A7C15u, hash ^= hash >> 29;
  return hash;
}

struct Answer {
  std::string by;
  int64_t pairs;
  uint64_t hash;
};
using Answers = std::map<std::string, Answer>;  // by scene, of the backend that answered first

void time_list(benchmark::State& state, Backend& backend, const ListScene& scene, Answers& answers, bool& wrong) {
  const ListProblem problem = scene.make();
  Device* const device = list_device(backend);
  for (auto _ : state) {
    const Timed timed = device ? time_on_device(*device, problem, scene.wants_shifts) : time_on_host(backend, problem);
    state.SetIterationTime(timed.seconds);
    state.counters["n"] = double(problem.set.size());
    state.counters["pairs"] = double(timed.pairs);
    for (const auto& [stage, microseconds] : timed.stages) state.counters[stage + "_us"] = microseconds;
    const Answer own{backend.info().name, timed.pairs, scene.is_large ? 0 : hash_of(backend, problem)};
    const Answer& first = answers.try_emplace(scene.name, own).first->second;
    if (first.pairs == own.pairs && first.hash == own.hash) continue;
    wrong = true;
    state.SkipWithError(
        fmt::format("{} has {} pairs, {} has {}, or others", own.by, own.pairs, first.by, first.pairs).c_str());
  }
}

}  // namespace

void register_list_rows(Session& session, bool& wrong) {
  static Answers answers;
  for (const ListScene& scene : scenes)
    for (const auto& backend : session.backends()) {
      if (scene.is_large && !list_device(*backend)) continue;
      benchmark::RegisterBenchmark(fmt::format("{}/list/{}", backend->info().name, scene.name).c_str(),
                                   [&scene, &backend = *backend, &wrong](benchmark::State& state) {
                                     time_list(state, backend, scene, answers, wrong);
                                   })
          ->UseManualTime()
          ->Iterations(1)
          ->Repetitions(5)
          ->Unit(benchmark::kMillisecond);
    }
}

}  // namespace spherepair
