// SPDX-License-Identifier: MIT
// What every backend does: hold a scene, move it, find its colliding pairs. One process can hold several backends; each
// call is made a few times a step at most, so virtual functions cost nothing that could be measured.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/backend/collide_options.h"
#include "common/backend/draw_options.h"
#include "common/backend/preparations.h"
#include "common/scene/motion_state.h"
#include "common/scene/scene.h"
#include "common/shared/view.h"

namespace spherepair {

// Out of memory, driver trouble, a limit of the device: what failed, where, and what to do.
class BackendError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What a device can do at best: 16 bytes a sphere copied, a scattered atomic a sphere, multiply-adds in registers; and
// the same bytes copied a word at a time.
enum class PeakRate { copy, atomics, issue, words };

struct StageTime {
  std::string stage;  // the kernel's name
  double seconds;     // on the device's own timer
};

struct BackendInfo {
  std::string name, language;  // cpu, opengl, cuda, vulkan: the API; C++, GLSL, CUDA C++: of its kernels
  std::string device;          // as the driver names it
  std::string uuid;            // of the GPU, 32 hex digits; empty for software
  bool on_host = false;        // loops of host threads: no kernels to launch in groups
  bool software = false;       // GL or Vulkan on the CPU
  bool device_timers = false;
  std::map<std::string, std::string> details;  // versions, extensions, limits
};

class Device;

class Backend {
 public:
  virtual ~Backend() = default;
  virtual const BackendInfo& info() const = 0;
  virtual Device* device() { return nullptr; }  // of a GPU's API, for work beside the scene

  // Around calls in a process that uses the APIs itself, or comes from several threads one after the other: from enter
  // to leave the thread's CUDA device and OpenGL context are this backend's, then what they were before.
  virtual void enter_thread() {}
  virtual void leave_thread() noexcept {}

  // Methods that this backend runs under their own name.
  virtual std::vector<Method> methods() const = 0;

  // Checks the scene (check_scene), allocates every buffer and copies. Throws BackendError when it does not fit.
  virtual void upload(const Scene& scene) = 0;

  // One step of the motion, or std::invalid_argument for a scene that cannot be moved. Enqueued: results wait for it.
  virtual void move() = 0;
  // Steps skip work that cannot change a bit of the state. `false` does it in every step: set_event_driven tests all
  // spheres (anchored), keep_near_pairs lists near pairs (contacts).
  virtual void set_event_driven(bool on) = 0;
  virtual void keep_near_pairs(bool on) = 0;
  virtual void sum_impulses(ImpulseSums sums) = 0;  // for measuring; std::invalid_argument where the device cannot

  // Finds the colliding pairs of the spheres as they stand, and completes that: every list has room, every pair is
  // decided, and asking for its results afterwards only reads them.
  virtual void collide(const CollideOptions& options) = 0;
  // For timing: enqueues the same search and returns. Left out are decisions that the last complete search of this kind
  // did not need, lists that turn out too short, and the number of colliding spheres; so it has no results to ask for.
  virtual void enqueue_collide(const CollideOptions& options) = 0;
  // A move and a search, launched as one step: with graphs, CUDA and Vulkan replay both together; without a batch the
  // host waits for each launch. Contacts and swept searches are launched apart from the move. step() is complete as
  // collide() is; enqueue_step() is for timing, as enqueue_collide().
  virtual void step(const CollideOptions& options) { move(), collide(options); }
  virtual void enqueue_step(const CollideOptions& options) { move(), enqueue_collide(options); }
  // Steps of `paper` in float32 and all pairs in one launch, of a persistent kernel; the results are those of the last.
  virtual bool has_persistent_steps() const { return false; }
  virtual void run_persistent_steps(uint /*steps*/) { throw BackendError(info().name + ": has no persistent kernel"); }
  virtual void enqueue_persistent_steps(uint steps) { run_persistent_steps(steps); }
  virtual void finish() = 0;  // waits for all that was enqueued
  virtual MethodChoice choice(const CollideOptions& options) const = 0;

  // Results of the last collide(). BackendError where there was none since the last move, or it was only enqueued.
  virtual Collisions collisions() = 0;
  virtual std::vector<uint> counts() = 0;  // contacts of each sphere
  virtual std::vector<Pair> pairs() = 0;   // in canonical order; needs want_pairs

  // Methods that keep less than positions and velocities (`anchored`) evaluate them where they are needed: collide()
  // and draw() the positions, this one all that state() reads.
  virtual void evaluate_positions() = 0;
  virtual void evaluate_state() = 0;

  // The nearest float32 numbers, and the words of SLOT_WIDE where the precision has them. BackendError where they have
  // not been evaluated since the last move.
  struct State {
    std::vector<vec4> positions, velocities;
    std::vector<uint> wide;
  };
  virtual State state() = 0;

  // All that the next steps depend on; `resume` takes the place of upload and goes on from there, to the same bits as
  // if nothing had been saved, on any backend. The scene must be the one that was uploaded, with the state's positions
  // and velocities.
  virtual MotionState save() = 0;
  virtual void resume(const Scene& scene, const MotionState& saved) = 0;

