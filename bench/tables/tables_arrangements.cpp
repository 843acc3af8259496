// SPDX-License-Identifier: MIT
// The paper's second animation: m groups of n spheres, searched in m groups of exactly n threads.
#include <fmt/format.h>

#include "bench/tables/study.h"

namespace spherepair {
namespace {

struct Arrangement {
  uint groups, group_size;
};
constexpr Arrangement arrangements[] = {{8, 16}, {16, 8}, {8, 32}, {16, 16}, {32, 8}, {8, 64}, {16, 32}, {64, 8}};

// Tasks with groups of n, and with one group of all m x n, on every device.
std::vector<Task> tasks_of(const Study& study, const Arrangement& arrangement) {
  std::vector<Task> tasks;
  for (const uint block : {arrangement.group_size, arrangement.groups * arrangement.group_size})
    for (const Task& task : study.collide_tasks(Method::collide_tiled, block)) tasks.push_back(task);
  return tasks;
}

}  // namespace

std::vector<Table> make_arrangements(Study& study) {
  Table table{"The paper's aligned animation: m groups of n spheres",
              {{"", "m x n", "", true}, {"", "spheres", ""}, {"", "colliding", "spheres"}},
              {},
              {"collide_tiled, the paper's shader, at the start of the animation. The paper says that \"times are "
               "similar\" and gives none."}};
  for (const char* group : {"groups of n", "one group of all"})
    for (const Backend* device : study.session.devices()) table.columns.push_back({group, device->info().name, "us"});
  for (const Arrangement& arrangement : arrangements) {
    SceneOptions scene = study.paper_scene(uint64_t(arrangement.groups) * arrangement.group_size);
    scene.name = "aligned";
    scene.groups = arrangement.groups;
    scene.group_size = arrangement.group_size;
    const std::vector<Samples> samples = study.time("arrangements", scene, tasks_of(study, arrangement));
    std::vector<std::string> cells = {fmt::format("{} x {}", arrangement.groups, arrangement.group_size),
                                      std::to_string(scene.n),
                                      std::to_string(study.equality.back().checkpoints.back().colliding_spheres)};
    for (const Samples& one : samples) cells.push_back(time_cell(one, 1e6));
    table.rows.push_back(cells);
  }
  return {table};
}

}  // namespace spherepair
