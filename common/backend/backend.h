// SPDX-License-Identifier: MIT
// A backend holds a scene, moves it, finds its colliding pairs and can be measured: it is a Search, a Motion and
// Instruments. A function takes the narrowest of these that it needs. What a backend may lack, it hands out: a null
// pointer says that it is missing. One process can hold several backends. Each call is made a few times a step at most,
// so virtual functions cost nothing measurable.
#pragma once

#include "common/backend/drawing.h"
#include "common/backend/instruments.h"
#include "common/backend/motion.h"
#include "common/backend/search.h"

namespace spherepair {

struct Memory;

// The positions as a GPU API's buffer, for copies between devices (api/exchange.h).
class DevicePositions {
 public:
  virtual ~DevicePositions() = default;
  // Returns the current positions, a vec4 a sphere with its radius, and waits for all that uses them.
  virtual const Memory& positions() = 0;
  // Must follow when others have written the positions: searches and images are then of the new ones. The motion's
  // velocities and wide state stay: upload() before moving again.
  virtual void positions_changed() = 0;
};

// Steps of `paper` in float32 with all pairs, all in one launch of a persistent kernel. Results are the last step's.
class PersistentSteps {
 public:
  virtual ~PersistentSteps() = default;
  virtual void run_steps(uint steps) = 0;
  virtual void enqueue_steps(uint steps) = 0;  // for timing, as enqueue_collide()
};

class Backend : public Search, public Motion, public Instruments {
 public:
  // Bracket calls in a process that uses the APIs itself, or that calls from several threads in turn. Between enter and
  // leave the thread's CUDA device and OpenGL context are this backend's; afterwards they are the caller's again.
  virtual void enter_thread() {}
  virtual void leave_thread() noexcept {}

  // A move and a search, launched as one step. With graphs, CUDA and Vulkan replay both together; without batching the
  // host waits for each launch. Contacts and swept searches are launched apart from the move. step() completes the
  // search as collide() does; enqueue_step() is for timing, as enqueue_collide().
  virtual void step(const CollideOptions& options) { move(), collide(options); }
  virtual void enqueue_step(const CollideOptions& options) { move(), enqueue_collide(options); }

  // Null: the backend lacks it. See also device() and peak_rates().
  virtual Drawing* drawing() { return nullptr; }
  virtual PersistentSteps* persistent_steps() { return nullptr; }
  virtual DevicePositions* device_positions() { return nullptr; }
};

// Returns backend.drawing(), for callers that cannot go on without. Throws BackendError if it is missing.
inline Drawing& drawing_of(Backend& backend) {
  if (Drawing* drawing = backend.drawing()) return *drawing;
  throw BackendError(backend.info().name + ": this backend does not draw; choose another one");
}

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
  // Of opengl-spirv: compiles the text of a kernel to SPIR-V; `what` names the kernel in errors. Null: the driver gets
  // the text.
  std::vector<uint32_t> (*to_spirv)(const std::string& text, const std::string& what) = nullptr;
  std::string spirv_folder = {};  // Vulkan: folder that keeps SPIR-V; open_backend fills in an empty one
  uint64_t texels = ~0ull;        // OpenGL, Vulkan: upper limit for the texels of a texture buffer
  int threads = 0;                // of the CPU backend; 0: one per core
};

}  // namespace spherepair
