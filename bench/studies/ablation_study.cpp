// SPDX-License-Identifier: MIT
#include "bench/studies/ablation_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "api/open.h"
#include "bench/io/scene_text.h"
#include "bench/studies/ablation_work.h"

namespace spherepair {
namespace {

constexpr uint64_t brute_force_up_to = 100000;  // spheres; beyond, the CPU's grid is the reference
constexpr int moves_checked = 40;

template <typename Work>
auto spending(double& seconds, Work work) {
  struct Watch {
    double& seconds;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    ~Watch() { seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); }
  } watch{seconds};
  return work();
}

}  // namespace

AblationStudy::AblationStudy(Session& session, const OpenOptions& open, const AblateOptions& options,
                             std::function<void()> written)
    : session_(session), open_(open), options_(options), written_(std::move(written)) {
  sampling_.rounds = options.rounds;
  sampling_.fewest_rounds = std::min(sampling_.fewest_rounds, options.rounds);
  sampling_.software_seconds = 0.01;
  sampling_.hardware_peak = 0.05;
  sampling_.narrow_enough = 0.02;
  scene_options_.name = "uniform";
  scene_options_.packing_fraction = options.packing_fraction;
}

void AblationStudy::run(const std::vector<uint64_t>& sizes) {
  const std::vector<Turn> all = turns();
  uint64_t done = 0;
  for (const uint64_t n : sizes) {
    scene_options_.n = n;
    scenes_.clear(), expected_.clear(), holding_.clear();
    for (const Turn& turn : all) {
      progress_.reach(done++, all.size() * sizes.size());
      take(turn);
      written_();
    }
  }
}

