// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "bench/check/step_result.h"
#include "bench/studies/contact/contact_study.h"
#include "common/scene/contact_scene.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

constexpr uint64_t steps_compared = 100;  // before steps are timed

void move(Motion& motion) { motion.move(); }

Scene gas_scene(const ContactPlan& plan, uint64_t n) {
  Scene scene = make_scene({.name = "gas", .n = n, .seed = plan.seed, .packing_fraction = plan.packing_fraction});
  choose_contacts(scene, {.law = ContactLaw::spring});
  return scene;
}

}  // namespace

void compare_states(Session& session, const std::vector<Backend*>& backends, const Starts& starts,
                    const ComparisonPoint& end) {
  std::optional<Motion::State> expected;
  for (Backend* backend : backends)
    for (const auto& start : starts) {
      start(*backend);
      for (uint64_t step = 0; step < end.step; ++step) backend->move();
      Motion::State state = current_state(*backend);
      if (!expected) {
        expected = std::move(state);
        continue;
      }
      session.comparisons.plan(backend->info().name, Comparisons::states, 1);
      require_same_state(session, end, *backends.front(), *expected, *backend, state);
    }
  session.comparisons.require_complete();
}

std::vector<Backend*> backends_for(const Session& session, const ContactPlan& plan, uint64_t n,
                                   std::vector<std::string>& left_out) {
  std::vector<Backend*> backends;
  for (const auto& backend : session.backends()) {
    if (on_hardware(*backend) || n <= plan.most_on_host)
      backends.push_back(backend.get());
    else
      left_out.push_back(
          fmt::format("{}: steps of {}, which are timed on a GPU only", backend->info().name, counted(n, "sphere")));
  }
  return backends;
}

json ratio_of(const std::optional<Contest>& contest) {
  if (!contest) return nullptr;
  return {{"ratio", contest->ratio}, {"low", contest->ratios.low}, {"high", contest->ratios.high}};
}

json time_of_a_step(const Samples& samples, uint64_t steps) {
  const Interval interval = samples.interval();
  return {{"seconds_per_step", samples.median_seconds() / double(steps)},
          {"low", interval.low / double(steps)},
          {"high", interval.high / double(steps)},
          {"sample", to_json(samples)}};
}

void time_contact_runs(Session& session, const ContactPlan& plan, std::vector<ContactRun>& runs, Progress& progress) {
  for (const ContactKind& kind : plan.kinds)
    for (const uint fine : plan.steps_a_contact) {
      const Scene scene = contact_scene(plan, kind, fine);
      const std::string name = fmt::format("{}, {} steps a contact", label(kind), fine);
      progress.say("timing " + name);
      std::vector<Contender> contenders;
      std::vector<ContactRun*> timed;
      for (ContactRun& run : runs) {
        if (run.kind != kind || run.steps_a_contact != fine) continue;
        timed.push_back(&run);
        contenders.push_back({.label = name,
                              .backend = session.find(run.backend),
                              .step = move,
                              .contest = name,
                              .alternates = true,
                              .restart = [&scene](Backend& backend) { backend.upload(scene); },
                              .prepares = true});
      }
      std::vector<Samples> samples = measure(session, contenders, plan.sampling, progress);
      for (size_t k = 0; k < timed.size(); ++k) timed[k]->samples = std::move(samples[k]);
    }
}

// As the gas mixes, its steps take longer. We want their mean, which the slope of K/4, K/2 and K steps is not, so all
// steps are timed in one go. Stages are left out: a device timer would have those of a step ahead.
std::vector<GasSteps> measure_gas_steps(Session& session, const ContactPlan& plan, std::vector<std::string>& left_out,
                                        Progress& progress) {
  std::vector<GasSteps> all;
  for (const uint64_t n : plan.step_sizes) {
    const Scene scene = gas_scene(plan, n);
    const std::vector<Backend*> backends = backends_for(session, plan, n, left_out);
    progress.say(fmt::format("comparing {}", counted(n, "sphere")));
    const SceneOptions options{.name = "gas", .n = n};
    compare_states(session, backends, {[&](Backend& one) { one.upload(scene); }}, {options, steps_compared});
    const auto all_steps = [&](Backend& backend, uint64_t times) {
      for (uint64_t k = 0; k < times * plan.steps_averaged; ++k) backend.move();
    };
    std::vector<Contender> contenders;
    for (Backend* backend : backends)
      contenders.push_back({.label = fmt::format("{} steps of {} on {}", plan.steps_averaged, counted(n, "sphere"),
                                                 backend->info().name),
                            .backend = backend,
                            .step = move,
                            .contest = fmt::format("steps of {}", n),
                            .steps = all_steps,
                            .alternates = true,
                            .restart = [&scene](Backend& one) { one.upload(scene); },
                            .batch = 1,
                            .prepares = true});
    std::vector<Samples> samples = measure(session, contenders, plan.sampling, progress);
    for (Samples& one : samples) one.stages.clear(), one.stage_intervals.clear(), one.at_floor.clear();
    const auto cuda = std::ranges::find(samples, "cuda", &Samples::backend);
    for (const Samples& one : samples) {
      const bool other = cuda != samples.end() && &one != &*cuda && !session.find(one.backend)->info().on_host;
      all.push_back(
          {one.backend, n, plan.steps_averaged, one, other ? std::optional(contest(one, *cuda)) : std::nullopt});
    }
  }
  return all;
}

json to_json(const GasSteps& steps) {
  json out = time_of_a_step(steps.samples, steps.steps);
  out.update({{"backend", steps.backend},
              {"n", steps.n},
              {"steps", steps.steps},
              {"sphere_steps_per_second", steps.per_second()},
              {"over_cuda", ratio_of(steps.over_cuda)}});
  return out;
}

}  // namespace spherepair
