// SPDX-License-Identifier: MIT
// Copies Vulkan's spheres and images to OpenGL: into shared memory, or through the host.
#include "interop/vulkan/vulkan_to_gl.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>

#include "glsl/context.h"
#include "glsl/driver_memory.h"
#include "glsl/gl_drawing.h"
#include "glsl/gl_renderer.h"
#include "vulkan/vulkan_device.h"

namespace spherepair {
namespace {

// A buffer of Vulkan's memory that OpenGL imports.
class SharedBuffer {
 public:
  SharedBuffer(Device& vulkan, uint64_t bytes) : bytes_(bytes), memory_(export_memory(vulkan, bytes)) {
    const auto storage = import_memory(memory_->bytes(), memory_->descriptor());
    if (!storage)
      throw BackendError(fmt::format("interop: OpenGL could not import {} bytes of Vulkan's memory", bytes));
    storage_ = *storage;
  }
  ~SharedBuffer() {
    if (context_is_current()) delete_storage(storage_);
  }
  SharedBuffer(const SharedBuffer&) = delete;
  SharedBuffer& operator=(const SharedBuffer&) = delete;

  void copy(uint64_t handle) { memory_->copy(handle); }
  GLuint buffer() const { return storage_.buffer; }
  uint64_t bytes() const { return bytes_; }

 private:
  uint64_t bytes_;
  std::unique_ptr<ExportedMemory> memory_;
  BufferStorage storage_;
};

class VulkanToGl final : public GlDrawing {
 public:
  VulkanToGl(const OpenOptions& options, Device& vulkan)
      : GlDrawing(options),
        vulkan_(vulkan),
        shares_(exports_memory(vulkan) && epoxy_has_gl_extension("GL_EXT_memory_object_fd")) {}
  ~VulkanToGl() override {
    if (try_make_current()) shared_ = {}, image_.reset();
  }

  void transfer(const SphereArrays& spheres, std::optional<Transfer> way) override {
    make_current();
    glFinish();  // the last image may still read the buffers that are written next
    if (spheres.size == 0) return through_host(nullptr, nullptr, 0);
    if (way) return transfer_by(*way, spheres);
    try {
      transfer_by(shares_ ? Transfer::imported : Transfer::host, spheres);
    } catch (const BackendError&) {
      if (!shares_) throw;
      shares_ = false;
      transfer_by(Transfer::host, spheres);
    }
  }

  bool show_pixels(uint64_t pixels, uvec2 size, uint texture) override {
    if (!of_window()) return false;
    make_current();
    const uint64_t count = uint64_t(size.x) * size.y;
    if (!shares_) return GlDrawing::show_pixels(handle_of(read<uint>(pixels, count).data()), size, texture);
    glFinish();  // the last image may still read the buffers that are written next
    share(image_, count * sizeof(uint)).copy(pixels);
    texture_from_buffer(texture, size, image_->buffer());
    return true;
  }

 private:
  template <typename Value>
  std::vector<Value> read(uint64_t handle, uint64_t count) {
    std::vector<Value> values(count);
    vulkan_.read({handle, count * sizeof(Value), {}}, values.data(), 0, count * sizeof(Value));
    return values;
  }

  SharedBuffer& share(std::unique_ptr<SharedBuffer>& buffer, uint64_t bytes) {
    if (buffer && buffer->bytes() == bytes) return *buffer;
    buffer.reset();
    buffer = std::make_unique<SharedBuffer>(vulkan_, bytes);
    count_allocation();
    return *buffer;
  }

  void transfer_by(Transfer way, const SphereArrays& spheres) {
    if (way == Transfer::registered)
      throw BackendError("interop: Vulkan maps no buffers of OpenGL; transfer spheres as host or imported");
    if (way == Transfer::imported && !shares_)
      throw BackendError("interop: Vulkan and OpenGL share no memory here; transfer spheres as host");
    if (way == Transfer::host) {
      const std::vector<vec4> positions = read<vec4>(spheres.positions, spheres.size);
      return through_host(positions.data(), read<uint>(spheres.counts, spheres.size).data(), spheres.size);
    }
    share(shared_[0], spheres.size * sizeof(vec4)).copy(spheres.positions);
    share(shared_[1], spheres.size * sizeof(uint)).copy(spheres.counts);
    set_source(shared_[0]->buffer(), shared_[1]->buffer(), Transfer::imported);
  }

  Device& vulkan_;
  bool shares_;  // the drivers seem to offer memory for both
  std::array<std::unique_ptr<SharedBuffer>, 2> shared_;
  std::unique_ptr<SharedBuffer> image_;
};

}  // namespace

std::unique_ptr<GraphicsPipeline> open_vulkan_to_gl(const OpenOptions& options, Device& vulkan) {
  return std::make_unique<VulkanToGl>(options, vulkan);
}

}  // namespace spherepair
