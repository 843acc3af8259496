// SPDX-License-Identifier: MIT
// spherepair contacts
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "bench/cli/studies.h"
#include "bench/formats/files.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/options/options.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

constexpr const char* known_steps[] = {"10", "20", "40", "80", "160", "320"};

ContactPlan make_contact_plan(const ContactsOptions& options, bool hardware) {
  ContactPlan plan;
  if (!hardware) plan.steps_a_contact = {10, 20, 40};
  if (!options.steps.empty()) plan.steps_a_contact.clear();
  for (const std::string& steps : options.steps) {
    require_known("number of steps a contact", steps, {std::begin(known_steps), std::end(known_steps)});
    plan.steps_a_contact.push_back(uint(std::stoul(steps)));
  }
  const auto is_wanted = [&](const ContactKind& kind) {
    return options.laws.empty() || std::ranges::count(options.laws, contact_name(kind.law));
  };
  for (const std::string& law : options.laws)
    if (contact_from_name(law) == ContactLaw::none) throw std::invalid_argument("the law none has no contacts");
  std::erase_if(plan.kinds, [&](const ContactKind& kind) { return !is_wanted(kind); });
  plan.n = options.n ? options.n : hardware ? 4096 : 512;
  plan.cost_sizes = options.cost_sizes;
  if (plan.cost_sizes.empty())
    plan.cost_sizes = hardware ? std::vector<uint64_t>{16384, 1'000'000, 10'000'000} : std::vector<uint64_t>{16384};
  if (!hardware) plan.rates.n = 1000, plan.rates.softer = 64, plan.rates.converged = 160;
  if (options.rate_n) plan.rates.n = options.rate_n;
  plan.rates.converged = std::min(plan.rates.converged, 4 * std::ranges::max(plan.steps_a_contact));
  plan.sampling.rounds = options.rounds;
  plan.sampling.longest = 0.02;
  if (!hardware) plan.sampling.software_seconds = 0.01;
  return plan;
}

struct Measured {
  std::vector<ContactRun> runs;
  std::vector<SumsCost> costs;
  std::vector<ContactRate> rates;
  std::vector<Target> targets;
  std::vector<std::string> left_out;
};

std::vector<std::string> backends_of(const std::vector<ContactRun>& runs) {
  std::vector<std::string> names;
  for (const ContactRun& run : runs)
    if (!std::ranges::count(names, run.backend)) names.push_back(run.backend);
  return names;
}

double largest(const std::array<int64_t, 3>& momentum) {
  return std::max({std::abs(double(momentum[0])), std::abs(double(momentum[1])), std::abs(double(momentum[2]))});
}

// Of one law: a row per time step and sum; errors are the largest of the backends, times of each.
Table run_table(const std::vector<ContactRun>& runs, const ContactKind& kind) {
  Table table{fmt::format("Contacts by {}: error of a run, and its time", label(kind)),
              {{"steps a", "contact", ""},
               {"", "sums", "", true},
               {"error of", "position", "radii"},
               {"error of", "energy", ""},
               {"change of", "momentum", "units"},
               {"", "returns", "", true}},
              {},
              {}};
  const std::vector<std::string> backends = backends_of(runs);
  for (const std::string& backend : backends) table.columns.push_back({"time", backend, "ms"});
  for (const ContactRun& first : runs) {
    const auto belongs = [&](const ContactRun& run) {
      return run.kind == kind && run.steps_a_contact == first.steps_a_contact && run.sums == first.sums;
    };
    if (!belongs(first) || &first != &*std::ranges::find_if(runs, belongs)) continue;
    double position = 0, energy = 0, momentum = 0;
    bool returns = true;
    std::vector<std::string> times(backends.size(), "-");
    for (const ContactRun& run : runs) {
      if (!belongs(run)) continue;
      position = std::max(position, run.position), energy = std::max(energy, std::abs(run.energy));
      momentum = std::max(momentum, largest(run.momentum));
      returns = returns && run.returns.value_or(false);
      times[size_t(std::ranges::find(backends, run.backend) - backends.begin())] = format_ms(run.seconds());
    }
    table.rows.push_back({std::to_string(first.steps_a_contact), impulse_sums_name(first.sums),
                          fmt::format("{:.2e}", position), fmt::format("{:.1e}", energy),
                          fmt::format("{:.3g}", momentum),
                          !first.returns ? "-"
                          : returns      ? "yes"
                                         : "no"});
    table.rows.back().insert(table.rows.back().end(), times.begin(), times.end());
  }
  return table;
}

Table cost_table(const std::vector<SumsCost>& costs) {
  Table table{"Time of a step of the scene gas, by how impulses are summed",
              {{"", "spheres", ""},
               {"", "backend", "", true},
               {"", "sums", "", true},
               {"", "time", "ms"},
               {"", "integers over this", "", true}},
              {},
              {}};
  for (const SumsCost& cost : costs)
    table.rows.push_back({std::to_string(cost.n), cost.backend, impulse_sums_name(cost.sums),
                          format_ms(cost.samples.median_seconds()), cost.integers ? ratio_text(*cost.integers) : ""});
  return table;
}

