// SPDX-License-Identifier: MIT
// The CPU backend: the reference for the other backends, and the code that a user without a GPU runs.
#include "common/cpu/cpu_backend.h"

#include <fmt/format.h>
#include <omp.h>

#include <chrono>
#include <fstream>
#include <utility>

#include "common/backend/checks.h"
#include "common/cpu/cpu_draw.h"
#include "common/cpu/cpu_motion.h"
#include "common/scene/camera.h"
#include "common/shared/draw.h"
#include "common/shared/exact.h"

namespace spherepair {
namespace {

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown CPU";
}

BackendInfo describe_cpu(int threads) {
  if (threads < 1)
    throw std::invalid_argument(fmt::format("the number of threads is {}, but must be at least 1", threads));
  return {.name = "cpu",
          .language = "C++",
          .device = cpu_model(),
          .uuid = {},
          .on_host = true,
          .details = {{"threads", std::to_string(threads)}}};
}

// Times each stage by the host's clock, while it is on.
class StageClock {
 public:
  void turn(bool on) { on_ = on, times_.clear(); }
  template <typename Work>
  void time(const char* stage, Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    if (on_) times_.push_back({stage, taken.count()});
  }
  std::vector<StageTime> take() { return std::exchange(times_, {}); }

 private:
  bool on_ = false;
  std::vector<StageTime> times_;
};

class CpuBackend final : public Backend, public Drawing {
 public:
  CpuBackend(const OpenOptions& options, PipelineOpener pipeline)
      : threads_(options.threads ? options.threads : omp_get_max_threads()),
        info_(describe_cpu(threads_)),
        motion_(info_, threads_),
        search_(info_, threads_),
        pipeline_(std::move(pipeline)) {}

  const BackendInfo& info() const override { return info_; }
  Drawing* drawing() override { return this; }
  std::vector<Method> methods() const override {
    std::vector<Method> all = {Method::sequential, Method::parallel};
    for (Method method : device_methods()) all.push_back(method);
    return all;
  }

  void upload(const Scene& scene) override {
    check_scene(scene);
    motion_.upload(scene);
    search_.upload(scene);
    image_ = {};
    drawn_ = {};
    classes_.clear();
  }
  void resume(const Scene& scene, const MotionState& saved) override { upload(scene), motion_.resume(scene, saved); }

  void move() override {
    clock_.time("move", [&] { motion_.move(threads_); });
    search_.moved();
  }
  void set_event_driven(bool on) override { motion_.set_event_driven(on); }
  void keep_near_pairs(bool on) override { motion_.keep_near_pairs(on); }
  void evaluate_positions() override { motion_.positions(threads_); }
  void evaluate_state() override { motion_.evaluate_state(threads_); }
  State state() override { return motion_.state(); }
  MotionState save() override { return motion_.save(threads_); }

  MethodChoice choice(const CollideOptions& options) const override { return search_.choice(options); }
  void collide(const CollideOptions& options) override {
    motion_.require_sound();
    const auto& positions = motion_.positions(threads_);
    if (motion_.periodic()) check_images(options);
    const Method method = search_.prepare(options, positions);
    if (motion_.periodic())
      return clock_.time(method_name(method), [&] { search_.run_images(positions, motion_.near_pairs()); });
    if (options.swept) motion_.require_movable(), motion_.evaluate_state(threads_);
    const State state = options.swept ? motion_.state() : State{};
    const bool anchored = motion_.options().method == MotionMethod::anchored;
    const MotionState saved = options.swept && anchored ? motion_.save(threads_) : MotionState{};
    clock_.time(method_name(method), [&] { search_.run(positions, state, saved); });
  }
  void enqueue_collide(const CollideOptions& options) override { collide(options); }
  void finish() override {
    if (pipeline_.opened()) pipeline_.opened()->finish();
  }
  Collisions collisions() override { return search_.totals(); }
  std::vector<uint> counts() override { return search_.counts(); }
  std::vector<Pair> pairs() override { return search_.pairs(); }

