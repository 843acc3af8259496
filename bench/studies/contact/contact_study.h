// SPDX-License-Identifier: MIT
// The measurements of `spherepair contacts`: error and run time by law and time step, whole steps, rates and beds.
//
// contacts.json, "format": "spherepair contacts 1":
//   context, backends, warnings, clocks   as in results.json (report.h, context.h)
//   settings   {n, seed, packing_fraction, collisions, converged_steps_a_contact, steps_averaged,
//               rates: {n, seeds, converged_steps_a_contact, softer, equilibration, pressure_seconds, cooling_times,
//               samples}}
//   contact_runs   one entry per law, restitution, time step and backend, of a gas without walls:
//     {law, restitution, sums: "integers", backend, n, steps_a_contact, dt, steps,
//      position   rms distance from the converged run's centres at the end, in radii
//      energy     change of the energy against the converged run's, over it
//      momentum   [x, y, z]: change of the sum of all momenta, in units of the state's integers
//      returns    elastic laws: whether as many steps back come to the first positions, bit for bit; null for others
//      seconds_per_step, low, high   median and its 95 % interval; run_seconds: of all steps
//      sample     as to_json(Samples)}
//   gas_steps  whole steps of the scene gas by the law spring, 40 steps a contact, the mean of so many from its start:
//     contacts, motion, walls and near pairs
//     {backend, n, steps, seconds_per_step, low, high, sphere_steps_per_second,
//      sample       of all these steps at once
//      over_cuda    time over CUDA's, of GPU APIs other than CUDA: ratio, low and high of its interval; else null}
//   contact_rates  of the scene gas by the law spring on one backend, whose bits are those of the others; one entry per
//     restitution and time step, the converged one included:
//     {quantity     "pressure", elastic; or "cooling time" of Haff's law, restitution 0.9 and 0.8
//      restitution, steps_a_contact, backend, n, dt,
//      found        p d^3 / (k T), or seconds
//      over_theory  that over what kinetic theory of hard spheres expects (Carnahan and Starling, Enskog)
//      error        of `found` relative to the converged time step from the same start; null for that step}
//     each {median, low, high, coverage} over the seeds: low and high hold the median with this probability
//   beds       beds at rest, and steps from there with sleeping spheres and without:
//     {n, dt, steps_averaged; layers, stages and the like are in the settings
//      unmoved      share of the spheres whose state a step leaves as it is, bit for bit
//      kinetic      kinetic energy over the total energy at the start
//      floor_force  over the weight
//      overlap      greatest, in radii
//      steps        [{backend, sleeping, seconds_per_step, low, high, sample
//                    awake_over_this   ratio, low and high of its interval; null for itself}]}
//   left_out   [text]: backends that do not time so many spheres
#pragma once

#include <array>
#include <optional>

#include "bench/check/step_result.h"
#include "bench/measure/session.h"
#include "bench/measure/statistics.h"
#include "bench/measure/timing.h"
#include "common/scene/contact/contact_options.h"

