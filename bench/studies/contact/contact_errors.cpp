// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/check/contact_statistics.h"
#include "bench/check/step_result.h"
#include "bench/studies/contact/contact_study.h"
#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

SceneOptions options_of(const ContactPlan& plan) {
  return {.name = "gas", .n = plan.n, .seed = plan.seed, .packing_fraction = plan.packing_fraction};
}

// Enskog's mean time between collisions, 1 / (4 d^2 n g sqrt(pi k T / m)), with velocities between -1 and 1 m/s along
// each axis.
double time_between_collisions(const ContactPlan& plan, double diameter) {
  const double f = plan.packing_fraction;
  const double at_contact = (1 - f / 2) / std::pow(1 - f, 3);  // the pair distribution of Carnahan and Starling
  const double spheres = 6 * f / (std::numbers::pi * std::pow(diameter, 3));
  return 1 / (4 * diameter * diameter * spheres * at_contact * std::sqrt(std::numbers::pi / 3));
}

struct End {
  Motion::State state;
  double energy;  // joules
};
End end_of(Backend& backend, const Scene& scene, uint64_t steps) {
  backend.upload(scene);
  for (uint64_t step = 0; step < steps; ++step) backend.move();
  backend.collide({.want_pairs = true});
  End end{current_state(backend), 0};
  end.energy = contact_statistics(scene, end.state.wide, backend.pairs(), steps).energy();
  return end;
}

int64_t word(const std::vector<uint>& wide, uint64_t k) { return load_real<int64_t>(wide, k); }

// The rms distance of two states in the same units, in radii.
double rms_distance(const Scene& scene, const std::vector<uint>& a, const std::vector<uint>& b) {
  const double metres = std::exp2(-scene.contact.unit_exponent);
  double sum = 0;
  for (uint64_t i = 0; i < scene.size(); ++i)
    for (uint64_t axis = 0; axis < 3; ++axis) {
      const uint64_t k = axis * scene.size() + i;
      const double distance = metres * double(word(a, k) - word(b, k)) / double(scene.positions[i].w);
      sum += distance * distance;
    }
  return std::sqrt(sum / double(std::max<uint64_t>(scene.size(), 1)));
}

// The change of the sum of all momenta. The sum itself may exceed 64 bits.
std::array<int64_t, 3> change_of_momentum(const Scene& scene, const std::vector<uint>& wide) {
  const std::vector<uint> start = fixed_state(scene);
  std::array<int64_t, 3> change{};
  for (uint64_t axis = 0; axis < 3; ++axis)
    for (uint64_t i = 0; i < scene.size(); ++i) {
      const uint64_t k = (3 + axis) * scene.size() + i;
      change[axis] += word(wide, k) - word(start, k);
    }
  return change;
}

// Whether as many steps back reach the first positions. The way back begins with the negated momenta of half a step
// later.
bool comes_back(Motion& motion, const Scene& scene, uint64_t steps) {
  const Motion::State far = current_state(motion);
  motion.move();
  const std::vector<uint> later = current_state(motion).wide;
  MotionState back;
  back.wide = far.wide;
  for (uint64_t k = 3 * scene.size(); k < 6 * scene.size(); ++k) store_real(back.wide, k, -word(later, k));
  Scene from = scene;
  from.positions = far.positions, from.velocities = far.velocities;
  motion.resume(from, back);
  for (uint64_t step = 0; step < steps; ++step) motion.move();
  const std::vector<uint> found = current_state(motion).wide, start = fixed_state(scene);
  return std::equal(found.begin(), found.begin() + 6 * int64_t(scene.size()), start.begin());
}

class Errors {
 public:
  Errors(Session& session, const ContactPlan& plan, Progress& progress)
      : session_(session), plan_(plan), progress_(progress) {}

  void run(const ContactKind& kind) {
    progress_.say(fmt::format("{}: the converged run", label(kind)));
    const Scene scene = contact_scene(plan_, kind, plan_.converged);
    const End converged = end_of(fastest(session_), scene, steps_of_run(plan_, kind, plan_.converged));
    for (const uint fine : plan_.steps_a_contact) run(kind, fine, converged);
  }

