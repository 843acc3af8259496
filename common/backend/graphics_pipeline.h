// SPDX-License-Identifier: MIT
// Drawing through OpenGL's pipeline. Spheres that are not OpenGL's own are transferred to it first.
#pragma once

#include <functional>
#include <memory>

#include "common/backend/backend.h"

namespace spherepair {

// Where a backend has its spheres, by index: in the host's memory, or in CUDA's.
struct SphereArrays {
  const vec4* positions;
  const uint* counts;  // what chooses the colours, of contacts unless View::colour_by asks for others
  uint64_t size;
};

class GraphicsPipeline {
 public:
  virtual ~GraphicsPipeline() = default;

  // Enqueues an image. way: how the spheres are transferred; none: the fastest way that the driver has.
  virtual void draw(DrawMethod method, const View& view, const SphereArrays& spheres, std::optional<Transfer> way) = 0;
  virtual std::vector<uint> image() = 0;    // of the last draw, in the format of Backend::image()
  virtual std::vector<float> depths() = 0;  // likewise, of Backend::depths()
  virtual void finish() = 0;                // waits for the images that were drawn
  virtual Preparations preparations() const = 0;

  // What draw() begins with. The spheres are OpenGL's when this returns, which is done with those it had before.
  virtual void transfer(const SphereArrays& spheres, std::optional<Transfer> way) = 0;
  virtual std::optional<Transfer> taken() const { return {}; }  // by the last transfer; none: there is no need of one

  // Into a texture of the context of OpenOptions::window: the last image drawn, or one that the backend has computed,
  // wherever that has its arrays. False where the pipeline has a context of its own.
  virtual bool show_drawn(uint texture) = 0;
  virtual bool show_pixels(const uint* pixels, uvec2 size, uint texture) = 0;
};

// Throws BackendError with what is missing.
using PipelineOpener = std::function<std::unique_ptr<GraphicsPipeline>()>;

// Opened when it is first used.
class LazyPipeline {
 public:
  explicit LazyPipeline(PipelineOpener open) : open_(std::move(open)) {}
  explicit operator bool() const { return bool(open_); }
  GraphicsPipeline& get() {
    if (!opened_) opened_ = open_();
    return *opened_;
  }
  GraphicsPipeline* opened() const { return opened_.get(); }

 private:
  PipelineOpener open_;
  std::unique_ptr<GraphicsPipeline> opened_;
};

}  // namespace spherepair
