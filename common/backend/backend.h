// SPDX-License-Identifier: MIT
// The interface of a backend: it holds a scene, moves it and finds its colliding pairs. One process can hold several
// backends. Each call is made a few times a step at most, so virtual functions cost nothing measurable.
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

// The device failed: out of memory, a driver error or a limit. The message says what failed, where, and what to do.
class BackendError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The peak rates of a device that kernels measure: copying 16 bytes a sphere, one scattered atomic a sphere,
// multiply-adds in registers, and the same copy one 4-byte word at a time.
enum class PeakRate { copy, atomics, issue, words };

struct StageTime {
  std::string stage;  // the kernel's name
  double seconds;     // by the device's own timer
};

struct BackendInfo {
  std::string name, language;  // API: cpu, opengl, cuda, vulkan; kernels: C++, GLSL, CUDA C++
  std::string device;          // as the driver names it
  std::string uuid;            // of the GPU, 32 hex digits; empty for software
  bool on_host = false;        // runs loops of host threads: has no kernels to launch in groups
  bool software = false;       // GL or Vulkan on the CPU
  bool device_timers = false;
  std::map<std::string, std::string> details;  // versions, extensions, limits
};

class Device;
struct Memory;

class Backend {
 public:
  virtual ~Backend() = default;
  virtual const BackendInfo& info() const = 0;
  virtual Device* device() { return nullptr; }  // of a GPU API: for work besides the scene; else null

  // Bracket calls in a process that uses the APIs itself, or that calls from several threads in turn. Between enter and
  // leave the thread's CUDA device and OpenGL context are this backend's; afterwards they are the caller's again.
  virtual void enter_thread() {}
  virtual void leave_thread() noexcept {}

  // Returns the methods of this backend, without `automatic`.
  virtual std::vector<Method> methods() const = 0;

  // Checks the scene (check_scene), allocates every buffer and copies the scene. Throws BackendError when it does not
  // fit.
  virtual void upload(const Scene& scene) = 0;

  // Enqueues one step of the motion. Throws std::invalid_argument for a scene that cannot be moved.
  virtual void move() = 0;
  // Steps skip work that cannot change a bit of the state. With `false` every step does that work:
  // set_event_driven(false) tests all spheres (anchored), keep_near_pairs(false) lists the near pairs anew (contacts).
  virtual void set_event_driven(bool on) = 0;
  virtual void keep_near_pairs(bool on) = 0;
  virtual void sum_impulses(ImpulseSums sums) = 0;  // for measuring; std::invalid_argument where the device cannot

  // Finds the colliding pairs of the spheres at their current positions, completely: every list has room and every pair
  // is decided. Reading the results afterwards launches nothing.
  virtual void collide(const CollideOptions& options) = 0;
  // For timing: enqueues the same search and returns. It has no readable results: it omits decisions that the last
  // complete search of this kind did not need, the growth of lists that are too short, and the number of colliding
  // spheres.
  virtual void enqueue_collide(const CollideOptions& options) = 0;
  // A move and a search, launched as one step. With graphs, CUDA and Vulkan replay both together; without batching the
  // host waits for each launch. Contacts and swept searches are launched apart from the move. step() completes the
  // search as collide() does; enqueue_step() is for timing, as enqueue_collide().
  virtual void step(const CollideOptions& options) { move(), collide(options); }
  virtual void enqueue_step(const CollideOptions& options) { move(), enqueue_collide(options); }
  // Runs steps of `paper` in float32 with all pairs in one launch of a persistent kernel. Results are the last step's.
  virtual bool has_persistent_steps() const { return false; }
  virtual void run_persistent_steps(uint /*steps*/) { throw BackendError(info().name + ": has no persistent kernel"); }
  virtual void enqueue_persistent_steps(uint steps) { run_persistent_steps(steps); }
  virtual void finish() = 0;  // waits for all that was enqueued
  virtual MethodChoice choice(const CollideOptions& options) const = 0;

  // Results of the last collide(). They throw BackendError if the spheres have moved since, or if the search was only
  // enqueued.
  virtual Collisions collisions() = 0;
  virtual std::vector<uint> counts() = 0;  // contacts of each sphere
  virtual std::vector<Pair> pairs() = 0;   // in canonical order; needs want_pairs

  // Computes what `anchored` keeps in another form; other methods always have it. collide() and draw() evaluate the
  // positions themselves; state() needs evaluate_state().
  virtual void evaluate_positions() = 0;
  virtual void evaluate_state() = 0;

  // Positions and velocities rounded to float32, and for wider precisions the words of SLOT_WIDE. state() throws
  // BackendError if they have not been evaluated since the last move.
  struct State {
    std::vector<vec4> positions, velocities;
    std::vector<uint> wide;
  };
  virtual State state() = 0;

  // save() returns all that later steps depend on. resume() replaces upload() and continues from that state, on any
  // backend, with the same bits as an uninterrupted run. The scene must be the one that was uploaded, with the state's
  // positions and velocities.
  virtual MotionState save() = 0;
  virtual void resume(const Scene& scene, const MotionState& saved) = 0;

