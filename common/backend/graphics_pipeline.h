// SPDX-License-Identifier: MIT
// Drawing through OpenGL's pipeline. Spheres that are not OpenGL's own are transferred to it first.
#pragma once

#include <functional>
#include <memory>

#include "common/backend/backend.h"

namespace spherepair {

// Where a backend has its spheres, by index: addresses in the host's memory or in CUDA's, names of OpenGL's own
// buffers, handles of Vulkan's.
struct SphereArrays {
  uint64_t positions;  // vec4[size]
  uint64_t counts;     // uint[size]: what chooses the colours, of contacts unless View::colour_by asks for others
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

  // Enqueues an image. way: how the spheres are transferred; none: the fastest way that the driver has.
  virtual void draw(DrawMethod method, const View& view, const SphereArrays& spheres, std::optional<Transfer> way) = 0;
  virtual std::vector<uint> image() = 0;    // of the last draw, in the format of Backend::image()
  virtual std::vector<float> depths() = 0;  // likewise, of Backend::depths()
  virtual void finish() = 0;                // waits for the images that were drawn
  virtual Preparations preparations() const = 0;

  // The first part of draw(). On return OpenGL has the spheres and no longer uses those before.
  virtual void transfer(const SphereArrays& spheres, std::optional<Transfer> way) = 0;
  virtual std::optional<Transfer> taken() const { return {}; }  // by the last transfer; none: there is no need of one

  // Copies an image into a texture of OpenOptions::window's context: the last one drawn, or the backend's own pixels (a
  // handle as in SphereArrays). False if the pipeline has a context of its own.
  virtual bool show_drawn(uint texture) = 0;
  virtual bool show_pixels(uint64_t pixels, uvec2 size, uint texture) = 0;
};

struct PipelineOpener {
  std::function<std::unique_ptr<GraphicsPipeline>()> open = {};  // throws BackendError with what is missing
  std::vector<Transfer> ways = {};                               // how spheres reach OpenGL, the fastest last
};

// Opened when it is first used.
class LazyPipeline {
 public:
  explicit LazyPipeline(PipelineOpener opener) : opener_(std::move(opener)) {}
  explicit operator bool() const { return bool(opener_.open); }
  const std::vector<Transfer>& ways() const { return opener_.ways; }
  GraphicsPipeline& get() {
    if (!opened_) opened_ = opener_.open();
    return *opened_;
  }
  GraphicsPipeline* opened() const { return opened_.get(); }

 private:
  PipelineOpener opener_;
  std::unique_ptr<GraphicsPipeline> opened_;
};

}  // namespace spherepair