namespace spherepair {

constexpr uint coarsest = 10;  // steps a contact

struct ContactKind {
  ContactLaw law;
  float restitution = 1;
  bool operator==(const ContactKind&) const = default;
};
std::string label(const ContactKind& kind);  // spring, restitution 0.9

struct RatePlan {
  uint64_t n = 16384;
  uint64_t seeds = fewest_for_interval;
  uint converged = 640;         // steps a contact
  float softer = 16;            // the scene's own stiffness over this: contacts last four times as long
  double equilibration = 0.8;   // seconds a metre of the box, see equilibrated_gas
  double pressure_seconds = 1;  // of a measurement
  double cooling_times = 0.5;   // the same, in times of Haff's law
  uint64_t samples = 30;        // in each measurement
};

struct RestStage {
  double drag;  // of a step, as a share of the speed
  uint64_t steps;
};

struct RestPlan {
  std::vector<uint64_t> sizes;  // at least so many; rounded up to whole layers
  uint64_t layers = 10;
  float stiffness_a_layer = 3e5f;  // in proportion to the weight on the floor: beds of any height overlap as much
  float restitution = 0.3f;
  std::vector<RestStage> stages = {{0.001, 40'000}, {0.1, 2000}};
  uint64_t steps_averaged = 100;
  float stiffness() const { return stiffness_a_layer * float(layers); }
};

struct ContactPlan {
  std::vector<ContactKind> kinds = {
      {ContactLaw::spring}, {ContactLaw::spring, 0.9f}, {ContactLaw::hertz}, {ContactLaw::quartic}};
  std::vector<uint> steps_a_contact = {10, 20, 40, 80, 160};  // coarsest * 2^k
  uint converged = 640;                                       // steps a contact
  uint64_t n = 4096, seed = SceneOptions{}.seed;
  double packing_fraction = 0.3;
  double collisions = 2;              // mean times between collisions of a sphere: trajectories are not chaotic yet
  uint64_t most_on_host = 1'000'000;  // spheres when whole steps are timed; more spheres only on GPUs
  std::vector<uint64_t> step_sizes;   // sizes at which whole steps are timed
  uint64_t steps_averaged = 1000;     // whole steps whose mean is taken, from the start
  RatePlan rates;
  RestPlan rest;
  Sampling sampling;
};

struct ContactRun {
  ContactKind kind;
  uint steps_a_contact;
  std::string backend;
  uint64_t n, steps;
  double dt;
  double position, energy;
  std::array<int64_t, 3> momentum;
  std::optional<bool> returns;
  std::optional<Samples> samples = {};  // of a step
  double seconds() const { return samples ? double(steps) * samples->median_seconds() : 0; }
};

struct GasSteps {  // whole steps of a gas from its start: contacts, motion, walls, lists of near pairs
  std::string backend;
  uint64_t n, steps;
  Samples samples;                                                             // of all steps at once
  std::optional<Contest> over_cuda;                                            // for GPU APIs other than CUDA
  double seconds() const { return samples.median_seconds() / double(steps); }  // of a step, the mean
  double per_second() const { return double(n) / seconds(); }                  // sphere-steps
};

struct ContactRate {  // the pressure where the restitution is 1, else the time of Haff's law
  float restitution;
  uint steps_a_contact;
  std::string backend;
  uint64_t n;
  double dt;
  std::vector<double> found, over_theory, errors;  // by seed
};

struct RestSteps {  // from where spheres are at rest, the list of near pairs included
  std::string backend;
  bool sleeping;
  Samples samples;
  std::optional<Contest> awake;  // the step without sleeping over this one
};
struct SettledBed {
  uint64_t n, averaged;  // spheres, and steps of a sample
  double dt = 0, unmoved = 0, kinetic = 0, floor_force = 0, overlap = 0;
  std::vector<RestSteps> steps = {};
};

Backend& fastest(const Session& session);

// Spheres of a gas at its start, without the box, so that only contacts change momenta.
Scene contact_scene(const ContactPlan& plan, const ContactKind& kind, uint steps_a_contact);
// The steps of a run that lasts plan.collisions mean times between collisions, by kinetic theory.
uint64_t steps_of_run(const ContactPlan& plan, const ContactKind& kind, uint steps_a_contact);

// The backends that time this many spheres: the CPU and APIs in software leave out more than plan.most_on_host.
std::vector<Backend*> backends_for(const Session& session, const ContactPlan& plan, uint64_t n,
                                   std::vector<std::string>& left_out);

// Makes the steps up to `end` from each start on each of these backends. Throws DifferenceFound unless all end in the
// same bits.
using Starts = std::vector<std::function<void(Backend&)>>;
void compare_states(Session& session, const std::vector<Backend*>& backends, const Starts& starts,
                    const ComparisonPoint& end);

json ratio_of(const std::optional<Contest>& contest);
json time_of_a_step(const Samples& samples, uint64_t steps = 1);

// Makes each run on every backend. Throws DifferenceFound if two backends differ in any bit.
std::vector<ContactRun> measure_contact_errors(Session& session, const ContactPlan& plan, Progress& progress);
// Adds the times of the runs' steps.
void time_contact_runs(Session& session, const ContactPlan& plan, std::vector<ContactRun>& runs, Progress& progress);

// First compares the states, and throws DifferenceFound if two backends differ in any bit. The CPU and APIs in software
// leave out more than plan.most_on_host spheres.
std::vector<GasSteps> measure_gas_steps(Session& session, const ContactPlan& plan, std::vector<std::string>& left_out,
                                        Progress& progress);

// Measures rates at every time step of the plan and the converged one.
std::vector<ContactRate> measure_rates(Session& session, const ContactPlan& plan, Progress& progress);

// The fastest backend moves a bed through all stages. All backends continue from there, after a comparison.
std::vector<SettledBed> measure_rest(Session& session, const ContactPlan& plan, std::vector<std::string>& left_out,
                                     Progress& progress);

json to_json(const ContactRun& run);
json to_json(const GasSteps& steps);
json to_json(const RatePlan& plan);
json to_json(const RestPlan& plan);
json to_json(const SettledBed& bed);
json to_json(const ContactRate& rate);
// The tables, at most this wide; empty without measurements.
std::string runs_text(const ContactPlan& plan, const std::vector<ContactRun>& runs, size_t width);
std::string beds_text(const RestPlan& plan, const std::vector<SettledBed>& beds, size_t width);
std::string steps_text(const std::vector<GasSteps>& steps, size_t width);
std::string rates_text(const ContactPlan& plan, const std::vector<ContactRate>& rates, size_t width);

}  // namespace spherepair
