// SPDX-License-Identifier: MIT
// Beds at rest: brings them to rest, and times a step with sleeping spheres and without.
#include <fmt/format.h>

#include <algorithm>

#include "bench/check/contact_statistics.h"
#include "bench/check/step_result.h"
#include "bench/studies/contact/contact_study.h"
#include "common/scene/contact_scene.h"
#include "common/scene/contact_scenes.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

constexpr uint64_t steps_between_reports = 1000;
constexpr uint64_t rest_steps_compared = 50;  // from the bed at rest

// The number of spheres in whole layers. A layer with holes would push the walls apart unevenly, which takes long to
// damp.
uint64_t spheres_of_layers(uint64_t fewest, uint64_t layers) {
  uint64_t side = 1, n = 0;
  for (; n < fewest; ++side) n = (layers + 1) / 2 * side * side + layers / 2 * (side - 1) * (side - 1);
  return n;
}

void go_on(Motion& motion, Scene& scene, const MotionState& from, double drag, bool sleeping = true) {
  scene.contact.drag = float(drag / double(scene.dt));
  scene.contact.sleeping = sleeping;
  motion.resume(scene, from);
}

MotionState take_state(Motion& motion, Scene& scene) {
  Motion::State now = current_state(motion);
  scene.positions = std::move(now.positions), scene.velocities = std::move(now.velocities);
  return motion.save();
}

double unmoved_share(Motion& motion, const MotionState& before, uint64_t n) {
  motion.move();
  const std::vector<uint> after = current_state(motion).wide;
  std::vector<uint> moved(n, 0);
  for (uint64_t k = 0; k < before.wide.size(); ++k)
    if (before.wide[k] != after[k]) moved[k / 2 % n] = 1;
  return double(std::ranges::count(moved, 0u)) / double(n);
}

ContactStatistics statistics_of(Search& search, const Scene& scene, const std::vector<uint>& wide) {
  search.collide({.want_pairs = true});
  return contact_statistics(scene, wide, search.pairs(), 0);
}

double weight_of(const Scene& scene) {
  double weight = 0;
  for (const vec4& sphere : scene.positions) weight -= sphere_mass(double(sphere.w)) * double(scene.gravity);
  return weight;
}

struct RestStart {
  Scene scene;
  MotionState state;
};

RestStart come_to_rest(Backend& backend, const RestPlan& plan, SettledBed& bed, Progress& progress) {
  Scene scene = packed_bed(bed.n, plan.layers);
  scene.restitution = plan.restitution;
  choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = plan.stiffness(), .drag = 1});
  backend.upload(scene);
  MotionState state = backend.save();
  const double energy = statistics_of(backend, scene, state.wide).energy();
  for (const RestStage& stage : plan.stages) {
    go_on(backend, scene, state, stage.drag);
    for (uint64_t step = 0; step < stage.steps; ++step) {
      if (step % steps_between_reports == 0) {
        backend.evaluate_state();
        progress.say(fmt::format("{}: step {} of {} with a drag of {} a step", counted(bed.n, "sphere"), step,
                                 stage.steps, stage.drag));
      }
      backend.move();
    }
    state = take_state(backend, scene);
  }
  const ContactStatistics end = statistics_of(backend, scene, state.wide);
  bed.dt = double(scene.dt);
  bed.kinetic = end.kinetic / energy;
  bed.floor_force = end.floor_force / weight_of(scene);
  bed.overlap = end.greatest_overlap / double(scene.positions[0].w);
  bed.unmoved = unmoved_share(backend, state, bed.n);
  return {std::move(scene), std::move(state)};
}

// Checks that all backends give the same bits, with sleeping spheres and without.
void compare_at_rest(Session& session, const std::vector<Backend*>& backends, RestStart& start, double drag) {
  const SceneOptions options{.name = "bed", .n = start.scene.size()};
  const auto begin = [&](bool sleeping) {
    return [&, sleeping](Backend& one) { go_on(one, start.scene, start.state, drag, sleeping); };
  };
  compare_states(session, backends, {begin(false), begin(true)}, {options, rest_steps_compared});
}

