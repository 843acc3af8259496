// SPDX-License-Identifier: MIT
#include "bench/check/lockstep.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/io/scene_text.h"

namespace spherepair {
namespace {

bool chosen(const std::vector<Method>& methods, Method method) {
  return std::ranges::find(methods, method) != methods.end();
}

// Methods that arrange a device's threads; on the CPU all of them run the search of `parallel`.
bool is_all_pairs_of_devices(Method method) {
  return method == Method::collide_tiled || method == Method::collide_square || method == Method::collide_triangle;
}

constexpr uint64_t few_spheres = 100'000;

// A set, its reference and the other configurations that must find it.
struct SetCheck {
  Configuration reference;
  std::vector<Configuration> others;
  EqualityEntry entry;
  uint64_t last_pairs;  // at the last comparison: decides whether lists are compared
};

std::vector<SetCheck> group_by_set(Session& session, const LockstepPlan& plan, const std::vector<Configuration>& all) {
  std::vector<SetCheck> sets;
  for (const Configuration& configuration : all) {
    const std::string name = set_name(configuration.options);
    auto found = std::ranges::find_if(sets, [&](const SetCheck& set) { return set.entry.set == name; });
    if (found == sets.end()) {
      const Configuration reference = reference_for(session, configuration.options, plan.scene.n);
      // Before the first comparison we assume that few spheres have few pairs, so that the reference searches once.
      const uint64_t guess = plan.scene.n <= few_spheres ? 0 : UINT64_MAX;
      sets.push_back({reference, {}, {plan.scene, name, {label(reference)}, {}}, guess});
      found = sets.end() - 1;
    }
    if (label(configuration) == label(found->reference)) continue;
    found->others.push_back(configuration);
    found->entry.configurations.push_back(label(configuration));
  }
  return sets;
}

bool is_compared(const LockstepPlan& plan, uint64_t step) { return step % plan.every == 0 || step == plan.steps; }

// Plans comparisons from the configurations and steps alone, independently of the comparing code.
void plan_comparisons(Session& session, const LockstepPlan& plan, const std::vector<Configuration>& all) {
  const uint64_t steps = plan.steps / plan.every + 1 + (plan.steps % plan.every != 0);
  uint64_t planned = 0;
  for (const auto& backend : session.backends()) {
    const auto is_compared = [&](const Configuration& configuration) {
      return configuration.backend == backend.get() &&
             label(configuration) != label(reference_for(session, configuration.options, plan.scene.n));
    };
    const uint64_t configurations = uint64_t(std::ranges::count_if(all, is_compared));
    const bool other = backend.get() != &session.reference();
    if (other && configurations == 0)
      throw std::invalid_argument(fmt::format(
          "no result of {} would be compared: it has none of the chosen methods; choose another with --methods, or "
          "omit {} with --backends",
          backend->info().name, backend->info().name));
    session.comparisons.plan(backend->info().name, Comparisons::sets, configurations * steps);
    session.comparisons.plan(backend->info().name, Comparisons::states, other ? steps : 0);
    planned += configurations;
  }
  if (planned == 0)
    throw std::invalid_argument("nothing would be compared: the only method chosen is the reference itself");
}

void check_set(Session& session, const ComparisonPoint& point, SetCheck& set, uint64_t state, uint64_t largest_list) {
  StepResult expected = run_step(session, set.reference, set.last_pairs <= largest_list);
  if (!expected.pairs && expected.totals.pairs <= largest_list) expected = run_step(session, set.reference, true);
  const bool list = expected.pairs.has_value();
  for (const Configuration& configuration : set.others)
    require_equal(session, point, set.reference, expected, configuration, run_step(session, configuration, list));
  set.last_pairs = expected.totals.pairs;
  set.entry.checkpoints.push_back(
      {point.step, expected.totals.pairs, expected.totals.colliding_spheres, expected.totals.fingerprint, state});
}

}  // namespace

std::vector<Configuration> all_configurations(Session& session, const std::vector<Method>& methods,
                                              const std::vector<uint>& blocks) {
  std::vector<Configuration> all;
  for (const auto& backend : session.backends()) {
    const bool cpu = backend->info().on_host;
    std::vector<Method> known = backend->methods();
    known.push_back(Method::automatic);
    for (Method method : known) {
      if (!chosen(methods, method)) continue;
      if (cpu && is_all_pairs_of_devices(method)) continue;
      for (uint block : blocks) {
        all.push_back({backend.get(), {.method = method, .block = block}});
        if (!uses_blocks(all.back())) break;
      }
    }
  }
  return all;
}

std::vector<EqualityEntry> check_lockstep(Session& session, const LockstepPlan& plan, Progress& progress) {
  Scene scene = make_scene(plan.scene);
  choose_contacts(scene, plan.contact);
  for (const auto& backend : session.backends()) backend->upload(scene);
  const std::vector<Configuration> all = all_configurations(session, plan.methods, plan.blocks);
  plan_comparisons(session, plan, all);
  SceneOptions moved = plan.scene;  // as messages name it
  moved.motion = scene.motion;
  std::vector<SetCheck> sets = group_by_set(session, plan, all);
  for (uint64_t step = 0; step <= plan.steps; ++step) {
    if (step > 0)
      for (const auto& backend : session.backends()) backend->move();
    if (!is_compared(plan, step)) continue;
    progress.say(
        fmt::format("checking {} n = {}: step {} of {}", scene_label(plan.scene), plan.scene.n, step, plan.steps));
    const ComparisonPoint point{moved, step};
    const uint64_t state = require_same_states(session, point);
    for (SetCheck& set : sets) check_set(session, point, set, state, plan.largest_list);
    for (const auto& backend : session.backends()) backend->check_guards();
  }
  session.comparisons.require_complete();
  std::vector<EqualityEntry> entries;
  for (SetCheck& set : sets) {
    entries.push_back(std::move(set.entry));
    entries.back().contact = scene.contact;
    entries.back().dt = scene.dt, entries.back().restitution = scene.restitution;
  }
  return entries;
}

}  // namespace spherepair
