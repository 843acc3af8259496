// SPDX-License-Identifier: MIT
#include "bench/studies/ablation_study.h"

#include <fmt/format.h>

#include <algorithm>

#include "api/open.h"
#include "bench/io/scene_text.h"
#include "bench/measure/floors.h"
#include "bench/studies/ablation_work.h"
#include "bench/studies/study_sampling.h"

namespace spherepair {
namespace {

constexpr uint64_t brute_force_up_to = 100000;           // spheres; with more, the CPU's grid is the reference
constexpr uint64_t drifting_steps = 64;                  // in these each sphere crosses the scene
constexpr int moves_checked = 40, pushes_checked = 200;  // enough for several lists of near pairs

bool only_moves(AblationWork work) { return work != AblationWork::collide && work != AblationWork::copy; }

}  // namespace

AblationStudy::AblationStudy(Session& session, const OpenOptions& open, const AblateOptions& options,
                             std::function<void()> write)
    : session_(session), open_(open), options_(options), write_(std::move(write)) {
  sampling_ = study_sampling(options.rounds);
  sampling_.software_seconds = 0.01;
  sampling_.longest = 0.05;
  scene_options_.name = "uniform";
  scene_options_.packing_fraction = options.packing_fraction;
}

void AblationStudy::run(const std::vector<uint64_t>& sizes) {
  const std::vector<Case> all = cases();
  uint64_t done = 0;
  for (const uint64_t n : sizes) {
    scene_options_.n = n;
    scenes_.clear(), expected_.clear(), holding_.clear();
    for (const Case& which : all) {
      progress_.reach(done++, all.size() * sizes.size());
      run(which);
      write_();
    }
  }
}

// All cases, sorted by backend, then by spheres, so that each scene is uploaded once.
std::vector<AblationStudy::Case> AblationStudy::cases() {
  std::vector<Case> all;
  for (const auto& backend : session_.backends()) {
    std::vector<Case> of_backend;
    for (const Ablation& ablation : ablation_list()) {
      const bool wanted = options_.names.empty() || std::ranges::count(options_.names, ablation.name);
      if (wanted && (*ablation.backend == 0 || backend->info().name == ablation.backend))
        of_backend.push_back({&ablation, backend.get(), backend.get()});
    }
    std::ranges::stable_sort(of_backend, {}, [](const Case& which) { return which.ablation->spheres; });
    all.insert(all.end(), of_backend.begin(), of_backend.end());
  }
  return all;
}

const Scene& AblationStudy::scene(Spheres kind) {
  const auto found = scenes_.find(kind);
  return found != scenes_.end() ? found->second : scenes_[kind] = scene_of(kind, scene_options_);
}

void AblationStudy::hold(Backend& backend, Spheres kind) {
  const auto held = holding_.find(&backend);
  if (held != holding_.end() && held->second == kind) return;
  holding_.erase(&backend);
  start(backend, kind, scene(kind));
  holding_[&backend] = kind;
}

Configuration AblationStudy::reference() {
  Configuration configuration = reference_for(session_, {}, scene_options_.n);
  if (scene_options_.n > brute_force_up_to) configuration.options.method = Method::collide_grid;
  return configuration;
}

const StepResult& AblationStudy::expected(Spheres kind) {
  const auto found = expected_.find(kind);
  if (found != expected_.end()) return found->second;
  const Configuration configuration = reference();
  hold(*configuration.backend, kind);
  return expected_[kind] = run_step(session_, configuration, false);
}

void AblationStudy::check(const Case& which) {
  if (which.ablation->work == AblationWork::collide) return check_sets(which);
  if (only_moves(which.ablation->work)) return check_moves(which);
  hold(*which.on, which.ablation->spheres);
  holding_.erase(which.on);  // copying overwrites the spheres
  for (const PeakRate rate : {PeakRate::copy, PeakRate::words}) peak_rates_of(*which.on).check(rate);
}

// Checks that on and off find the reference's set; up to brute_force_up_to spheres the reference uses no grid.
void AblationStudy::check_sets(const Case& which) {
  const Spheres kind = which.ablation->spheres;
  const StepResult& reference_result = expected(kind);
  for (const Configuration& configuration :
       {Configuration{which.on, which.ablation->on}, Configuration{which.off, which.ablation->off}}) {
    hold(*configuration.backend, kind);
    const StepResult found = run_step(session_, configuration, configuration.options.want_pairs);
    if (!same_result(reference_result, found))
      hold(*reference().backend, kind);  // require_equal lists its pairs to name the one that differs
    require_equal(session_, {scene_options_, 0}, reference(), reference_result, configuration, found);
  }
}

// Checks that on and off reach the reference's state.
void AblationStudy::check_moves(const Case& which) {
  const SceneOptions options = options_of(which.ablation->spheres, scene_options_);
  const int moves = which.ablation->spheres == Spheres::pushing ? pushes_checked : moves_checked;
  const auto moved = [&](Backend& backend, bool on) {
    holding_.erase(&backend);
    hold(backend, spheres_of(*which.ablation, on));
    holding_.erase(&backend);
    for (int k = 0; k < moves; ++k) step_of(*which.ablation, on)(backend);
    return current_state(backend);
  };
  const Motion::State reference_state = moved(*reference().backend, true);
  for (const bool on : {false, true})
    require_same_state(session_, {options, uint64_t(moves)}, *reference().backend, reference_state, *which.on,
                       moved(*which.on, on));
}

// Runs a case. Opens a second backend if on and off need one each. Leaves out a feature that the device lacks, with the
// reason.
void AblationStudy::run(Case which) {
  const Ablation& ablation = *which.ablation;
  const std::string name = fmt::format("{} {} of {}", which.on->info().name, ablation.name, scene_options_.n);
  progress_.say("checking " + name);
  std::unique_ptr<Backend> other;
  if (ablation.open_off || ablation.spheres == Spheres::drifting) {
    OpenOptions open = open_;
    if (ablation.open_off) open.*ablation.open_off = false;
    other = open_backend(which.on->info().name, open);
    which.off = other.get();
    holding_.erase(which.off);  // an earlier backend may have had this address
  }
  try {
    if (ablation.open_off && which.off->info().details == which.on->info().details)
      throw std::invalid_argument("this driver does not offer it");
    session_.comparisons = {};  // a case that was left out planned more than it made
    session_.comparisons.plan(which.on->info().name, Comparisons::sets, ablation.work == AblationWork::collide ? 2 : 0);
    session_.comparisons.plan(which.on->info().name, Comparisons::states, only_moves(ablation.work) ? 2 : 0);
    check(which);
    session_.comparisons.require_complete();
  } catch (const BackendError& error) {
    left_out.push_back(name + ": " + error.what());
    return;
  } catch (const std::invalid_argument& error) {  // a feature that this device lacks
    left_out.push_back(name + ": " + error.what());
    return;
  }
  time(which);
}

// Spheres that move begin each batch where the checked steps began; cells that drifting spheres leave are planned anew.
Contender AblationStudy::contender_for(const Case& which, const std::string& label, bool on) {
  const Ablation& ablation = *which.ablation;
  Contender contender{.label = label,
                      .backend = on ? which.on : which.off,
                      .step = step_of(ablation, on),
                      .contest = ablation.name,
                      .alternates = true};
  if (!moves(ablation.spheres)) return contender;
  const Spheres kind = spheres_of(ablation, on);
  contender.restart = [&spheres = scene(kind), kind](Backend& backend) { start(backend, kind, spheres); };
  contender.prepares = ablation.spheres != Spheres::falling;
  if (ablation.spheres == Spheres::drifting) contender.batch = drifting_steps;  // later ones differ from the first
  return contender;
}

void AblationStudy::time(const Case& which) {
  const Ablation& ablation = *which.ablation;
  const std::string backend = which.on->info().name, name = backend + " " + ablation.name;
  const std::vector<Contender> contenders = {contender_for(which, name + " on", true),
                                             contender_for(which, name + " off", false)};
  const std::vector<Samples> samples = measure(session_, contenders, sampling_, progress_);
  for (size_t k = 0; k < 2; ++k) record(which, contenders[k], samples[k], k == 0);
  rows[scene_options_.n].push_back({backend, ablation.name, time_cell(samples[0]), time_cell(samples[1]),
                                    ratio_text(contest(samples[1], samples[0]))});
  if (moves(ablation.spheres)) holding_.erase(which.on);
  which.on->set_event_driven(true), which.on->keep_near_pairs(true);
}

void AblationStudy::record(const Case& which, const Contender& contender, const Samples& samples, bool on) {
  const Spheres kind = which.ablation->spheres;
  json row = {{"table", "ablation"},
              {"n", scene_options_.n},
              {"scene", scene_json(options_of(kind, scene_options_))},
              {"option", which.ablation->name},
              {"on", on},
              {"order", kind == Spheres::in_cell_order ? "warm" : "cold"},
              {"work_per_step", work_per_step(*which.ablation, on, *contender.backend, scene(kind))}};
  row.update(to_json(samples));
  measurements.push_back(std::move(row));
}

}  // namespace spherepair