// By backend, and those with the same spheres in a row: they are uploaded once.
std::vector<AblationStudy::Turn> AblationStudy::turns() {
  std::vector<Turn> all;
  for (const auto& backend : session_.backends()) {
    std::vector<Turn> of_backend;
    for (const Ablation& ablation : ablation_list()) {
      const bool wanted = options_.names.empty() || std::ranges::count(options_.names, ablation.name);
      if (wanted && (*ablation.backend == 0 || backend->info().name == ablation.backend))
        of_backend.push_back({&ablation, backend.get(), backend.get()});
    }
    std::ranges::stable_sort(of_backend, {}, [](const Turn& turn) { return turn.ablation->spheres; });
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
  spending(spent.uploading, [&] {
    const Scene& spheres = scene(kind);
    backend.upload(spheres);
    for (uint64_t left = moves_ahead(kind, spheres); left > 0; --left) backend.move();
  });
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
  return expected_[kind] = spending(spent.checking, [&] { return run_step(session_, configuration, false); });
}

void AblationStudy::check(const Turn& turn) {
  if (turn.ablation->work == Work::collide) return check_sets(turn);
  if (turn.ablation->work == Work::bounce) return check_moves(turn);
  hold(*turn.on, turn.ablation->spheres);
  holding_.erase(turn.on);  // what is copied writes over it
  spending(spent.checking,
           [&] { turn.on->check_peak_rate(PeakRate::copy), turn.on->check_peak_rate(PeakRate::words); });
}

// The same set both ways, by what neither uses where that is affordable.
void AblationStudy::check_sets(const Turn& turn) {
  const Spheres kind = turn.ablation->spheres;
  const StepResult& right = expected(kind);
  for (const Configuration& configuration :
       {Configuration{turn.on, turn.ablation->on}, Configuration{turn.off, turn.ablation->off}}) {
    hold(*configuration.backend, kind);
    const StepResult found =
        spending(spent.checking, [&] { return run_step(session_, configuration, configuration.options.want_pairs); });
    if (!same_result(right, found)) hold(*reference().backend, kind);  // to be asked for the pair that differs
    require_equal(session_, {scene_options_, 0}, reference(), right, configuration, found);
  }
}

// The same state both ways, and as the reference has it.
void AblationStudy::check_moves(const Turn& turn) {
  const SceneOptions options = options_of(turn.ablation->spheres, scene_options_);
  const auto moved = [&](Backend& backend, bool on) {
    holding_.erase(&backend);
    hold(backend, turn.ablation->spheres);
    holding_.erase(&backend);
    for (int k = 0; k < moves_checked; ++k) step_of(*turn.ablation, on)(backend);
    return current_state(backend);
  };
  const Backend::State right = moved(*reference().backend, true);
  spending(spent.checking, [&] {
    for (const bool on : {false, true})
      require_same_state(session_, {options, moves_checked}, *reference().backend, right, *turn.on,
                         moved(*turn.on, on));
  });
}

// Opens another backend where both ways need one of their own. What this device cannot do is left out with the reason.
void AblationStudy::take(Turn turn) {
  const Ablation& ablation = *turn.ablation;
  const std::string name = fmt::format("{} {} of {}", turn.on->info().name, ablation.name, scene_options_.n);
  progress_.say("checking " + name);
  std::unique_ptr<Backend> other;
  if (ablation.open_off || ablation.spheres == Spheres::windy) {
    OpenOptions open = open_;
    if (ablation.open_off) open.*ablation.open_off = false;
    other = spending(spent.opening, [&] { return open_backend(turn.on->info().name, open); });
    turn.off = other.get();
    holding_.erase(turn.off);  // of another that had this address
  }
  try {
    if (ablation.open_off && turn.off->info().details == turn.on->info().details)
      throw std::invalid_argument("this driver does not offer it");
    session_.comparisons = {};  // what was left out before planned more than it made
    session_.comparisons.plan(turn.on->info().name, Comparisons::sets, ablation.work == Work::collide ? 2 : 0);
    session_.comparisons.plan(turn.on->info().name, Comparisons::states, ablation.work == Work::bounce ? 2 : 0);
    check(turn);
    session_.comparisons.require_complete();
  } catch (const BackendError& error) {
    left_out.push_back(name + ": " + error.what());
    return;
  } catch (const std::invalid_argument& error) {  // a trick that this device lacks
    left_out.push_back(name + ": " + error.what());
    return;
  }
  spending(spent.timing, [&] { time(turn); });
}

void AblationStudy::time(const Turn& turn) {
  const Ablation& ablation = *turn.ablation;
  const std::string backend = turn.on->info().name, name = backend + " " + ablation.name;
  const std::vector<Contender> contenders = {{name + " on", turn.on, step_of(ablation, true), true},
                                             {name + " off", turn.off, step_of(ablation, false), true}};
  const std::vector<Samples> samples = measure(contenders, sampling_, progress_);
  for (size_t k = 0; k < 2; ++k) record(turn, contenders[k], samples[k], k == 0);
  const Contest verdict = contest(samples[0], samples[1]);
  rows.push_back({backend, ablation.name, std::to_string(scene_options_.n), format_ms(samples[0].median_seconds()),
                  format_ms(samples[1].median_seconds()),
                  verdict.differ ? format_percent(verdict.ratio - 1) : "no difference seen", ablation.summary});
  if (ablation.spheres == Spheres::windy) holding_.erase(turn.on);  // it has moved on
  turn.on->set_event_driven(true);
}

void AblationStudy::record(const Turn& turn, const Contender& contender, const Samples& samples, bool on) {
  const Spheres kind = turn.ablation->spheres;
  json row = {{"table", "skips"},
              {"n", scene_options_.n},
              {"scene", scene_json(options_of(kind, scene_options_))},
              {"skip", turn.ablation->name},
              {"on", on},
              {"order", kind == Spheres::in_cell_order ? "warm" : "cold"},
              {"work_a_step", work_a_step(*turn.ablation, on, *contender.backend, scene(kind))}};
  row.update(to_json(samples));
  measurements.push_back(std::move(row));
}

}  // namespace spherepair