std::string tables_of(const ContactPlan& plan, const Measured& measured) {
  std::string text;
  for (const ContactKind& kind : plan.kinds) text += run_table(measured.runs, kind).text() + "\n";
  text += wrapped(fmt::format("{} of a gas without its box, for {} mean times between a sphere's collisions, against a "
                              "run of {} steps a contact. Returns: as many steps back come to the first bits. Bits of "
                              "two backends differ only where sums are by atomics.",
                              counted(plan.n, "sphere"), plan.collisions, plan.converged),
                  "* ", "  ") +
          "\n\n" + cost_table(measured.costs).text() + rates_text(plan, measured.rates);
  if (!measured.targets.empty()) text += "\n" + target_table(measured.targets).text();
  for (const std::string& reason : measured.left_out) text += wrapped(reason, "* left out: ", "  ") + "\n";
  return text;
}

json start_record(const CommandLine& line, const Session& session, const ContactPlan& plan) {
  return {{"format", "spherepair contacts 1"},
          {"context", capture_context(line.words)},
          {"backends", session.to_json()},
          {"warnings", session.warnings()},
          {"settings",
           {{"n", plan.n},
            {"seed", plan.seed},
            {"packing_fraction", plan.packing_fraction},
            {"collisions", plan.collisions},
            {"converged_steps_a_contact", plan.converged},
            {"cost_steps", plan.cost_steps},
            {"rates", to_json(plan.rates)}}},
          {"clocks", json::array({query_clocks()})}};
}

void report(const std::filesystem::path& folder, json record, const ContactPlan& plan, const Measured& measured) {
  record["contact_runs"] = list_of(measured.runs);
  record["contact_sums"] = list_of(measured.costs);
  record["contact_rates"] = list_of(measured.rates);
  record["targets"] = list_of(measured.targets);
  record["left_out"] = measured.left_out;
  record["clocks"].push_back(query_clocks());
  const std::string text = tables_of(plan, measured);
  fmt::print("{}", text);
  write_file(folder / "contacts.txt", text);
  write_file(folder / "contacts.json", json_text(record));
}

}  // namespace

int contacts_command(const CommandLine& line, const ContactsOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  make_contact_plan(options, false);  // throws for bad values before any work
  const std::filesystem::path folder = prepare_results(options.results, {"contacts.txt", "contacts.json"});
  Session session(options.backends, line.open, line.opener);
  const bool hardware = std::ranges::any_of(session.backends(), [](const auto& b) { return on_hardware(*b); });
  const ContactPlan plan = make_contact_plan(options, hardware);
  fmt::print("spherepair {} ({})\n{}\n", build_info.version, build_info.commit, session.summary());
  for (const std::string& warning : session.warnings()) fmt::print("{}\n", wrapped(warning, "* ", "  "));
  const json record = start_record(line, session, plan);
  Progress progress;
  Measured measured;
  measured.runs = measure_contact_errors(session, plan, measured.left_out, progress);
  time_contact_runs(session, plan, measured.runs, progress);
  measured.costs = measure_sums(session, plan, measured.left_out, progress);
  measured.targets = sums_targets(session, measured.costs);
  measured.rates = measure_rates(session, plan, progress);
  progress.clear();
  report(folder, record, plan, measured);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  fmt::print("\nIn {:.0f} s. Results: {}\n", taken.count(), (folder / "contacts.json").string());
  return kOk;
}

std::shared_ptr<ContactsOptions> add_contacts_options(CLI::App& command) {
  auto options = std::make_shared<ContactsOptions>();
  add_backends_option(command, options->backends);
  command.add_option("--laws", options->laws, "Only these laws: spring, hertz, quartic")->delimiter(',');
  command
      .add_option("--steps", options->steps,
                  "Only these time steps, by the steps that a contact lasts: 10, 20, 40, 80, 160, 320")
      ->delimiter(',');
  command.add_option("--n", options->n, "Spheres of the runs for errors (default 4096 on a GPU, else 512)")
      ->transform(positive_range);
  command
      .add_option("--cost-n", options->cost_sizes,
                  "Spheres of the steps whose sums are compared (default 16384,1000000,10000000 on a GPU, else 16384)")
      ->delimiter(',')
      ->transform(positive_range);
  command
      .add_option("--rate-n", options->rate_n,
                  "Spheres of the gas whose pressure and cooling are measured (default 16384 on a GPU, else 1000)")
      ->transform(whole_number(125, kMostSpheres));
  command.add_option("--rounds", options->rounds, "Rounds of each timing")
      ->transform(whole_number(6, 1000))
      ->capture_default_str();
  add_results_option(command, options->results, "contacts.json and contacts.txt");
  command.footer("Example:\n  spherepair contacts --laws spring --steps 10,20,40");
  return options;
}

}  // namespace spherepair
