// SPDX-License-Identifier: MIT
// The numbers of colliding spheres in the original paper and ours: evidence that our scene is the paper's.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "bench/io/arguments.h"
#include "bench/io/scene_text.h"
#include "bench/tables/study.h"

namespace spherepair {
namespace {

struct Range {
  uint64_t low, high;
  std::string text() const { return low == high ? fmt::format("{}", low) : fmt::format("{}-{}", low, high); }
};
struct PaperCounts {
  uint64_t n;
  std::optional<Range> sequential, parallel;
};
const PaperCounts paper_counts[] = {{64, Range{0, 4}, Range{0, 4}},
                                    {128, Range{7, 15}, Range{6, 20}},
                                    {256, Range{20, 40}, Range{15, 48}},
                                    {512, Range{100, 159}, Range{93, 139}},
                                    {32768, std::nullopt, Range{32000, 32000}}};

const char* columns_containing(const PaperCounts& paper, uint64_t count) {
  if (paper.n == 32768) return count >= 31000 && count <= 32768 ? "about" : "no";
  const bool in_sequential = paper.sequential && count >= paper.sequential->low && count <= paper.sequential->high;
  const bool in_parallel = paper.parallel && count >= paper.parallel->low && count <= paper.parallel->high;
  return in_sequential && in_parallel ? "both" : in_sequential ? "sequential" : in_parallel ? "parallel" : "no";
}

// Colliding spheres over the animation, counted by the fastest backend after all backends agreed on frame 0.
std::vector<std::string> count_row(Study& study, const SceneOptions& scene, const PaperCounts* paper) {
  const uint64_t steps = scene.n > 16384 ? study.plan.count_steps_large : study.plan.count_steps;
  std::vector<Configuration> configurations;
  for (const auto& backend : study.session.backends())
    configurations.push_back(
        {backend.get(), {.method = backend->info().on_host ? Method::parallel : Method::collide_triangle}});
  const uint64_t first = study.check(scene, configurations).totals.colliding_spheres;
  Range range{first, first};
  const auto hardware =
      std::ranges::find_if(configurations, [](const Configuration& one) { return on_hardware(*one.backend); });
  const Configuration counter = hardware == configurations.end() ? configurations.front() : *hardware;
  for (uint64_t step = 1; step <= steps; ++step) {
    study.progress.say(fmt::format("counts: {} n = {}, step {} of {}", scene_label(scene), scene.n, step, steps));
    counter.backend->move();
    study.session.collide(*counter.backend, counter.options);
    const uint64_t count = counter.backend->collisions().colliding_spheres;
    range = {std::min(range.low, count), std::max(range.high, count)};
  }
  const bool known = paper != nullptr;
  return {scene_label(scene),
          std::to_string(scene.n),
          std::to_string(first),
          fmt::format("{}-{}", range.low, range.high),
          std::to_string(steps),
          known && paper->sequential ? paper->sequential->text() : "-",
          known && paper->parallel ? (scene.n == 32768 ? "32000" : paper->parallel->text()) : "-",
          known ? columns_containing(*paper, first) : "-"};
}

}  // namespace

std::vector<Table> make_counts(Study& study) {
  Table table{
      "Colliding spheres: ours and the paper's",
      {{"", "scene", "", true},
       {"", "n", ""},
       {"ours", "frame 0", "spheres"},
       {"ours", "min-max", "spheres"},
       {"ours", "over", "steps"},
       {"the paper's range", "sequential", "spheres"},
       {"the paper's range", "parallel", "spheres"},
       {"", "frame 0 in range", "", true}},
      {},
      {"A step is 1/64 s. The paper does not say over how many steps its ranges were taken; it says \"32,000\" for "
       "32768. For its aligned animation it gives arrangements but no counts."}};
  for (const PaperCounts& paper : paper_counts)
    if (std::ranges::find(study.plan.count_sizes, paper.n) != study.plan.count_sizes.end())
      table.rows.push_back(count_row(study, study.paper_scene(paper.n), &paper));
  for (const char* shape : {"8x16", "16x8", "8x32", "16x16", "32x8", "8x64", "16x32", "64x8"})
    table.rows.push_back(count_row(study, parse_scene(fmt::format("aligned:{}", shape), study.plan.seed), nullptr));
  return {table};
}

}  // namespace spherepair
