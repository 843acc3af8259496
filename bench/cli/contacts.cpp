// SPDX-License-Identifier: MIT
// spherepair contacts
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "bench/cli/studies.h"
#include "bench/cli/study_run.h"
#include "bench/io/arguments.h"
#include "bench/options/options.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

constexpr const char* known_measurements[] = {"errors", "steps", "rates", "rest"};
constexpr const char* known_steps[] = {"10", "20", "40", "80", "160", "320"};

RestStage stage_of(const std::string& text) {
  const size_t colon = text.find(':');
  const auto drag = real_number_of(text.substr(0, colon), 0, 0.4);
  const auto steps = colon < text.size() ? whole_number_of(text.substr(colon + 1), 0, 1'000'000'000) : std::nullopt;
  if (!drag || !steps)
    throw std::invalid_argument(fmt::format(
        "'{}' is not a drag a step up to 0.4, a colon and a number of steps, such as 0.001:40000, for --drag-steps",
        text));
  return {*drag, *steps};
}

bool wanted(const ContactsOptions& options, const char* measurement) {
  return options.measurements.empty() || std::ranges::count(options.measurements, measurement);
}

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
    if (contact_from_name(law) == ContactLaw::none)
      throw std::invalid_argument("the law none has no contacts: leave it out of --laws");
  std::erase_if(plan.kinds, [&](const ContactKind& kind) { return !is_wanted(kind); });
  if (std::ranges::count(options.measurements, "rates") &&
      !std::ranges::count(plan.kinds, ContactLaw::spring, &ContactKind::law))
    throw std::invalid_argument(
        "rates are measured by the law spring, which is not among --laws: name it, or omit rates");
  const auto sizes = [&](std::vector<uint64_t> on_gpu, uint64_t elsewhere) {
    return !options.sizes.empty() ? options.sizes : hardware ? on_gpu : std::vector{elsewhere};
  };
  plan.n = sizes({4096}, 512).front();
  plan.step_sizes = sizes({1'000'000, 10'000'000}, 16384);
  plan.rest.sizes = sizes({1'000'000}, 1000);
  for (const std::string& one : options.measurements)
    require_known("measurement", one, {std::begin(known_measurements), std::end(known_measurements)});
  plan.rates.n = sizes({plan.rates.n}, 1000).front();
  const bool spring = std::ranges::count(plan.kinds, ContactLaw::spring, &ContactKind::law) > 0;
  if (options.sizes.size() > 1 && !wanted(options, "steps") && !wanted(options, "rest"))
    throw std::invalid_argument("--n takes one number for errors and rates: omit the others");
  if (wanted(options, "rates") && spring && plan.rates.n < 125)
    throw std::invalid_argument("rates need a gas of at least 125 spheres: give more as --n, or omit rates");
  if (!hardware) plan.rates.softer = 64, plan.rates.converged = 160;
  plan.rest.layers = options.rest_layers;
  if (!options.drag_steps.empty()) plan.rest.stages.clear();
  for (const std::string& stage : options.drag_steps) plan.rest.stages.push_back(stage_of(stage));
  plan.rates.converged = std::min(plan.rates.converged, 4 * std::ranges::max(plan.steps_a_contact));
  plan.sampling.rounds = options.rounds;
  plan.sampling.longest = 0.02;
  if (!hardware) plan.sampling.software_seconds = 0.01, plan.steps_averaged = 20;
  if (options.averaged) plan.steps_averaged = options.averaged;
  return plan;
}

struct MeasuredContacts {
  std::vector<ContactRun> runs;
  std::vector<GasSteps> steps;
  std::vector<ContactRate> rates;
  std::vector<SettledBed> beds;
  std::vector<std::string> left_out;
};

std::string tables_of(const ContactPlan& plan, const MeasuredContacts& measured, size_t width) {
  std::string text = runs_text(plan, measured.runs, width) + steps_text(measured.steps, width) +
                     rates_text(plan, measured.rates, width) + beds_text(plan.rest, measured.beds, width);
  for (const std::string& reason : measured.left_out) text += wrapped(reason, "* left out: ", "  ", width) + "\n";
  return text;
}

}  // namespace

int contacts_command(const CommandLine& line, const ContactsOptions& options) {
  make_contact_plan(options, false);  // throws for bad values before any work
  StudyRun run(line, "contacts", options.results, options.backends);
  Session& session = run.session();
  const ContactPlan plan = make_contact_plan(options, run.hardware());
  Progress progress;
  MeasuredContacts measured;
  if (wanted(options, "errors")) {
    measured.runs = measure_contact_errors(session, plan, progress);
    time_contact_runs(session, plan, measured.runs, progress);
  }
  if (wanted(options, "steps")) measured.steps = measure_gas_steps(session, plan, measured.left_out, progress);
  if (wanted(options, "rates")) measured.rates = measure_rates(session, plan, progress);
  if (wanted(options, "rest")) measured.beds = measure_rest(session, plan, measured.left_out, progress);
  progress.clear();
  json timed = {{"contact_runs", list_of(measured.runs)},
                {"gas_steps", list_of(measured.steps)},
                {"beds", list_of(measured.beds)}};
  run.record.update({{"format", "spherepair contacts 1"},
                     {"settings",
                      {{"n", plan.n},
                       {"seed", plan.seed},
                       {"packing_fraction", plan.packing_fraction},
                       {"collisions", plan.collisions},
                       {"converged_steps_a_contact", plan.converged},
                       {"steps_averaged", plan.steps_averaged},
                       {"rates", to_json(plan.rates)},
                       {"rest", to_json(plan.rest)}}},
                     {"contact_rates", list_of(measured.rates)},
                     {"left_out", measured.left_out}});
  run.record.update(timed);
  return run.finish([&](size_t width) { return tables_of(plan, measured, width); }, timed);
}

std::shared_ptr<ContactsOptions> add_contacts_options(CLI::App& command) {
  auto options = std::make_shared<ContactsOptions>();
  add_backends_option(command, options->backends);
  add_list(command, "--measure", options->measurements,
           "Only these: errors (of runs), steps (whole ones of a gas), rates (its pressure and cooling), rest (of a "
           "bed)");
  add_list(command, "--laws", options->laws, "Only these laws: spring, hertz, quartic");
  add_list(command, "--steps", options->steps,
           "Only these time steps, by the steps that a contact lasts: 10, 20, 40, 80, 160, 320");
  add_list(
      command, "--n", options->sizes,
      "Numbers of spheres; errors and rates take the first, beds whole layers (default on a GPU: errors 4096, steps "
      "1000000,10000000, rates 16384, rest 1000000)")
      ->transform(positive_range);
  command
      .add_option("--averaged", options->averaged,
                  "Whole steps whose mean is taken, the first of the gas (default 1000 on a GPU, else 20)")
      ->transform(whole_number(1, 1'000'000));
  add_number(command, "--rest-layers", options->rest_layers, whole_number(1, 10'000),
             "Layers of the beds, of spheres that are stiffer the more lie on them");
  add_list(command, "--drag-steps", options->drag_steps,
           "Stages in which they come to rest: DRAG:STEPS, the drag a step (default 0.001:40000,0.1:2000)");
  add_rounds_option(command, options->rounds, 6);
  add_results_option(command, options->results, "contacts.json, .txt and .csv");
  command.footer("Example:\n  spherepair contacts --laws spring --steps 10,20,40");
  return options;
}

}  // namespace spherepair
