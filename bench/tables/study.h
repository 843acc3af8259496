// SPDX-License-Identifier: MIT
// Validate, then time: the basis of every table.
#pragma once

#include "bench/check/lockstep.h"
#include "bench/studies/study_report.h"
#include "bench/tables/api_verdict.h"
#include "bench/tables/plan.h"

namespace spherepair {

enum class Work { move, collide, step };  // step: move, then collide

struct Task {
  Work work;
  Configuration configuration;
  std::string contest = {};  // empty: with the same work, method and options on other backends
};
std::string label(const Task& task);

class Study {
 public:
  Study(Session& session, const Plan& plan, Progress& progress) : session(session), plan(plan), progress(progress) {}

  // Uploads the scene, checks the result of every task in the configuration to be timed (throws DifferenceFound), then
  // times all tasks in interleaved rounds. Returns samples in the order of the tasks and keeps them for the record.
  std::vector<Samples> time(const std::string& table, const SceneOptions& scene, const std::vector<Task>& tasks);

  // The cells of add_contest_columns. Keeps the contests for the last lines of the run.
  std::vector<std::string> compare(const std::string& table, std::span<const Samples> samples);

  // Times and records contenders that have no result to check.
  std::vector<Samples> time_unchecked(const std::string& table, const std::vector<Contender>& contenders,
                                      const json& meta);

  // Uploads the scene to every backend, compares the configurations' results and records that they are equal.
  StepResult check(const SceneOptions& scene, const std::vector<Configuration>& configurations);

  std::vector<Task> collide_tasks(Method method, uint block, bool exact = true) const;  // on every device
  SceneOptions paper_scene(uint64_t n) const;

  Session& session;
  const Plan& plan;
  Progress& progress;
  json measurements = json::array();
  std::vector<EqualityEntry> equality;
  std::vector<ApiContest> contests;

 private:
  void upload(const SceneOptions& options);
  void plan_comparisons(const SceneOptions& scene, const std::vector<Configuration>& configurations, uint64_t steps);
  void check_step(const SceneOptions& scene, const std::vector<Configuration>& configurations, uint64_t step);
  void check_steps(const SceneOptions& scene, const std::vector<Configuration>& configurations, uint64_t steps);
  void record(const std::string& table, const SceneOptions& scene, const Task& task, const Samples& samples);

  std::map<std::string, std::string> references_;  // by set: label of the last check's reference
};

// Iterates over a table's sizes. Without a GPU leaves out sizes that would take too long.
class SizeSequence {
 public:
  SizeSequence(const Study& study, std::vector<uint64_t> sizes) : study_(study), sizes_(std::move(sizes)) {}
  bool next();  // false at the end, or if the next size would take too long
  uint64_t n() const { return sizes_[at_ - 1]; }
  void measured(std::span<const Samples> samples) { last_.assign(samples.begin(), samples.end()), last_n_ = n(); }
  std::vector<std::string> notes() const { return notes_; }  // the sizes that were left out

 private:
  const Study& study_;
  std::vector<uint64_t> sizes_;
  size_t at_ = 0;
  uint64_t last_n_ = 0;
  std::vector<Samples> last_;
  std::vector<std::string> notes_;
};

// Adds a column for each device except the baseline: its time over the baseline's.
void add_contest_columns(Table& table, const Session& session);

struct TableKind {
  const char *name, *summary;
  std::vector<Table> (*make)(Study&);
};
const std::vector<TableKind>& table_kinds();

std::vector<Table> make_table1(Study& study);
std::vector<Table> make_frame_rates(Study& study);
std::vector<Table> make_peak_rates(Study& study);
std::vector<Table> make_counts(Study& study);
std::vector<Table> make_arrangements(Study& study);
std::vector<Table> make_methods(Study& study);
std::vector<Table> make_overhead(Study& study);
std::vector<Table> make_exactness(Study& study);
std::vector<Table> make_scale(Study& study);
std::vector<Table> make_step(Study& study);
std::vector<Table> make_grid(Study& study);
std::vector<Table> make_equality(Study& study);

}  // namespace spherepair
