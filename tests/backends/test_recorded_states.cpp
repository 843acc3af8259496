// SPDX-License-Identifier: MIT
// Row 29 of the stress catalogue: 4096 spheres, 100,000 steps, a hash of the state every 1000: equal on every backend
// of this machine and with what other machines recorded; in software the first 10,000 steps, but for STRESS=full.
// SPHEREPAIR_RECORD names a folder to leave this machine's in.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/backends.h"
#include "tests/support/catalogue.h"

namespace spherepair {
namespace {

using nlohmann::json;
using Hashes = std::vector<std::string>;
constexpr int STEPS = 100'000, EVERY = 1000;

Scene recorded_scene() {
  Scene scene = make_scene({.name = "random", .n = 4096});
  scene.restitution = 0.96875f;  // keeps bouncing for ever, on products that need rounding
  return scene;
}

Hashes hashes_of(Backend& backend) {
  Hashes hashes;
  backend.upload(recorded_scene());
  for (int step = 1; step <= by_form(backend, STEPS, STEPS / 10); ++step) {
    backend.move();
    if (step % EVERY != 0) continue;
    const Motion::State state = current_state(backend);
    hashes.push_back(fmt::format("{:016x}", state_hash(state.positions, state.velocities)));
  }
  return hashes;
}

struct Recording {
  std::string who;
  Hashes hashes;
};

void expect_equal_runs(const Recording& left, const Recording& right) {
  for (size_t k = 0; k < std::min(left.hashes.size(), right.hashes.size()); ++k)
    ASSERT_EQ(left.hashes[k], right.hashes[k])
        << left.who << " and " << right.who << " part between steps " << k * EVERY << " and " << (k + 1) * EVERY;
}

const std::vector<Recording>& runs_here() {
  static const std::vector<Recording> runs = [] {
    std::vector<Recording> all;
    for (Backend* backend : open_backends())
      all.push_back({fmt::format("{} ({})", backend->info().name, backend->info().device), hashes_of(*backend)});
    return all;
  }();
  return runs;
}

void record(const std::vector<Recording>& runs, const std::filesystem::path& folder) {
  const Scene scene = recorded_scene();
  json file = {{"scene", "random"}, {"n", scene.size()}, {"every", EVERY}, {"restitution", scene.restitution}};
  file["start"] = fmt::format("{:016x}", state_hash(scene.positions, scene.velocities));
  for (const Recording& run : runs) file["runs"].push_back({{"backend", run.who}, {"hashes", run.hashes}});
  std::filesystem::create_directories(folder);
  std::ofstream stream(folder / "state_hashes.json");
  stream << file.dump(1) << '\n';
  if (!stream) throw std::runtime_error(fmt::format("cannot write state_hashes.json in {}", folder.string()));
}

// Where the recordings are: in the sources, or in SPHEREPAIR_DATA when the program was carried elsewhere.
std::filesystem::path data_folder() {
  const char* elsewhere = std::getenv("SPHEREPAIR_DATA");
  return elsewhere ? elsewhere : SPHEREPAIR_DATA;
}

std::vector<std::filesystem::path> recorded_files() {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(data_folder())) return files;
  for (const auto& machine : std::filesystem::directory_iterator(data_folder()))
    if (std::filesystem::exists(machine.path() / "state_hashes.json"))
      files.push_back(machine.path() / "state_hashes.json");
  return files;
}

TEST(RecordedStates, Row29_EqualOnAllBackends) {
  const std::vector<Recording>& runs = runs_here();
  ASSERT_FALSE(runs.empty());
  for (const Recording& run : runs) {
    expect_equal_runs(runs.front(), run);
    EXPECT_GE(run.hashes.size(), size_t(STEPS / 10 / EVERY)) << run.who;
    note_figure(fmt::format("{}: {} steps, a hash every {}", run.who, run.hashes.size() * EVERY, EVERY));
  }
  for (const OpenedBackend& entry : all_backends())
    EXPECT_TRUE(entry.backend || !backend_required(entry.name)) << entry.name << " is missing: " << entry.reason;
  const Hashes& hashes = runs.front().hashes;
  EXPECT_EQ(std::adjacent_find(hashes.begin(), hashes.end()), hashes.end()) << "the scene came to rest";
  if (const char* folder = std::getenv("SPHEREPAIR_RECORD")) record(runs, folder);
}

TEST(RecordedStates, Row29_EqualWithOtherMachines) {
  const std::vector<std::filesystem::path> files = recorded_files();
  if (files.empty()) GTEST_SKIP() << "no recorded state_hashes.json below " << data_folder();
  for (const auto& path : files) {
    const json file = json::parse(std::ifstream(path));
    const Scene scene = recorded_scene();
    EXPECT_EQ(file.at("start"), fmt::format("{:016x}", state_hash(scene.positions, scene.velocities))) << path;
    for (const json& run : file.at("runs")) {
      const Recording recorded = {path.parent_path().filename().string() + ": " + run.at("backend").get<std::string>(),
                                  run.at("hashes").get<Hashes>()};
      expect_equal_runs(runs_here().front(), recorded);
      note_figure(recorded.who);
    }
  }
}

}  // namespace
}  // namespace spherepair