  // For copies between devices (api/exchange.h). positions() returns the buffer of the current positions, a vec4 a
  // sphere with its radius, and waits for all that uses it. positions_changed() must follow when others have written
  // it: searches and images are then of the new positions. The motion's velocities and wide state stay: upload() before
  // moving again.
  virtual const Memory& positions() { throw BackendError(info().name + ": has no buffer of a GPU's API"); }
  virtual void positions_changed() { throw BackendError(info().name + ": has no buffer of a GPU's API"); }

  // Draws the spheres at their current positions; the image is complete on return. Colours by contacts use the last
  // collide(), or 0 contacts after a later move() or upload(). The backend sets view.tile_capacity, counting and pass.
  virtual void draw(const View& view, const DrawOptions& options) = 0;
  // For timing: enqueues the same image and returns. A list of tiles that is too short does not grow.
  virtual void enqueue_draw(const View& view, const DrawOptions& options) = 0;
  // The drawing methods of this build. The first draw that needs OpenGL opens it, and throws BackendError if it is
  // missing.
  virtual std::vector<DrawMethod> draw_methods() const { return {DrawMethod::compute}; }

  // The ways in which the spheres can reach OpenGL's pipeline; empty if they are OpenGL's own or there is no pipeline.
  virtual std::vector<Transfer> transfers() const { return {}; }
  // The way that the last draw took; none if it transferred nothing.
  virtual std::optional<Transfer> transfer_taken() const { return {}; }
  // For timing: only the transfer with which a draw through OpenGL begins.
  virtual void transfer(Transfer) { throw BackendError(info().name + ": its spheres are not transferred to OpenGL"); }

  // Results of the last draw(), row by row from the top. image(): pixels as in SLOT_IMAGE; visible(): each pixel's
  // sphere index and depth as in SLOT_VISIBLE.
  virtual std::vector<uint> image() = 0;
  virtual std::vector<uvec2> visible() = 0;
  // For each pixel of the last draw(), which must have gone through OpenGL: near / z, where z is the depth along the
  // camera's forward axis; 0 for the background.
  virtual std::vector<float> depths() = 0;
  // Sets the palette entry of each sphere for COLOUR_BY_CLASS. upload(), resume() and, on a GPU, drawing by speed or
  // radius lose them.
  virtual void set_classes(std::span<const uint> classes) = 0;
  // Copies the image into an RGBA8 texture of its size in the context of OpenOptions::window, on the GPU if the image
  // is there. Returns false without such a context: the caller then uploads image().
  virtual bool show(uint /*texture*/) { return false; }
  virtual DrawStatistics draw_statistics() = 0;  // needs DrawOptions::count; DrawMethod::compute only, as visible()

  // Decides spheres[2k] against spheres[2k + 1] with the kernels' code; returns a verdict_code() for every k.
  virtual std::vector<uint> decide(std::span<const vec4> spheres) = 0;

  // Launch empty kernels, to measure what launches cost: a single one, or a step of several dependent ones.
  virtual void launch_empty(uint groups) = 0;
  virtual void enqueue_empty_step(uint /*launches*/, const ApiOptions&) {}
  // Launches a kernel that measures this peak rate; it overwrites velocities and counts. Only devices have such
  // kernels. check_peak_rate runs it once and throws BackendError when its result is wrong.
  virtual void launch_peak_rate(PeakRate) { throw BackendError(info().name + ": has no kernels for peak rates"); }
  virtual void check_peak_rate(PeakRate) { throw BackendError(info().name + ": has no kernels for peak rates"); }

  // Throws BackendError, which names the buffer, if a kernel wrote past its end, where guard words stand.
  virtual void check_guards() = 0;

  virtual WorkCounts work_counts() const = 0;
  virtual Preparations preparations() const = 0;

  // Returns the host seconds that each kernel takes to compile for groups of 128; empty if the build compiles them.
  virtual std::vector<StageTime> compile_kernels() { return {}; }

  // While timing is on, the device's timer brackets every kernel. stage_times() returns the times since its last call,
  // in order.
  virtual void time_stages(bool on) = 0;
  virtual std::vector<StageTime> stage_times() = 0;
};

// Evaluates the state and returns it.
inline Backend::State current_state(Backend& backend) {
  backend.evaluate_state();
  return backend.state();
}

// A sphere collides (the paper's flag, which sets its colour) if it has contacts.
inline bool colliding(uint count) { return count != 0; }

class WindowContext;  // window_context.h

struct OpenOptions {
  // A GPU's number or UUID (device_name.h). If empty: the GPU named for another API, else the first in
  // CUDA_VISIBLE_DEVICES, else the API's first.
  std::string cuda_device = {}, gl_device = {}, vulkan_device = {};
  WindowContext* window = nullptr;  // OpenGL uses this context; null: its own. Must outlive the backends
  bool require_hardware = false;    // refuse OpenGL and Vulkan in software
  bool allow_gpu = true;            // false: use OpenGL and Vulkan in software even if there is a GPU
  bool large_pages = true;          // OpenGL: storage in large pages if the driver has it
  bool subgroups = true;            // OpenGL, Vulkan: sums through subgroups if the driver has them
  bool vendor_free = false;         // OpenGL: plain storage and only ARB extensions: the backend opengl-core
  uint64_t texels = ~0ull;          // OpenGL, Vulkan: upper limit for the texels of a texture buffer
  int threads = 0;                  // of the CPU backend; 0: one per core
};

}  // namespace spherepair
