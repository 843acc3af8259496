// SPDX-License-Identifier: MIT
#include "answers.h"

#include <fmt/format.h>

#include <algorithm>

#include "margin.h"

namespace spherepair {
namespace {

std::string place_text(const Place& place) {
  return fmt::format("scene {}, n = {}, seed {}, step {} of {}", scene_label(place.scene), place.scene.n,
                     place.scene.seed, place.step, motion_label(place.scene.motion));
}

json place_json(const Place& place, const std::string& left, const std::string& right) {
  return {{"scene", scene_json(place.scene)}, {"step", place.step}, {"between", {left, right}}};
}

const char* answer_word(bool collide) { return collide ? "collide" : "apart"; }

[[noreturn]] void report_pair(const Place& place, const Asked& reference, const Asked& asked,
                              const Difference& difference) {
  const Backend::State state = reference.backend->state();
  const auto [i, j] = difference.pair;
  const Margin margin = margin_of(state.positions.at(i), state.positions.at(j));
  const std::string left = label(reference), right = label(asked);
  json details = place_json(place, left, right);
  details["pair"] = {i, j};
  details["answers"] = {answer_word(difference.in_left), answer_word(!difference.in_left)};
  details["exact"] = answer_word(margin.collide);
  details["margin"] = describe(margin);
  throw DifferenceFound(fmt::format("{}: {} and {} differ, first in pair ({}, {}): {} says {}, {} says {}; {}",
                                    place_text(place), left, right, i, j, left, answer_word(difference.in_left), right,
                                    answer_word(!difference.in_left), describe(margin)),
                        details);
}

[[noreturn]] void report_totals(const Place& place, const std::string& left, const Collisions& l,
                                const std::string& right, const Collisions& r, const std::string& what) {
  const auto say = [](const Collisions& c) {
    return fmt::format("{} pairs, {} colliding spheres, fingerprint {}{}", c.pairs, c.colliding_spheres,
                       hex64(c.fingerprint.a), hex64(c.fingerprint.b));
  };
  json details = place_json(place, left, right);
  details["totals"] = {say(l), say(r)};
  details["what"] = what;
  throw DifferenceFound(
      fmt::format("{}: {} and {} differ in {}: {} against {}", place_text(place), left, right, what, say(l), say(r)),
      details);
}

bool same_totals(const Collisions& l, const Collisions& r) {
  return l.pairs == r.pairs && l.colliding_spheres == r.colliding_spheres && l.fingerprint == r.fingerprint;
}

// An answer's own totals, counts and list must agree with each other.
void require_consistent(const Place& place, const Asked& asked, const Answer& answer) {
  const uint64_t contacts = [&] {
    uint64_t sum = 0;
    for (uint count : answer.counts) sum += count;
    return sum;
  }();
  Collisions told = answer.totals;
  told.pairs = contacts / 2;
  told.colliding_spheres = uint64_t(std::ranges::count_if(answer.counts, colliding));
  const std::string who = label(asked);
  if (contacts % 2 != 0 || !same_totals(told, answer.totals))
    report_totals(place, who + " (totals)", answer.totals, who + " (counts per sphere)", told, "totals and counts");
  if (!answer.pairs) return;
  told.pairs = answer.pairs->size();
  told.fingerprint = fingerprint(*answer.pairs);
  if (!same_totals(told, answer.totals))
    report_totals(place, who + " (totals)", answer.totals, who + " (list of pairs)", told, "totals and list");
}

}  // namespace

bool uses_blocks(const Asked& asked) {
  return asked.backend->info().name != "cpu" || asked.options.method == Method::collide_group;
}

std::string label(const Asked& asked) {
  const std::string text = asked.backend->info().name + " " + method_name(asked.options.method);
  const bool left_open = asked.options.method == Method::automatic && asked.options.block == CollideOptions{}.block;
  return uses_blocks(asked) && !left_open ? fmt::format("{} {}", text, asked.options.block) : text;
}

std::string set_name(const CollideOptions& options) {
  return options.method == Method::collide_group ? fmt::format("within groups of {}", options.block) : "all pairs";
}

// One thread and a double loop is the plainest reference; it gives way to all cores where it would take seconds, and
// they to the grid.
Asked reference_for(Session& session, const CollideOptions& options, uint64_t n) {
  Asked asked{&session.reference(), {}};
  const bool cpu = asked.backend->info().name == "cpu";
  if (options.method == Method::collide_group) {
    asked.options.method = options.method;
    asked.options.block = options.block;
  } else if (cpu) {
    asked.options.method = n <= 20000 ? Method::sequential : n <= 100000 ? Method::parallel : Method::collide_grid;
  }
  return asked;
}

bool same_answer(const Answer& left, const Answer& right) {
  return same_totals(left.totals, right.totals) && left.counts == right.counts &&
         (!left.pairs || !right.pairs || *left.pairs == *right.pairs);
}

Answer answer_of(Backend& backend, bool want_pairs) {
  Answer answer{backend.collisions(), backend.counts(), std::nullopt};
  if (want_pairs) answer.pairs = backend.pairs();
  return answer;
}

Answer ask(Session& session, Asked asked, bool want_pairs) {
  asked.options.want_pairs = want_pairs;
  session.collide(*asked.backend, asked.options);
  return answer_of(*asked.backend, want_pairs);
}

std::string scene_label(const SceneOptions& o) {
  std::string text = o.name;
  if (o.groups) text += fmt::format(" {}x{}", o.groups, o.group_size);
  if (o.radius_ratio != 1) text += fmt::format(" radii 1:{}", o.radius_ratio);
  if (o.offset != 0) text += fmt::format(" at {}", o.offset);
  return text;
}

json scene_json(const SceneOptions& o) {
  json scene = {{"name", o.name},
                {"n", o.n},
                {"seed", o.seed},
                {"radius", o.radius},
                {"radius_ratio", o.radius_ratio},
                {"packing_fraction", o.packing_fraction},
                {"groups", o.groups},
                {"group_size", o.group_size},
                {"offset", o.offset}};
  // Only what differs, so that records from before there was a choice compare with those made since.
  const SceneOptions plain;
  if (o.motion != plain.motion) scene["motion"] = motion_label(o.motion);
  if (o.dt != plain.dt) scene["dt"] = o.dt;
  if (o.restitution != plain.restitution) scene["restitution"] = o.restitution;
  return scene;
}

void require_equal(Session& session, const Place& place, const Asked& reference, const Answer& expected,
                   const Asked& asked, const Answer& found) {
  require_consistent(place, asked, found);
  if (same_answer(expected, found)) return;
  // Sets too large to be kept are listed now, once, to name the pair.
  const std::vector<Pair> left = expected.pairs ? *expected.pairs : *ask(session, reference, true).pairs;
  const std::vector<Pair> right = found.pairs ? *found.pairs : *ask(session, asked, true).pairs;
  if (const auto difference = first_difference(left, right)) report_pair(place, reference, asked, *difference);
  const auto at = std::ranges::mismatch(expected.counts, found.counts).in1 - expected.counts.begin();
  report_totals(place, label(reference), expected.totals, label(asked), found.totals,
                size_t(at) < expected.counts.size() ? fmt::format("the count of sphere {}", at) : "totals");
}

void require_same_state(const Place& place, const Backend& reference, const Backend::State& expected,
                        const Backend& backend, const Backend::State& found) {
  constexpr const char* names[] = {"x", "y", "z", "w"};
  const auto compare = [&](const std::vector<vec4>& left, const std::vector<vec4>& right, const char* what) {
    for (size_t i = 0; i < left.size(); ++i) {
      const float l[] = {left[i].x, left[i].y, left[i].z, left[i].w};
      const float r[] = {right[i].x, right[i].y, right[i].z, right[i].w};
      for (int k = 0; k < 4; ++k) {
        if (float_bits(l[k]) == float_bits(r[k])) continue;
        json details = place_json(place, reference.info().name, backend.info().name);
        details["sphere"] = i;
        details["component"] = fmt::format("{} {}", what, names[k]);
        details["bits"] = {fmt::format("{:08x}", float_bits(l[k])), fmt::format("{:08x}", float_bits(r[k]))};
        throw DifferenceFound(
            fmt::format("{}: {} and {} differ in state, first in {} {} of sphere {}: 0x{:08x} ({}) against "
                        "0x{:08x} ({})",
                        place_text(place), reference.info().name, backend.info().name, what, names[k], i,
                        float_bits(l[k]), l[k], float_bits(r[k]), r[k]),
            details);
      }
    }
  };
  compare(expected.positions, found.positions, "position");
  compare(expected.velocities, found.velocities, "velocity");
  const auto [left, right] = std::ranges::mismatch(expected.wide, found.wide);
  if (left == expected.wide.end() && right == found.wide.end()) return;
  json details = place_json(place, reference.info().name, backend.info().name);
  details["wide word"] = left - expected.wide.begin();
  throw DifferenceFound(
      fmt::format("{}: {} and {} differ in the low bits of their state, first in word {}", place_text(place),
                  reference.info().name, backend.info().name, left - expected.wide.begin()),
      details);
}

}  // namespace spherepair
