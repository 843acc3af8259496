// SPDX-License-Identifier: MIT
// The oracle of the other backends, and the CPU code that a user without a GPU would run.
#include "common/cpu/cpu_backend.h"

#include <fmt/format.h>
#include <omp.h>

#include <chrono>
#include <fstream>
#include <optional>
#include <utility>

#include "common/backend/checks.h"
#include "common/backend/method_choice.h"
#include "common/backend/plan_watch.h"
#include "common/cpu/cpu_draw.h"
#include "common/cpu/cpu_motion.h"
#include "common/cpu/search/cpu_grid.h"
#include "common/scene/camera.h"
#include "common/scene/scene_params.h"

namespace spherepair {
namespace {

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown CPU";
}

class CpuBackend final : public Backend {
 public:
  explicit CpuBackend(const OpenOptions& options)
      : threads_(options.threads ? options.threads : omp_get_max_threads()) {
    if (threads_ < 1)
      throw std::invalid_argument(fmt::format("the number of threads is {}, but must be at least 1", threads_));
    info_.name = "cpu";
    info_.device = cpu_model();
    info_.details = {{"threads", std::to_string(threads_)}};
  }

  const BackendInfo& info() const override { return info_; }
  std::vector<Method> methods() const override {
    std::vector<Method> all = {Method::sequential, Method::parallel};
    for (Method method : device_methods()) all.push_back(method);
    return all;
  }

  void upload(const Scene& scene) override {
    check_scene(scene);
    motion_.upload(scene);
    n_ = scene.size();
    equal_radii_ = scene.equal_radii;
    constants_ = {scene_params(scene, false), scene_params(scene, true)};
    plans_ = plan_grids(scene.positions);
    watch_ = PlanWatch(scene, plans_);
    work_ = {.plans = 1};
    celled_.reset();
    found_.reset();
    image_ = {};
  }

  void move() override {
    timed("move", [&] { motion_.move(threads_); });
    watch_.moved();
    celled_.reset();
    found_.reset();
  }

  void set_event_driven(bool on) override { motion_.set_event_driven(on); }

  MethodChoice choice(const CollideOptions& options) const override {
    return explain_choice(info_, n_, plans_, options);
  }

  void collide(const CollideOptions& asked) override {
    check_collide(asked);
    refuse_missing("cpu", asked, {}, false);
    CollideOptions options = asked;
    const std::vector<vec4>& positions = motion_.positions(threads_);
    replan_if_needed(positions, asked);
    options.method = chosen_method(info_, n_, plans_, asked);
    Params params = constants_[options.exact];
    if (!options.filter) leave_all_undecided(params);
    const PairSearch search{positions, params, equal_radii_ && !options.load_radii, options, threads_};
    ++work_.steps;
    work_.without_radii += search.equal_radii;
    work_.lists += options.want_pairs;
    if (options.swept) check_swept("cpu", options, motion_.options());
    timed(method_name(options.method), [&] {
      if (options.swept) {
        found_ = search_swept(search, motion_.state(threads_).velocities);
      } else if (options.method == Method::sequential) {
        found_ = search_sequential(search);
      } else if (options.method == Method::collide_group) {
        found_ = search_groups(search);
      } else if (options.method == Method::collide_grid) {
        found_ = search_cells(search);
      } else {
        found_ = search_parallel(search);
      }
    });
    method_ = options.method;
    listed_ = options.want_pairs;
  }

  void evaluate_positions() override { motion_.positions(threads_); }
  void finish() override {}
  Collisions collisions() override { return found().totals; }
  std::vector<uint> counts() override {
    const PairsFound& last = found();
    return method_ == Method::collide_grid ? grid_.counts(threads_) : last.counts;
  }
  std::vector<Pair> pairs() override {
    const std::vector<Pair>& list = found().list;
    if (!listed_) throw BackendError("cpu: no pair list was asked for; set want_pairs");
    return list;
  }
  State state() override { return motion_.state(threads_); }
  MotionState save() override { return motion_.save(threads_); }
  void resume(const Scene& scene, const MotionState& saved) override {
    upload(scene);
    motion_.resume(scene, saved);
  }

