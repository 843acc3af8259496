// SPDX-License-Identifier: MIT
// Draws a scene's spheres.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/backend/draw_options.h"
#include "common/shared/view.h"

namespace spherepair {

class Drawing {
 public:
  virtual ~Drawing() = default;

  // Draws the spheres at their current positions; the image is complete on return. Colours by contacts use the last
  // collide(), or 0 contacts after a later move() or upload(). The backend sets view.tile_capacity, counting and pass.
  virtual void draw(const View& view, const DrawOptions& options) = 0;
  // For timing: enqueues the same image and returns. A list of tiles that is too short does not grow.
  virtual void enqueue_draw(const View& view, const DrawOptions& options) = 0;
  // The drawing methods of this build. The first draw that needs OpenGL opens it, and throws BackendError if it is
  // missing.
  virtual std::vector<DrawMethod> draw_methods() const = 0;

  // The ways in which the spheres can reach OpenGL's pipeline; empty if they are OpenGL's own or there is no pipeline.
  virtual std::vector<Transfer> transfers() const = 0;
  // The way that the last draw took; none if it transferred nothing.
  virtual std::optional<Transfer> transfer_taken() const = 0;
  // For timing: only the transfer with which a draw through OpenGL begins, by one of transfers().
  virtual void transfer(Transfer way) = 0;

  // Results of the last draw(), row by row from the top. image(): pixels as in SLOT_IMAGE; visible(): each pixel's
  // sphere index and depth as in SLOT_VISIBLE.
  virtual std::vector<uint> image() = 0;
  virtual std::vector<uvec2> visible() = 0;
  // For each pixel of the last draw(), which must have gone through OpenGL: near / z, where z is the depth along the
  // camera's forward axis; 0 for the background.
  virtual std::vector<float> depths() = 0;
  // Sets the palette entry of each sphere for COLOUR_BY_CLASS. upload() and resume() delete the entries. On a GPU an
  // image by speed or radius deletes them, too.
  virtual void set_classes(std::span<const uint> classes) = 0;
  // Copies the image into an RGBA8 texture of its size in the context of OpenOptions::window, on the GPU if the image
  // is there. Returns false without such a context: the caller then uploads image().
  virtual bool show(uint texture) = 0;
  virtual DrawStatistics draw_statistics() = 0;  // needs DrawOptions::count; DrawMethod::compute only, as visible()
};

}  // namespace spherepair
