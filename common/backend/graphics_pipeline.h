// SPDX-License-Identifier: MIT
// Draws through OpenGL's pipeline. Spheres that are not OpenGL's own are transferred to it first.
#pragma once

#include <functional>
#include <memory>

#include "common/backend/backend.h"

namespace spherepair {

// Where a backend keeps its spheres, in index order. Handles are addresses in host or CUDA memory, names of OpenGL's
// own buffers, or handles of Vulkan's.
struct SphereArrays {
  uint64_t positions;  // vec4[size]
  uint64_t counts;     // uint[size]: chooses the colours; contacts unless View::colour_by says otherwise
  uint64_t size;
};

inline uint64_t handle_of(const void* address) { return reinterpret_cast<uintptr_t>(address); }
template <typename T>
const T* address_of(uint64_t handle) {
  return reinterpret_cast<const T*>(uintptr_t(handle));
}
inline SphereArrays arrays_of(std::span<const vec4> positions, std::span<const uint> counts) {
  return {handle_of(positions.data()), handle_of(counts.data()), positions.size()};
}

class GraphicsPipeline {
 public:
  virtual ~GraphicsPipeline() = default;

  // Enqueues an image. way: how the spheres are transferred; none: the driver's fastest.
  virtual void draw(DrawMethod method, const View& view, const SphereArrays& spheres, std::optional<Transfer> way) = 0;
  virtual std::vector<uint> image() = 0;    // of the last draw, in the format of Drawing::image()
  virtual std::vector<float> depths() = 0;  // of the last draw, in the format of Drawing::depths()
  virtual void finish() = 0;                // waits until the images are drawn
  virtual Preparations preparations() const = 0;

  // Does the first part of draw(). On return OpenGL has its copy and no longer reads the previous one.
  virtual void transfer(const SphereArrays& spheres, std::optional<Transfer> way) = 0;
  virtual std::optional<Transfer> taken() const { return {}; }  // by the last transfer; none: none was needed

  // Copy an image into a texture of OpenOptions::window's context: the last one drawn, or the backend's own pixels (a
  // handle as in SphereArrays). They return false if the pipeline has a context of its own.
  virtual bool show_drawn(uint texture) = 0;
  virtual bool show_pixels(uint64_t pixels, uvec2 size, uint texture) = 0;
};

struct PipelineOpener {
  std::function<std::unique_ptr<GraphicsPipeline>()> open = {};  // throws BackendError with what is missing
  std::vector<Transfer> ways = {};                               // how spheres can reach OpenGL, the fastest last
};

// A pipeline that opens on first use.
class LazyPipeline {
 public:
  explicit LazyPipeline(PipelineOpener opener) : opener_(std::move(opener)) {}
  explicit operator bool() const { return bool(opener_.open); }
  const std::vector<Transfer>& ways() const { return opener_.ways; }
  // Throws BackendError if there is none, or none opens.
  GraphicsPipeline& get() {
    if (!opener_.open) throw BackendError("OpenGL's pipeline takes no other spheres here; draw without a transfer");
    if (!opened_) opened_ = opener_.open();
    return *opened_;
  }
  GraphicsPipeline* opened() const { return opened_.get(); }

 private:
  PipelineOpener opener_;
  std::unique_ptr<GraphicsPipeline> opened_;
};

}  // namespace spherepair