  void draw(const View& view, const DrawOptions& options) override {
    check_view(view);
    if (options.method != DrawMethod::compute)
      throw std::invalid_argument(
          fmt::format("cpu: the method of drawing {} runs on OpenGL only", draw_method_name(options.method)));
    const auto& positions = motion_.positions(threads_);
    const std::vector<uint> contacts = found_ ? counts() : std::vector<uint>(positions.size());
    if (view.lighting != 0 && (!found_ || method_ != Method::collide_grid || celled_ != Cells::dense))
      throw std::invalid_argument(
          "cpu: occlusion and shadows need the dense cells of collide_grid; collide with them first");
    Params p = constants_[true];
    set_grid(p, plans_.dense);
    View asked = view;
    asked.lanes = options.lanes(positions.size());
    timed("draw", [&] { image_ = draw_image(positions, contacts, asked, p, threads_); });
    counted_ = options.count;
  }
  std::vector<uint> image() override { return last_image().image; }
  std::vector<uvec2> visible() override { return last_image().visible; }
  DrawStatistics draw_statistics() override {
    if (!counted_) throw BackendError("cpu: drawing was not counted; set count");
    return last_image().counts;
  }

  std::vector<uint> decide(std::span<const vec4> spheres) override {
    const Params p = scene_params(Scene{}, true);
    std::vector<uint> verdicts(spheres.size() / 2);
#pragma omp parallel for num_threads(threads_) schedule(static)
    for (size_t k = 0; k < verdicts.size(); ++k) {
      verdicts[k] = verdict_code(decide_pair(spheres[2 * k], spheres[2 * k + 1], p.filter_scale, p.filter_offset));
    }
    return verdicts;
  }

  void launch_empty(uint) override {}  // a function call
  void check_guards() override {}      // vectors; the sanitizers watch them
  WorkCounts work_counts() const override { return work_; }
  void time_stages(bool on) override {
    times_.clear();
    timing_ = on;
  }
  std::vector<StageTime> stage_times() override { return std::exchange(times_, {}); }

 private:
  const PairsFound& found() const {
    if (!found_) throw BackendError("cpu: no collision step to report since the last move; call collide first");
    return *found_;
  }

  const CpuImage& last_image() const {
    if (image_.image.empty()) throw BackendError("cpu: nothing is drawn yet; call draw first");
    return image_;
  }

  void replan_if_needed(const std::vector<vec4>& positions, const CollideOptions& asked) {
    const bool may_use_grid = asked.method == Method::collide_grid || asked.method == Method::automatic;
    if (!asked.grid.replan || !may_use_grid || !watch_.needed() || !watch_.replan(positions, positions.size(), plans_))
      return;
    ++work_.plans;
    celled_.reset();
  }

  PairsFound search_cells(const PairSearch& search) {
    const GridPlan& plan = plans_.plan(search.options.grid.cells);
    const bool keep =
        search.options.grid.keep_cells && celled_ == plan.cells && celled_equal_radii_ == search.equal_radii;
    ++(keep ? work_.cells_kept : work_.sorts);
    celled_.reset();
    PairsFound found = grid_.search(search, plan, keep);
    celled_equal_radii_ = search.equal_radii;
    celled_ = plan.cells;
    return found;
  }

  template <typename Work>
  void timed(const char* stage, Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    if (timing_) times_.push_back({stage, taken.count()});
  }

  int threads_;
  BackendInfo info_;
  CpuMotion motion_;
  uint64_t n_ = 0;
  bool equal_radii_ = true;
  std::array<Params, 2> constants_{};  // [exact]
  GridPlans plans_;
  PlanWatch watch_;
  WorkCounts work_;
  CpuGrid grid_;
  std::optional<Cells> celled_;  // the cells that grid_ has sorted these positions into
  bool celled_equal_radii_ = true;
  std::optional<PairsFound> found_;
  Method method_ = Method::sequential;  // of the last collide
  bool listed_ = false;
  CpuImage image_;
  bool counted_ = false;
  bool timing_ = false;
  std::vector<StageTime> times_;
};

}  // namespace

std::unique_ptr<Backend> open_cpu_backend(const OpenOptions& options) { return std::make_unique<CpuBackend>(options); }

}  // namespace spherepair