  void draw(const View& view, const DrawOptions& options) override {
    check_view(view);
    if (options.transfer && options.method == DrawMethod::compute)
      throw std::invalid_argument("cpu: drawing by compute transfers no spheres to OpenGL");
    if (options.method != DrawMethod::compute) return draw_by_pipeline(view, options);
    const auto& positions = motion_.positions(threads_);
    const std::vector<uint> entries = colours(view);
    View wanted = view;
    wanted.lanes = options.lanes(positions.size());
    clock_.time("draw", [&] { image_ = draw_image(positions, entries, wanted, search_.light_cells(), threads_); });
    drawn_ = options;
    size_ = {view.width, view.height};
  }
  void enqueue_draw(const View& view, const DrawOptions& options) override { draw(view, options); }
  std::vector<DrawMethod> draw_methods() const override {
    if (pipeline_) return {all_draw_methods().begin(), all_draw_methods().end()};
    return {DrawMethod::compute};
  }
  std::vector<Transfer> transfers() const override { return pipeline_.ways(); }
  void transfer(Transfer way) override {
    const auto& positions = motion_.positions(threads_);
    const std::vector<uint> contacts = colours({});
    pipeline_.get().transfer(arrays_of(positions, contacts), way);
  }
  std::optional<Transfer> transfer_taken() const override {
    return drawn_.method == DrawMethod::compute ? std::nullopt : pipeline_.opened()->taken();
  }
  std::vector<uint> image() override {
    return drawn_.method == DrawMethod::compute ? last_image().image : pipeline_.get().image();
  }
  std::vector<float> depths() override {
    if (drawn_.method == DrawMethod::compute)
      throw BackendError("cpu: the last image was not drawn through OpenGL; ask for visible()");
    return pipeline_.get().depths();
  }
  void set_classes(std::span<const uint> classes) override {
    check_classes("cpu", classes, motion_.positions(threads_).size());
    classes_.assign(classes.begin(), classes.end());
  }
  bool show(uint texture) override {
    if (!pipeline_) return false;
    if (drawn_.method != DrawMethod::compute) return pipeline_.get().show_drawn(texture);
    return pipeline_.get().show_pixels(handle_of(last_image().image.data()), size_, texture);
  }
  std::vector<uvec2> visible() override {
    if (!drawn_.keep_visible) throw BackendError("cpu: visible spheres were not kept; set keep_visible");
    return last_image().visible;
  }
  DrawStatistics draw_statistics() override {
    if (!drawn_.count) throw BackendError("cpu: drawing was not counted; set count");
    return last_image().counts;
  }

  std::vector<uint> decide(std::span<const vec4> spheres) override {
    const SearchParams p = search_params(Scene{}, true);
    std::vector<uint> verdicts(spheres.size() / 2);
#pragma omp parallel for num_threads(threads_) schedule(static)
    for (size_t k = 0; k < verdicts.size(); ++k) {
      verdicts[k] = verdict_code(decide_pair(spheres[2 * k], spheres[2 * k + 1], p.filter_scale, p.filter_offset));
    }
    return verdicts;
  }
  void launch_empty(uint) override {}  // a function call
  void enqueue_empty_step(uint, const ApiOptions&) override {}
  void check_guards() override {}  // buffers are vectors, which the sanitizers watch
  WorkCounts work_counts() const override {
    WorkCounts work = search_.work();
    work.steps += motion_.contact_searches();
    return work;
  }
  Preparations preparations() const override {
    return pipeline_.opened() ? pipeline_.opened()->preparations() : Preparations{};
  }
  void time_stages(bool on) override { clock_.turn(on); }
  std::vector<StageTime> stage_times() override { return clock_.take(); }

 private:
  // Returns a number for each sphere, which chooses its colour.
  std::vector<uint> colours(const View& view) {
    const auto& positions = motion_.positions(threads_);
    if (view.colour_by == COLOUR_BY_CLASS && classes_.size() != positions.size())
      throw BackendError("cpu: the spheres have no classes; call set_classes");
    if (view.colour_by == COLOUR_BY_CLASS) return classes_;
    std::vector<uint> entries(positions.size());
    if (view.colour_by == COLOUR_BY_CONTACTS) return search_.searched() ? counts() : entries;
    if (view.colour_by == COLOUR_BY_SPEED) motion_.evaluate_state(threads_);
    const std::vector<vec4>& velocities = motion_.velocities();
#pragma omp parallel for num_threads(threads_) schedule(static)
    for (size_t i = 0; i < entries.size(); ++i) entries[i] = palette_entry(positions[i], velocities[i], view);
    return entries;
  }

  void draw_by_pipeline(const View& view, const DrawOptions& options) {
    if (!pipeline_)
      throw std::invalid_argument(
          fmt::format("cpu: drawing by {} needs OpenGL, which this build lacks", draw_method_name(options.method)));
    const auto& positions = motion_.positions(threads_);
    const std::vector<uint> entries = colours(view);
    clock_.time(draw_method_name(options.method),
                [&] { pipeline_.get().draw(options.method, view, arrays_of(positions, entries), options.transfer); });
    image_ = {};
    drawn_ = options;
  }

  const CpuImage& last_image() const {
    if (drawn_.method != DrawMethod::compute)
      throw BackendError(fmt::format("cpu: the last image was drawn by {}, which keeps no indices of spheres",
                                     draw_method_name(drawn_.method)));
    if (image_.image.empty()) throw BackendError("cpu: nothing is drawn yet; call draw first");
    return image_;
  }

  int threads_;
  BackendInfo info_;
  CpuMotion motion_;
  CpuSearch search_;
  CpuImage image_;
  DrawOptions drawn_;
  std::vector<uint> classes_;
  uvec2 size_{};  // of the image
  LazyPipeline pipeline_;
  StageClock clock_;
};

}  // namespace

std::unique_ptr<Backend> open_cpu_backend(const OpenOptions& options, PipelineOpener pipeline) {
  return std::make_unique<CpuBackend>(options, std::move(pipeline));
}

}  // namespace spherepair
