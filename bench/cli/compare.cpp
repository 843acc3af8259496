// SPDX-License-Identifier: MIT
// spherepair compare and spherepair equal
#include <fmt/format.h>

#include <chrono>

#include "bench/cli/commands.h"
#include "bench/formats/files.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/tables/study.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

// Everything in results.json. It is rewritten after every table, so that an interrupted run keeps what it measured.
class Record {
 public:
  Record(std::filesystem::path folder, const CommandLine& line, const Session& session, const StudyLoad& load,
         const Plan& plan)
      : folder_(std::move(folder)), session_(session), load_(load) {
    constexpr const char* levels[] = {"quick", "standard", "full"};
    root_ = {{"format", results_format},
             {"verdict", "unfinished"},
             {"context", capture_context(line.words)},
             {"backends", session.to_json()},
             {"warnings", load.warnings(session)},
             {"seed", plan.seed},
             {"level", levels[size_t(plan.level)]},
             {"rounds", plan.sampling.rounds},
             {"clocks", json::array()},
             {"tables", json::object()}};
  }

  void add_clocks(const std::string& when) { root_["clocks"].push_back({{"when", when}, {"gpus", query_clocks()}}); }
  void add_tables(const std::string& name, const std::vector<Table>& tables) {
    for (const Table& table : tables) root_["tables"][name].push_back(table.to_json());
  }
  void set(const char* name, json value) { root_[name] = std::move(value); }

  void write(const Study& study) {
    json equality = json::array();
    for (const EqualityEntry& entry : study.equality) equality.push_back(to_json(entry));
    root_["equality"] = std::move(equality);
    root_["comparisons"] = study.session.comparisons.to_json();
    root_["measurements"] = study.measurements;
    root_["warnings"] = load_.warnings(session_);
    write_file(folder_ / "results.json", json_text(root_));
  }

  // Writes the tables as text, and their samples as CSV. If there are no samples, the CSV has the last table.
  void write_tables(const std::string& name, const std::vector<Table>& tables, const json& measurements) {
    json timed = json::array();
    for (const json& row : measurements)
      if (row.at("table") == name) timed.push_back(row);
    const auto page = [&](size_t width) { return text_of(tables, width) + load_.text(session_); };
    write_page(folder_, name, page, timed.empty() && !tables.empty() ? csv_of(tables.back()) : samples_csv(timed));
  }

 private:
  std::filesystem::path folder_;
  const Session& session_;
  const StudyLoad& load_;
  json root_;
};

// The files that the record will write.
std::vector<std::string> files_of(const Plan& plan) {
  std::vector<std::string> files = {"results.json"};
  for (const std::string& table : plan.tables) files.insert(files.end(), {table + ".txt", table + ".csv"});
  return files;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void check_all(Study& study) {
  for (const CheckSize& check : study.plan.checks) {
    const auto start = std::chrono::steady_clock::now();
    for (const SceneOptions& scene : study.plan.scenes) {
      LockstepPlan plan{scene, check.steps, study.plan.every, study.plan.methods, check.blocks, study.plan.contact};
      if (!scene.groups) plan.scene.n = check.n;
      for (EqualityEntry& entry : check_lockstep(study.session, plan, study.progress))
        study.equality.push_back(std::move(entry));
    }
    study.progress.clear();
    fmt::print("checked {} of {} over {} in {:.0f} s: all sets{} equal\n", counted(study.plan.scenes.size(), "scene"),
               counted(check.n, "sphere"), counted(check.steps, "step"), seconds_since(start),
               study.session.backends().size() > 1 ? " and states" : "");
    std::fflush(stdout);
  }
}

void make_tables(Study& study, Record& record) {
  record.add_clocks("before the tables");
  for (const TableKind& kind : table_kinds()) {
    if (std::ranges::find(study.plan.tables, kind.name) == study.plan.tables.end()) continue;
    const std::vector<Table> tables = kind.make(study);
    record.add_clocks(std::string("after ") + kind.name);
    study.progress.clear();
    if (!tables.empty()) fmt::print("\n{}", text_of(tables, kTextWidth));
    std::fflush(stdout);
    record.add_tables(kind.name, tables);
    record.write_tables(kind.name, tables, study.measurements);
    record.write(study);
  }
}

// asked: the user named the backends, so missing ones are not reported.
void print_heading(const Session& session, const StudyLoad& load, const Plan& plan, bool asked) {
  fmt::print("spherepair {} ({})\n{}", build_info.version, build_info.commit, session.summary());
  if (!session.find("cpu"))
    fmt::print("The CPU is not among the backends: {} is the reference.\n", session.reference().info().name);
  if (!asked && session.devices().size() < 2)
    fmt::print("OpenGL and CUDA do not both run here, so they are not compared with each other.\n");
  fmt::print("Every timing has {}{}.\n", counted(plan.sampling.rounds, "round"),
             plan.sampling.rounds < fewest_for_interval ? ", too few for an interval of 95 %" : "");
  for (const std::string& warning : load.warnings(session)) fmt::print("\n{}\n", wrapped(warning, "* ", "  "));
  fmt::print("\n");
  std::fflush(stdout);
}

std::string names_of(const Session& session) {
  std::vector<std::string> names;
  for (const auto& backend : session.backends()) names.push_back(backend->info().name);
  return fmt::to_string(fmt::join(names, ", "));
}

}  // namespace