  std::vector<ContactRun> runs;

 private:
  void run(const ContactKind& kind, uint fine, const End& converged) {
    const Scene scene = contact_scene(plan_, kind, fine);
    const uint64_t steps = steps_of_run(plan_, kind, fine);
    progress_.say(fmt::format("{}: {} steps a contact", label(kind), fine));
    const size_t first = runs.size();
    for (const auto& backend : session_.backends()) {
      const End end = end_of(*backend, scene, steps);
      runs.push_back({kind, fine, backend->info().name, scene.size(), steps, double(scene.dt),
                      rms_distance(scene, end.state.wide, converged.state.wide),
                      (end.energy - converged.energy) / converged.energy, change_of_momentum(scene, end.state.wide),
                      std::nullopt});
    }
    const SceneOptions options = options_of(plan_);
    compare_states(session_, {options, steps});
    if (kind.restitution != 1) return;
    for (size_t k = 0; k < session_.backends().size(); ++k)
      runs[first + k].returns = comes_back(*session_.backends()[k], scene, steps);
  }

  Session& session_;
  const ContactPlan& plan_;
  Progress& progress_;
};

}  // namespace

Backend& fastest(const Session& session) {
  for (const std::string& name : gpu_backend_names())
    if (Backend* backend = session.find(name); backend && on_hardware(*backend)) return *backend;
  return session.reference();
}

std::string label(const ContactKind& kind) {
  return kind.restitution < 1 ? fmt::format("{}, restitution {}", contact_name(kind.law), kind.restitution)
                              : contact_name(kind.law);
}

// The plane lies one height of the box below the spheres, which do not reach it. Time steps are the coarsest one over
// powers of two.
Scene contact_scene(const ContactPlan& plan, const ContactKind& kind, uint steps_a_contact) {
  Scene scene = make_scene(options_of(plan));
  scene.restitution = kind.restitution;
  scene.contact.walls = false;
  scene.plane -= scene.contact.high.y - scene.plane;
  choose_contacts(scene, {.law = kind.law});
  const float coarse = float(contact_time(scene) / coarsest);
  choose_contacts(
      scene, {.law = kind.law, .stiffness = scene.contact.stiffness, .dt = coarse * coarsest / float(steps_a_contact)});
  return scene;
}

uint64_t steps_of_run(const ContactPlan& plan, const ContactKind& kind, uint steps_a_contact) {
  const Scene scene = contact_scene(plan, kind, coarsest);
  const double seconds = plan.collisions * time_between_collisions(plan, 2 * double(scene.positions.at(0).w));
  return uint64_t(std::ceil(seconds / double(scene.dt))) * (steps_a_contact / coarsest);
}

std::vector<ContactRun> measure_contact_errors(Session& session, const ContactPlan& plan, Progress& progress) {
  Errors errors(session, plan, progress);
  for (const ContactKind& kind : plan.kinds) errors.run(kind);
  return std::move(errors.runs);
}

json to_json(const ContactRun& run) {
  json out = {{"law", contact_name(run.kind.law)},
              {"restitution", run.kind.restitution},
              {"sums", "integers"},
              {"backend", run.backend},
              {"n", run.n},
              {"steps_a_contact", run.steps_a_contact},
              {"dt", run.dt},
              {"steps", run.steps},
              {"position", run.position},
              {"energy", run.energy},
              {"momentum", run.momentum},
              {"returns", run.returns ? json(*run.returns) : json()}};
  if (!run.samples) return out;
  const Interval interval = run.samples->interval();
  out.update({{"seconds_per_step", run.samples->median_seconds()},
              {"low", interval.low},
              {"high", interval.high},
              {"run_seconds", run.seconds()},
              {"sample", to_json(*run.samples)}});
  return out;
}

}  // namespace spherepair
