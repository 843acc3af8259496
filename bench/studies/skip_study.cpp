// SPDX-License-Identifier: MIT
#include "bench/studies/skip_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "api/open.h"
#include "bench/io/scene_text.h"
#include "bench/studies/skip_work.h"

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

SkipStudy::SkipStudy(Session& session, const OpenOptions& open, const SkipsOptions& options,
                     std::function<void()> written)
    : session_(session), open_(open), options_(options), written_(std::move(written)) {
  sampling_.rounds = options.rounds;
  sampling_.fewest_rounds = std::min(sampling_.fewest_rounds, options.rounds);
  sampling_.software_seconds = 0.01;
  sampling_.hardware_ceiling = 0.05;
  sampling_.narrow_enough = 0.02;
  scene_options_.name = "uniform";
  scene_options_.packing_fraction = options.packing_fraction;
}

void SkipStudy::run(const std::vector<uint64_t>& sizes) {
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
std::vector<SkipStudy::Turn> SkipStudy::turns() {
  std::vector<Turn> all;
  for (const auto& backend : session_.backends()) {
    std::vector<Turn> of_backend;
    for (const Skip& skip : skip_list()) {
      const bool wanted = options_.names.empty() || std::ranges::count(options_.names, skip.name);
      if (wanted && (*skip.backend == 0 || backend->info().name == skip.backend))
        of_backend.push_back({&skip, backend.get(), backend.get()});
    }
    std::ranges::stable_sort(of_backend, {}, [](const Turn& turn) { return turn.skip->spheres; });
    all.insert(all.end(), of_backend.begin(), of_backend.end());
  }
  return all;
}

const Scene& SkipStudy::scene(Spheres kind) {
  const auto found = scenes_.find(kind);
  return found != scenes_.end() ? found->second : scenes_[kind] = scene_of(kind, scene_options_);
}

void SkipStudy::hold(Backend& backend, Spheres kind) {
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

Asked SkipStudy::reference() {
  Asked asked = reference_for(session_, {}, scene_options_.n);
  if (scene_options_.n > brute_force_up_to) asked.options.method = Method::collide_grid;
  return asked;
}

const Answer& SkipStudy::expected(Spheres kind) {
  const auto found = expected_.find(kind);
  if (found != expected_.end()) return found->second;
  const Asked asked = reference();
  hold(*asked.backend, kind);
  return expected_[kind] = spending(spent.checking, [&] { return ask(session_, asked, false); });
}

void SkipStudy::check(const Turn& turn) {
  if (turn.skip->work == Work::collide) return check_sets(turn);
  if (turn.skip->work == Work::bounce) return check_moves(turn);
  hold(*turn.on, turn.skip->spheres);
  holding_.erase(turn.on);  // what is copied writes over it
  spending(spent.checking, [&] { turn.on->check_ceiling(Ceiling::copy), turn.on->check_ceiling(Ceiling::words); });
}

// The same set both ways, by what neither uses where that is affordable.
void SkipStudy::check_sets(const Turn& turn) {
  const Spheres kind = turn.skip->spheres;
  const Answer& right = expected(kind);
  for (const Asked& asked : {Asked{turn.on, turn.skip->on}, Asked{turn.off, turn.skip->off}}) {
    hold(*asked.backend, kind);
    const Answer found = spending(spent.checking, [&] { return ask(session_, asked, asked.options.want_pairs); });
    if (!same_answer(right, found)) hold(*reference().backend, kind);  // to be asked for the pair that differs
    require_equal(session_, {scene_options_, 0}, reference(), right, asked, found);
  }
}

// The same state both ways, and as the reference has it.
void SkipStudy::check_moves(const Turn& turn) {
  const SceneOptions options = options_of(turn.skip->spheres, scene_options_);
  const auto moved = [&](Backend& backend, bool on) {
    holding_.erase(&backend);
    hold(backend, turn.skip->spheres);
    holding_.erase(&backend);
    for (int k = 0; k < moves_checked; ++k) step_of(*turn.skip, on)(backend);
    return backend.state();
  };
  const Backend::State right = moved(*reference().backend, true);
  spending(spent.checking, [&] {
    for (const bool on : {false, true})
      require_same_state(session_, {options, moves_checked}, *reference().backend, right, *turn.on,
                         moved(*turn.on, on));
  });
}

// Opens another backend where both ways need one of their own. What this device cannot do is left out with the reason.
void SkipStudy::take(Turn turn) {
  const Skip& skip = *turn.skip;
  const std::string name = fmt::format("{} {} of {}", turn.on->info().name, skip.name, scene_options_.n);
  progress_.say("checking " + name);
  std::unique_ptr<Backend> other;
  if (skip.open_off || skip.spheres == Spheres::windy) {
    OpenOptions open = open_;
    if (skip.open_off) open.*skip.open_off = false;
    other = spending(spent.opening, [&] { return open_backend(turn.on->info().name, open); });
    turn.off = other.get();
    holding_.erase(turn.off);  // of another that had this address
  }
  try {
    if (skip.open_off && turn.off->info().details == turn.on->info().details)
      throw std::invalid_argument("this driver does not offer it");
    session_.comparisons = {};  // what was left out before planned more than it made
    session_.comparisons.plan(turn.on->info().name, Comparisons::sets, skip.work == Work::collide ? 2 : 0);
    session_.comparisons.plan(turn.on->info().name, Comparisons::states, skip.work == Work::bounce ? 2 : 0);
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

void SkipStudy::time(const Turn& turn) {
  const Skip& skip = *turn.skip;
  const std::string backend = turn.on->info().name, name = backend + " " + skip.name;
  const std::vector<Contender> contenders = {{name + " on", turn.on, step_of(skip, true), true},
                                             {name + " off", turn.off, step_of(skip, false), true}};
  const std::vector<Samples> samples = measure(contenders, sampling_, progress_);
  for (size_t k = 0; k < 2; ++k) record(turn, contenders[k], samples[k], k == 0);
  const Contest verdict = contest(samples[0], samples[1]);
  rows.push_back({backend, skip.name, std::to_string(scene_options_.n), format_ms(samples[0].median_seconds()),
                  format_ms(samples[1].median_seconds()),
                  verdict.differ ? format_percent(verdict.ratio - 1) : "no difference seen", skip.summary});
  if (skip.spheres == Spheres::windy) holding_.erase(turn.on);  // it has moved on
  turn.on->look_at_due_only(true);
}

void SkipStudy::record(const Turn& turn, const Contender& contender, const Samples& samples, bool on) {
  const Spheres kind = turn.skip->spheres;
  json row = {{"table", "skips"},
              {"n", scene_options_.n},
              {"scene", scene_json(options_of(kind, scene_options_))},
              {"skip", turn.skip->name},
              {"on", on},
              {"order", kind == Spheres::in_cell_order ? "warm" : "cold"},
              {"work_a_step", work_a_step(*turn.skip, on, *contender.backend, scene(kind))}};
  row.update(to_json(samples));
  measurements.push_back(std::move(row));
}

}  // namespace spherepair
