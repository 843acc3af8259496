// SPDX-License-Identifier: MIT
#include "bench/check/step_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

#include "bench/check/finite_state.h"
#include "bench/check/margin.h"
#include "bench/io/scene_text.h"

namespace spherepair {

std::string hex(const Fingerprint& fingerprint) { return hex64(fingerprint.a) + hex64(fingerprint.b); }

namespace {

std::string point_text(const ComparisonPoint& point) {
  return fmt::format("scene {}, n = {}, seed {}, step {} of {}", scene_label(point.scene), point.scene.n,
                     point.scene.seed, point.step, motion_label(point.scene.motion));
}

json point_json(const ComparisonPoint& point, const std::string& left, const std::string& right) {
  return {{"scene", scene_json(point.scene)}, {"step", point.step}, {"between", {left, right}}};
}

const char* decision_text(bool collide) { return collide ? "collide" : "apart"; }

[[noreturn]] void report_pair(const ComparisonPoint& point, const Configuration& reference,
                              const Configuration& configuration, const Difference& difference) {
  const Motion::State state = current_state(*reference.backend);
  const auto [i, j] = difference.pair;
  const Margin margin = margin_of(state.positions.at(i), state.positions.at(j));
  const std::string left = label(reference), right = label(configuration);
  json details = point_json(point, left, right);
  details["pair"] = {i, j};
  details["values"] = {decision_text(difference.in_left), decision_text(!difference.in_left)};
  details["exact"] = decision_text(margin.collide);
  details["margin"] = describe(margin);
  throw DifferenceFound(fmt::format("{}: {} and {} differ, first in pair ({}, {}): {} finds {}, {} finds {}; {}",
                                    point_text(point), left, right, i, j, left, decision_text(difference.in_left),
                                    right, decision_text(!difference.in_left), describe(margin)),
                        details);
}

[[noreturn]] void report_part(const ComparisonPoint& point, const std::string& left, const std::string& right,
                              const std::string& part, const std::string& of_left, const std::string& of_right) {
  json details = point_json(point, left, right);
  details["part"] = part;
  details["values"] = {of_left, of_right};
  throw DifferenceFound(
      fmt::format("{}: {} and {} differ in {}: {} against {}", point_text(point), left, right, part, of_left, of_right),
      details);
}

// Reports the first difference, most specific parts first.
void require_same_parts(const ComparisonPoint& point, const std::string& left, const StepResult& l,
                        const std::string& right, const StepResult& r) {
  const auto require = [&](const std::string& part, const auto& of_left, const auto& of_right) {
    if (of_left != of_right) report_part(point, left, right, part, fmt::to_string(of_left), fmt::to_string(of_right));
  };
  require("how many spheres have a count", l.counts.size(), r.counts.size());
  const auto [at, other] = std::ranges::mismatch(l.counts, r.counts);
  if (at != l.counts.end()) require(fmt::format("the count of sphere {}", at - l.counts.begin()), *at, *other);
  require("the number of pairs", l.totals.pairs, r.totals.pairs);
  require("the number of colliding spheres", l.totals.colliding_spheres, r.totals.colliding_spheres);
  require("the fingerprint", hex(l.totals.fingerprint), hex(r.totals.fingerprint));
}

// Totals, counts and list of a result must agree with each other.
void require_consistent(const ComparisonPoint& point, const Configuration& configuration, const StepResult& result) {
  uint64_t contacts = 0;
  for (const uint count : result.counts) contacts += count;
  StepResult derived = result;
  derived.totals.pairs = contacts / 2;
  derived.totals.colliding_spheres = uint64_t(std::ranges::count_if(result.counts, colliding));
  const std::string name = label(configuration);
  if (contacts % 2 != 0)
    report_part(point, name + " (counts)", name + " (pairs)", "the sum of all counts", fmt::to_string(contacts),
                "even");
  require_same_parts(point, name + " (totals)", result, name + " (counts)", derived);
  if (!result.pairs) return;
  derived.totals.pairs = result.pairs->size();
  derived.totals.fingerprint = fingerprint(*result.pairs);
  require_same_parts(point, name + " (totals)", result, name + " (list)", derived);
}

}  // namespace

bool uses_blocks(const Configuration& configuration) {
  if (configuration.options.method == Method::collide_tensor) return false;
  return !configuration.backend->info().on_host || configuration.options.method == Method::collide_group;
}

uint require_groups(const Configuration& configuration, uint block) {
  if (uses_blocks(configuration)) return block;
  throw std::invalid_argument(
      fmt::format("--block has no effect on the backend {}, whose loops have no groups: omit it, or name a backend of "
                  "the GPU with --backend",
                  configuration.backend->info().name));
}

std::string label(const Configuration& configuration) {
  const std::string text = configuration.backend->info().name + " " + method_name(configuration.options.method);
  const bool automatic_block =
      configuration.options.method == Method::automatic && configuration.options.block == CollideOptions{}.block;
  return uses_blocks(configuration) && !automatic_block ? fmt::format("{} {}", text, configuration.options.block)
                                                        : text;
}

std::string set_name(const CollideOptions& options) {
  return options.method == Method::collide_group ? fmt::format("within groups of {}", options.block) : "all pairs";
}

// Takes a double loop on one thread, the simplest reference; where that would take seconds, all cores, then the grid.
Configuration reference_for(Session& session, const CollideOptions& options, uint64_t n) {
  Configuration configuration{&session.reference(), {}};
  const bool cpu = configuration.backend->info().on_host;
  if (options.method == Method::collide_group) {
    configuration.options.method = options.method;
    configuration.options.block = options.block;
  } else if (cpu) {
    configuration.options.method = n <= 20000    ? Method::sequential
                                   : n <= 100000 ? Method::parallel
                                                 : Method::collide_grid;
  }
  return configuration;
}

bool same_result(const StepResult& left, const StepResult& right) {
  const Collisions &l = left.totals, &r = right.totals;
  return l.pairs == r.pairs && l.colliding_spheres == r.colliding_spheres && l.fingerprint == r.fingerprint &&
         left.counts == right.counts && (!left.pairs || !right.pairs || *left.pairs == *right.pairs);
}

StepResult result_of(Search& search, bool want_pairs) {
  StepResult result{search.collisions(), search.counts(), std::nullopt};
  if (want_pairs) result.pairs = search.pairs();
  return result;
}

StepResult run_step(Session& session, Configuration configuration, bool want_pairs) {
  configuration.options.want_pairs = want_pairs;
  session.collide(*configuration.backend, configuration.options);
  return result_of(*configuration.backend, want_pairs);
}

void require_equal(Session& session, const ComparisonPoint& point, const Configuration& reference,
                   const StepResult& expected, const Configuration& configuration, const StepResult& found) {
  require_consistent(point, reference, expected);
  if (!same_result(expected, found)) {
    // Large sets were compared without lists; list them now to name the pair.
    const std::vector<Pair> left = expected.pairs ? *expected.pairs : *run_step(session, reference, true).pairs;
    const std::vector<Pair> right = found.pairs ? *found.pairs : *run_step(session, configuration, true).pairs;
    if (const auto difference = first_difference(left, right))
      report_pair(point, reference, configuration, *difference);
    require_same_parts(point, label(reference), expected, label(configuration), found);
  }
  session.comparisons.made(configuration.backend->info().name, Comparisons::sets);
}

void require_same_state(Session& session, const ComparisonPoint& point, const Backend& reference,
                        const Motion::State& expected, const Backend& backend, const Motion::State& found) {
  const std::string left = reference.info().name, right = backend.info().name;
  const auto compare = [&](const std::vector<vec4>& l, const std::vector<vec4>& r, const char* what) {
    if (l.size() != r.size())
      report_part(point, left, right, fmt::format("how many spheres have a {}", what), fmt::to_string(l.size()),
                  fmt::to_string(r.size()));
    for (size_t i = 0; i < l.size(); ++i) {
      constexpr std::pair<const char*, float vec4::*> components[] = {
          {"x", &vec4::x}, {"y", &vec4::y}, {"z", &vec4::z}, {"w", &vec4::w}};
      for (const auto& [name, component] : components) {
        const float a = l[i].*component, b = r[i].*component;
        if (float_bits(a) == float_bits(b)) continue;
        report_part(point, left, right, fmt::format("state, first in {} {} of sphere {}", what, name, i),
                    fmt::format("0x{:08x} ({})", float_bits(a), a), fmt::format("0x{:08x} ({})", float_bits(b), b));
      }
    }
  };
  compare(expected.positions, found.positions, "position");
  compare(expected.velocities, found.velocities, "velocity");
  const auto [l, r] = std::ranges::mismatch(expected.wide, found.wide);
  const auto word = [](const std::vector<uint>& words, std::vector<uint>::const_iterator at) {
    return at == words.end() ? "no word" : fmt::format("0x{:08x}", *at);
  };
  if (l != expected.wide.end() || r != found.wide.end())
    report_part(point, left, right,
                fmt::format("the low bits of their state, first in word {}", l - expected.wide.begin()),
                word(expected.wide, l), word(found.wide, r));
  session.comparisons.made(right, Comparisons::states);
}

uint64_t require_same_states(Session& session, const ComparisonPoint& point) {
  const Motion::State expected = current_state(session.reference());
  require_finite(expected, point.step);
  for (const auto& backend : session.backends())
    if (backend.get() != &session.reference())
      require_same_state(session, point, session.reference(), expected, *backend, current_state(*backend));
  return state_hash(expected.positions, expected.velocities, expected.wide);
}

void compare_states(Session& session, const ComparisonPoint& point) {
  for (const auto& backend : session.backends() | std::views::drop(1))  // the first is the reference
    session.comparisons.plan(backend->info().name, Comparisons::states, 1);
  require_same_states(session, point);
  session.comparisons.require_complete();
}

}  // namespace spherepair
