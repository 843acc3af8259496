// SPDX-License-Identifier: MIT
// The tables of `spherepair contacts` on errors and whole steps.
#include <fmt/format.h>

#include <algorithm>

#include "bench/io/report.h"
#include "bench/studies/contact/contact_study.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

std::vector<std::string> backends_of(const std::vector<ContactRun>& runs) {
  std::vector<std::string> names;
  for (const ContactRun& run : runs)
    if (!std::ranges::count(names, run.backend)) names.push_back(run.backend);
  return names;
}

double largest(const std::array<int64_t, 3>& momentum) {
  return std::max({std::abs(double(momentum[0])), std::abs(double(momentum[1])), std::abs(double(momentum[2]))});
}

// The table of one law: a row per time step, the largest error of all backends, and each backend's time.
Table run_table(const std::vector<ContactRun>& runs, const ContactKind& kind) {
  Table table{fmt::format("Contacts by {}: error of a run, and its time", label(kind)),
              {{"steps a", "contact", ""},
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
      return run.kind == kind && run.steps_a_contact == first.steps_a_contact;
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
      times[size_t(std::ranges::find(backends, run.backend) - backends.begin())] =
          run.samples ? time_cell(*run.samples, in_ms * double(run.steps)) : "-";
    }
    table.rows.push_back({std::to_string(first.steps_a_contact), fmt::format("{:.2e}", position),
                          fmt::format("{:.1e}", energy), fmt::format("{:.3g}", momentum),
                          !first.returns ? "-"
                          : returns      ? "yes"
                                         : "no"});
    table.rows.back().insert(table.rows.back().end(), times.begin(), times.end());
  }
  return table;
}

Table steps_table(const std::vector<GasSteps>& steps) {
  Table table{"Whole steps of the scene gas from its start",
              {{"", "spheres", ""},
               {"", "backend", "", true},
               {"", "steps", ""},
               {"time", "median", "ms"},
               {"", "rate", "sphere-steps/s"},
               {"", "over CUDA", "", true}},
              {},
              {}};
  for (const GasSteps& one : steps)
    table.rows.push_back({std::to_string(one.n), one.backend, std::to_string(one.steps),
                          time_cell(one.samples, in_ms / double(one.steps)), fmt::format("{:.3g}", one.per_second()),
                          one.over_cuda ? ratio_text(*one.over_cuda) : ""});
  return table;
}

Table rest_table(const std::vector<SettledBed>& beds) {
  Table table{"Steps of beds at rest",
              {{"", "spheres", ""},
               {"", "unmoved", "%"},
               {"", "backend", "", true},
               {"", "awake", "ms"},
               {"passed", "over", "ms"},
               {"awake over", "passed over", "", true}},
              {},
              {}};
  for (const SettledBed& bed : beds)
    for (const RestSteps& one : bed.steps) {
      if (!one.awake) continue;
      const double seconds = one.samples.median_seconds() / double(bed.averaged);
      table.rows.push_back({std::to_string(bed.n), fmt::format("{:.3f}", 100 * bed.unmoved), one.backend,
                            format_ms(one.awake->ratio * seconds), time_cell(one.samples, in_ms / double(bed.averaged)),
                            ratio_text(*one.awake)});
    }
  return table;
}

}  // namespace

std::string runs_text(const ContactPlan& plan, const std::vector<ContactRun>& runs, size_t width) {
  if (runs.empty()) return "";
  std::string text;
  for (const ContactKind& kind : plan.kinds) text += run_table(runs, kind).text(width) + "\n";
  return text +
         wrapped(fmt::format("{} of a gas without its box, for {} mean times between a sphere's collisions, against a "
                             "run of {} steps a contact. Returns: as many steps back come to the first bits.",
                             counted(plan.n, "sphere"), plan.collisions, plan.converged),
                 "* ", "  ", width) +
         "\n\n";
}

std::string beds_text(const RestPlan& plan, const std::vector<SettledBed>& beds, size_t width) {
  if (beds.empty()) return "";
  std::string text = fmt::format("\n{}", rest_table(beds).text(width));
  for (const SettledBed& bed : beds)
    text += wrapped(fmt::format("{} in {} layers: {:.1e} of the energy at the start is in motion, the floor carries "
                                "{:.9f} of the weight, the greatest overlap is {:.2f} % of a radius.",
                                counted(bed.n, "sphere"), plan.layers, bed.kinetic, bed.floor_force, 100 * bed.overlap),
                    "* ", "  ", width) +
            "\n";
  return text;
}

std::string steps_text(const std::vector<GasSteps>& steps, size_t width) {
  return steps.empty() ? "" : fmt::format("\n{}", steps_table(steps).text(width));
}

}  // namespace spherepair
