// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "bench/check/gas.h"
#include "bench/studies/contact/contact_study.h"
#include "common/scene/contact_scene.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

constexpr uint equilibration_steps = 40;           // a contact
constexpr float restitutions[] = {1, 0.9f, 0.8f};  // elastic: the pressure

void choose_step(Scene& scene, uint steps_a_contact) {
  const float stiffness = scene.contact.stiffness, coarse = float(contact_time(scene) / coarsest);
  choose_contacts(
      scene, {.law = ContactLaw::spring, .stiffness = stiffness, .dt = coarse * coarsest / float(steps_a_contact)});
}

Gas equilibrated(Backend& backend, const ContactPlan& plan, uint64_t seed) {
  Scene scene = make_scene(
      {.name = "gas", .n = plan.rates.n, .seed = plan.seed + seed, .packing_fraction = plan.packing_fraction});
  choose_contacts(scene, {.law = ContactLaw::spring});
  scene.contact.stiffness /= plan.rates.softer;
  choose_step(scene, equilibration_steps);
  return equilibrated_gas(backend, scene, plan.rates.equilibration * double(scene.contact.high.x));
}

// The measured pressure or time of Haff's law.
struct Measured {
  double found, expected;
};
Measured measured(Backend& backend, const ContactPlan& plan, Gas gas, uint steps_a_contact) {
  const uint64_t samples = plan.rates.samples;
  const bool elastic = gas.scene.restitution == 1;
  const double kinetic = double(gas.scene.size()) * gas.mass / 2;  // of the gas at its start
  const double seconds = elastic ? plan.rates.pressure_seconds
                                 : plan.rates.cooling_times * expected_tau(gas, plan.packing_fraction, kinetic);
  choose_step(gas.scene, coarsest);
  const uint64_t steps = uint64_t(std::max(1.0, seconds / double(samples) / double(gas.scene.dt)));
  choose_step(gas.scene, steps_a_contact);
  if (elastic) {
    const Pressure pressure = measure_pressure(backend, gas, samples, steps * (steps_a_contact / coarsest));
    return {pressure.found, pressure.expected};
  }
  const Cooling cooling = measure_cooling(backend, gas, samples, steps * (steps_a_contact / coarsest));
  return {cooling.tau(), cooling.expected};
}

}  // namespace

// Equilibrates the gas of each seed once; every restitution and time step starts from that state.
std::vector<ContactRate> measure_rates(Session& session, const ContactPlan& plan, Progress& progress) {
  if (std::ranges::none_of(plan.kinds, [](const ContactKind& kind) { return kind.law == ContactLaw::spring; }))
    return {};
  Backend& backend = fastest(session);
  std::vector<uint> steps;
  std::ranges::copy_if(plan.steps_a_contact, std::back_inserter(steps),
                       [&](uint fine) { return fine < plan.rates.converged; });
  steps.push_back(plan.rates.converged);
  std::vector<ContactRate> rates;
  for (const float restitution : restitutions)
    for (const uint fine : steps)
      rates.push_back({restitution, fine, backend.info().name, plan.rates.n, 0, {}, {}, {}});
  for (uint64_t seed = 0; seed < plan.rates.seeds; ++seed) {
    progress.say(fmt::format("rates of a gas, {} of {}: it is equilibrated", seed + 1, plan.rates.seeds));
    Gas gas = equilibrated(backend, plan, seed);
    for (ContactRate& rate : rates) {
      progress.say(fmt::format("rates of a gas, {} of {}: restitution {}, {} steps a contact", seed + 1,
                               plan.rates.seeds, rate.restitution, rate.steps_a_contact));
      gas.scene.restitution = rate.restitution;
      choose_step(gas.scene, rate.steps_a_contact);
      rate.dt = double(gas.scene.dt);
      const auto [found, expected] = measured(backend, plan, gas, rate.steps_a_contact);
      rate.found.push_back(found), rate.over_theory.push_back(found / expected);
    }
  }
  for (ContactRate& rate : rates) {
    const ContactRate& converged = *std::ranges::find_if(rates, [&](const ContactRate& other) {
      return other.restitution == rate.restitution && other.steps_a_contact == plan.rates.converged;
    });
    if (&rate == &converged) continue;
    for (size_t k = 0; k < rate.found.size(); ++k) rate.errors.push_back(rate.found[k] / converged.found[k] - 1);
  }
  return rates;
}

namespace {

json interval_json(const std::vector<double>& values) {
  if (values.empty()) return nullptr;
  const Interval interval = median_interval(values);
  return {{"median", median(values)}, {"low", interval.low}, {"high", interval.high}, {"coverage", interval.coverage}};
}

std::string interval_text(const std::vector<double>& values, double unit, int digits) {
  if (values.empty()) return "";
  const Interval interval = median_interval(values);
  return fmt::format("{:.{}f} ({:.{}f} to {:.{}f})", median(values) / unit, digits, interval.low / unit, digits,
                     interval.high / unit, digits);
}

Table rate_table(const std::vector<ContactRate>& rates) {
  Table table{"Pressure of a gas, and its cooling time by restitution",
              {{"", "", "", true},
               {"steps a", "contact", ""},
               {"over what kinetic", "theory expects", "", true},
               {"error against", "the last", "%", true}},
              {},
              {}};
  for (const ContactRate& rate : rates)
    table.rows.push_back({rate.restitution == 1 ? "pressure" : fmt::format("cooling, {}", rate.restitution),
                          std::to_string(rate.steps_a_contact), interval_text(rate.over_theory, 1, 3),
                          interval_text(rate.errors, 0.01, 2)});
  return table;
}

}  // namespace

std::string rates_text(const ContactPlan& plan, const std::vector<ContactRate>& rates, size_t width) {
  if (rates.empty()) return "";
  const RatePlan& p = plan.rates;
  return fmt::format("\n{}\n", rate_table(rates).text(width)) +
         wrapped(fmt::format("{} in a box, by the law spring with a {}th of its own stiffness: median of {} seeds, and "
                             "the interval that holds it in {:.3g} % of all cases.",
                             counted(p.n, "sphere"), p.softer, p.seeds,
                             100 * median_interval(rates.front().over_theory).coverage),
                 "* ", "  ", width) +
         "\n";
}

json to_json(const RatePlan& plan) {
  return {{"n", plan.n},
          {"seeds", plan.seeds},
          {"converged_steps_a_contact", plan.converged},
          {"softer", plan.softer},
          {"equilibration", plan.equilibration},
          {"pressure_seconds", plan.pressure_seconds},
          {"cooling_times", plan.cooling_times},
          {"samples", plan.samples}};
}

json to_json(const ContactRate& rate) {
  return {{"quantity", rate.restitution == 1 ? "pressure" : "cooling time"},
          {"restitution", rate.restitution},
          {"steps_a_contact", rate.steps_a_contact},
          {"backend", rate.backend},
          {"n", rate.n},
          {"dt", rate.dt},
          {"found", interval_json(rate.found)},
          {"over_theory", interval_json(rate.over_theory)},
          {"error", interval_json(rate.errors)}};
}

}  // namespace spherepair