  // Draws the spheres as they stand; the image is complete on return. Contacts that choose colours are those of the
  // last collide(), or 0 if a move() or upload() came after it. The backend sets view.tile_capacity, counting and pass.
  virtual void draw(const View& view, const DrawOptions& options) = 0;
  // For timing: enqueues the same and returns. A list of tiles that is too short does not grow.
  virtual void enqueue_draw(const View& view, const DrawOptions& options) = 0;
  // The methods of this build. OpenGL is opened by the first draw that needs it, which throws BackendError if it is
  // missing.
  virtual std::vector<DrawMethod> draw_methods() const { return {DrawMethod::compute}; }

  // How its spheres can reach OpenGL's pipeline; empty if they are OpenGL's own or there is no pipeline.
  virtual std::vector<Transfer> transfers() const { return {}; }
  // By the last draw; none if it transferred nothing.
  virtual std::optional<Transfer> transfer_taken() const { return {}; }
  // For timing: the transfer alone, with which a draw through OpenGL begins.
  virtual void transfer(Transfer) { throw BackendError(info().name + ": its spheres are not transferred to OpenGL"); }

  // Results of the last draw(), row by row from the top. image(): pixels as in SLOT_IMAGE; visible(): each pixel's
  // sphere index and depth as in SLOT_VISIBLE.
  virtual std::vector<uint> image() = 0;
  virtual std::vector<uvec2> visible() = 0;
  // Of the last draw(), which must be through OpenGL, for each pixel: near / z, z along the camera's forward axis; 0:
  // background.
  virtual std::vector<float> depths() = 0;
  // The palette entry of each sphere, for COLOUR_BY_CLASS. Lost by upload(), resume() and, on a GPU, by drawing by
  // speed or radius.
  virtual void set_classes(std::span<const uint> classes) = 0;
  // Copies the image into an RGBA8 texture of its size in the context of OpenOptions::window, on the GPU if it is
  // there. False without such a context: image() then has to be uploaded.
  virtual bool show(uint /*texture*/) { return false; }
  virtual DrawStatistics draw_statistics() = 0;  // needs DrawOptions::count; this and visible(): of compute only

  // Decides spheres[2k] against spheres[2k + 1] for every k, with the same code as the kernels: verdict_code() each.
  virtual std::vector<uint> decide(std::span<const vec4> spheres) = 0;

  // Empty kernels, to measure the cost of launches: one, or a step of several in a chain, launched as the options say.
  virtual void launch_empty(uint groups) = 0;
  virtual void enqueue_empty_step(uint /*launches*/, const ApiOptions&) {}
  // Launches a kernel that measures this peak rate and overwrites velocities and counts; only devices have it.
  // check_peak_rate runs it once and throws BackendError when its result is wrong.
  virtual void launch_peak_rate(PeakRate) { throw BackendError(info().name + ": has no kernels for peak rates"); }
  virtual void check_peak_rate(PeakRate) { throw BackendError(info().name + ": has no kernels for peak rates"); }

  // Throws BackendError naming the buffer when a kernel wrote behind the end of one: guard words stand there.
  virtual void check_guards() = 0;

  virtual WorkCounts work_counts() const = 0;
  virtual Preparations preparations() const = 0;

  // Host seconds to compile each kernel for groups of 128; empty where the build compiles them.
  virtual std::vector<StageTime> compile_kernels() { return {}; }

  // With timing on, every kernel is bracketed by the device's timer; the times since the last call, in order.
  virtual void time_stages(bool on) = 0;
  virtual std::vector<StageTime> stage_times() = 0;
};

// Evaluates the state and returns it.
inline Backend::State current_state(Backend& backend) {
  backend.evaluate_state();
  return backend.state();
}

// The colliding flag of each sphere (the paper's colour) is that its count is not zero.
inline bool colliding(uint count) { return count != 0; }

class WindowContext;  // window_context.h

struct OpenOptions {
  // A GPU's number or UUID (device_name.h). Empty: the GPU named for another API, else the first in
  // CUDA_VISIBLE_DEVICES, else the API's first.
  std::string cuda_device = {}, gl_device = {}, vulkan_device = {};
  WindowContext* window = nullptr;  // GL lives in this context; null: in one of its own. Outlives the backends
  bool require_hardware = false;    // refuse GL and Vulkan in software
  bool allow_gpu = true;            // false: software GL and Vulkan even where a GPU is
  bool large_pages = true;          // GL: storage in large pages where the driver has it
  bool subgroups = true;            // GL, Vulkan: sums through subgroups where the driver has them
  bool vendor_free = false;         // GL: plain storage and no extension but ARB's: the backend opengl-core
  uint64_t texels = ~0ull;          // GL, Vulkan: texels of a texture buffer at most, where the driver has more
  int threads = 0;                  // of the CPU backend; 0: all cores
};

}  // namespace spherepair
