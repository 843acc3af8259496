// SPDX-License-Identifier: MIT
#include "bench/tables/plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/io/arguments.h"
#include "bench/io/scene_text.h"
#include "bench/tables/study.h"
#include "common/scene/contact_scenes.h"

namespace spherepair {
namespace {

using Sizes = std::vector<uint64_t>;

SceneOptions scene_of(const std::string& name, uint64_t seed, float radius_ratio = 1) {
  SceneOptions options;
  options.name = name;
  options.seed = seed;
  options.radius_ratio = radius_ratio;
  return options;
}

// Every scene, and one with unequal radii, which uses another variant of each kernel.
std::vector<SceneOptions> all_scenes(uint64_t seed, bool contacts) {
  std::vector<SceneOptions> scenes;
  for (const SceneKind& kind : scene_kinds())
    if (made_for_contacts(kind.name) == contacts) scenes.push_back(scene_of(kind.name, seed));
  if (!contacts) scenes.push_back(scene_of("uniform", seed, 16));
  return scenes;
}

// A machine with a GPU also checks the sizes of a machine without one, so that `equal` can compare their results.
void fill_sizes(Plan& plan) {
  const std::vector<uint> all(block_sizes().begin(), block_sizes().end());
  plan.paper_sizes = plan.step_sizes = {64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768};
  plan.count_sizes = {64, 128, 256, 512, 32768};
  if (plan.hardware) {
    plan.checks = {{500, 10, all}, {4096, 2, {64, 256}}, {1000, 20, all}, {16384, 3, all}};
    plan.method_sizes = plan.exactness_sizes = {16384};
    plan.scale_sizes = {1024, 4096, 16384, 65536, 262144, 1048576};
    plan.grid_sizes = {1024, 4096, 16384, 65536, 1'000'000, 10'000'000};
  } else {
    plan.checks = {{500, 5, all}, {3000, 2, {CollideOptions{}.block}}};
    plan.method_sizes = {1024};
    plan.exactness_sizes = {2048};
    plan.scale_sizes = plan.grid_sizes = {1024, 4096, 16384};
    plan.step_sizes = {64, 256, 1024, 4096, 16384};
    plan.count_steps_large = 20;
    plan.grazing_pairs = 1000;
    plan.row_seconds = 4;
    plan.sampling.software_seconds = 0.02;
    plan.sampling.longest = 0.1;
  }
}

void shrink(Plan& plan) {
  plan.checks = {{500, 3, plan.blocks}};
  plan.paper_sizes = {64, 1024, 4096};
  plan.step_sizes = plan.scale_sizes = plan.grid_sizes = {1024, 4096};
  plan.count_sizes = {64, 128, 256, 512};
  plan.method_sizes = plan.exactness_sizes = {1024};
  plan.count_steps = 100;
  plan.row_seconds = 5;
  plan.sampling.rounds = plan.hardware ? 11 : fewest_for_interval;
  plan.sampling.software_seconds = 0.01;
}

void extend(Plan& plan) {
  const Sizes paper = {64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768};
  plan.checks = {{1, 3, plan.blocks}, {1000, 100, plan.blocks}, {16384, 10, plan.blocks}};
  plan.step_sizes = paper;
  plan.row_seconds = 1e9;
  plan.method_sizes = plan.hardware ? Sizes{1024, 4096, 16384, 65536, 262144} : Sizes{1024, 4096, 16384};
  plan.exactness_sizes = plan.hardware ? Sizes{4096, 16384, 65536, 262144} : Sizes{4096, 16384};
  plan.count_steps_large = plan.hardware ? 1000 : 100;
  plan.sampling.rounds = plan.hardware ? 31 : 11;
}

void override_sizes(Plan& plan, const PlanOptions& options) {
  for (CheckSize& check : plan.checks) {
    if (options.steps >= 0) check.steps = uint64_t(options.steps);
    if (!options.blocks.empty()) check.blocks = plan.blocks;
  }
  if (options.sizes.empty()) return;
  const uint64_t steps = plan.checks.front().steps;
  const std::vector<uint> blocks = plan.checks.front().blocks;
  plan.checks.clear();
  for (uint64_t n : options.sizes) plan.checks.push_back({n, steps, blocks});
  plan.row_seconds = 1e9;
  plan.paper_sizes = plan.method_sizes = plan.exactness_sizes = plan.scale_sizes = plan.step_sizes = plan.grid_sizes =
      options.sizes;
}

std::vector<std::string> chosen_tables(const std::vector<std::string>& wanted) {
  std::vector<std::string> known;
  for (const TableKind& kind : table_kinds()) known.push_back(kind.name);
  if (wanted.empty()) return known;
  if (wanted.size() == 1 && wanted[0] == "none") return {};
  for (const std::string& name : wanted) require_known("table", name, known);
  return wanted;
}

}  // namespace

Plan make_plan(const PlanOptions& options, bool hardware) {
  if (options.quick && options.full) throw std::invalid_argument("--quick and --full exclude each other");
  Plan plan;
  plan.level = options.quick ? Level::quick : options.full ? Level::full : Level::standard;
  plan.hardware = hardware;
  plan.seed = plan.sampling.seed = options.seed;
  plan.every = options.every;
  plan.contact = contact_choice(options.motion);
  const bool contacts = plan.contact.law != ContactLaw::none;
  plan.scenes = all_scenes(options.seed, contacts);
  if (!options.scenes.empty()) plan.scenes.clear();
  for (const std::string& name : options.scenes) plan.scenes.push_back(parse_scene(name, options.seed));
  for (SceneOptions& scene : plan.scenes) choose_motion(scene, options.motion);
  plan.methods = parse_methods(options.methods);
  if (plan.contact.periodic && options.methods.empty()) std::erase(plan.methods, Method::collide_group);
  plan.blocks = parse_blocks(options.blocks);
  if (std::ranges::find(plan.blocks, plan.table_block) == plan.blocks.end()) plan.table_block = plan.blocks.front();
  fill_sizes(plan);
  if (options.quick) shrink(plan);
  if (options.full) extend(plan);
  override_sizes(plan, options);
  plan.tables = chosen_tables(options.tables);
  if (contacts && !plan.tables.empty())
    throw std::invalid_argument("no table times contacts: give --tables none with --contact");
  if (options.rounds > 0) plan.sampling.rounds = options.rounds;
  if (options.min_seconds > 0) plan.sampling.hardware_seconds = plan.sampling.software_seconds = options.min_seconds;
  return plan;
}

bool is_wanted(const Plan& plan, Method method) {
  return std::ranges::find(plan.methods, method) != plan.methods.end();
}

}  // namespace spherepair