std::vector<RestSteps> time_steps(Session& session, const ContactPlan& plan, const std::vector<Backend*>& backends,
                                  RestStart& start, double drag, Progress& progress) {
  const auto step = [](Motion& motion) { motion.move(); };
  const auto all_steps = [&](Backend& backend, uint64_t times) {
    for (uint64_t k = 0; k < times * plan.rest.steps_averaged; ++k) backend.move();
  };
  std::vector<Contender> contenders;
  for (Backend* backend : backends)
    for (const bool sleeping : {true, false}) {
      const auto restart = [&start, drag, sleeping](Backend& one) {
        go_on(one, start.scene, start.state, drag, sleeping);
      };
      contenders.push_back({.label = fmt::format("{} at rest, {}", counted(start.scene.size(), "sphere"),
                                                 sleeping ? "passed over" : "awake"),
                            .backend = backend,
                            .step = step,
                            .contest = fmt::format("{} at rest on {}", start.scene.size(), backend->info().name),
                            .steps = all_steps,
                            .alternates = true,
                            .restart = restart,
                            .batch = 1,
                            .prepares = true});
    }
  std::vector<Samples> samples = measure(session, contenders, plan.sampling, progress);
  std::vector<RestSteps> steps;
  for (size_t k = 0; k < samples.size(); ++k) {
    samples[k].stages.clear(), samples[k].stage_intervals.clear(), samples[k].at_floor.clear();
    const bool sleeping = k % 2 == 0;
    steps.push_back({samples[k].backend, sleeping, samples[k],
                     sleeping ? std::optional(contest(samples[k + 1], samples[k])) : std::nullopt});
  }
  return steps;
}

}  // namespace

std::vector<SettledBed> measure_rest(Session& session, const ContactPlan& plan, std::vector<std::string>& left_out,
                                     Progress& progress) {
  std::vector<SettledBed> beds;
  for (const uint64_t fewest : plan.rest.sizes) {
    const uint64_t n = spheres_of_layers(fewest, plan.rest.layers);
    const std::vector<Backend*> backends = backends_for(session, plan, n, left_out);
    if (backends.empty()) continue;
    SettledBed bed{.n = n, .averaged = plan.rest.steps_averaged};
    RestStart start = come_to_rest(fastest(session), plan.rest, bed, progress);
    const double drag = plan.rest.stages.back().drag;
    progress.say(fmt::format("comparing {} at rest", counted(n, "sphere")));
    compare_at_rest(session, backends, start, drag);
    bed.steps = time_steps(session, plan, backends, start, drag, progress);
    beds.push_back(std::move(bed));
  }
  return beds;
}

json to_json(const RestPlan& plan) {
  json stages = json::array();
  for (const RestStage& stage : plan.stages) stages.push_back({{"drag_a_step", stage.drag}, {"steps", stage.steps}});
  return {{"layers", plan.layers},
          {"stiffness", plan.stiffness()},
          {"restitution", plan.restitution},
          {"stages", stages},
          {"steps_averaged", plan.steps_averaged}};
}

json to_json(const SettledBed& bed) {
  json steps = json::array();
  for (const RestSteps& one : bed.steps) {
    json timed = time_of_a_step(one.samples, bed.averaged);
    timed.update({{"backend", one.backend}, {"sleeping", one.sleeping}, {"awake_over_this", ratio_of(one.awake)}});
    steps.push_back(std::move(timed));
  }
  return {{"n", bed.n},
          {"steps_averaged", bed.averaged},
          {"dt", bed.dt},
          {"unmoved", bed.unmoved},
          {"kinetic", bed.kinetic},
          {"floor_force", bed.floor_force},
          {"overlap", bed.overlap},
          {"steps", steps}};
}

}  // namespace spherepair