int compare_command(const CommandLine& line, const CompareOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::filesystem::path folder = prepare_results(
      options.results, files_of(make_plan(options.plan, false)));  // throws for bad values before any work
  const StudyLoad load(line.clocks);
  Session session(options.backends, line.open, line.opener);
  const bool hardware =
      std::ranges::any_of(session.backends(), [](const auto& backend) { return on_hardware(*backend); });
  const Plan plan = make_plan(options.plan, hardware);
  print_heading(session, load, plan, !options.backends.empty());
  Progress progress;
  Study study(session, plan, progress);
  Record record(folder, line, session, load, plan);
  try {
    check_all(study);
    make_tables(study, record);
    session.comparisons.require_complete();
  } catch (const DifferenceFound& difference) {
    progress.clear();
    record.set("verdict", "difference");
    record.set("difference", difference.details);
    record.write(study);
    throw;
  } catch (const std::exception& error) {
    progress.clear();
    record.set("verdict", "error");
    record.set("error", error.what());
    record.write(study);
    throw;
  }
  const double seconds = seconds_since(start);
  record.set("verdict", "equal");
  const std::vector<std::string> apis = api_verdicts(session, study.contests);
  record.set("seconds", seconds);
  record.set("apis", apis);
  record.write(study);
  fmt::print("\nEqual on {}: {}, in {:.0f} s\n", names_of(session), session.comparisons.text(), seconds);
  if (session.backends().size() == 1) fmt::print("Only one backend ran: no other cross-checked its results.\n");
  if (!session.devices().empty())
    for (const std::string& api : apis) fmt::print("{}\n", wrapped(api, "", "  "));
  fmt::print("{}Results: {}\n", load.text(session), folder.string());
  return kOk;
}

int equal_command(const EqualOptions& options) {
  const json left = read_results(options.left), right = read_results(options.right);
  const RecordComparison result = compare_records(left, right);
  for (const std::string& difference : result.differences) fmt::print("DIFFERENT: {}\n", difference);
  for (const auto& [file, only] : {std::pair{options.left, result.only_left}, {options.right, result.only_right}})
    if (!only.empty())
      fmt::print("only in {}: {}, such as {}\n", file, counted(only.size(), "configuration"), only.front());
  fmt::print("{} compared, {} {}\n", counted(result.compared, "configuration"), result.differences.size(),
             result.differences.size() == 1 ? "differs" : "differ");
  if (result.compared == 0)
    throw std::invalid_argument(
        "the two runs have no configuration in common: run both with the same scenes, --n, --steps and --seed");
  return result.differences.empty() ? kOk : kDifference;
}

}  // namespace spherepair
