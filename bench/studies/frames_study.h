// SPDX-License-Identifier: MIT
// The measurements of spherepair frames: times of drawing, as JSON of the format "spherepair frames 1":
//   context, backends, clocks   as in results.json of compare; width, height, packing_fraction
//   frames     one entry per measurement:
//     n, backend, draw (DrawMethod), place (camera outside | inside the spheres), work, and the timing core's fields:
//     median_ms, interval_ms, samples_ms, batch, device_stages_ms ...; image: hash of a check image, equal for all
//     exact methods; counts: DrawStatistics of that image. The same on several backends is a contest. Works:
//       frame      one image, each from a new camera
//       frame_all  the same without culling or reuse
//       lit        the same with ambient occlusion, shadows and the ground plane
//       loop       move, collide_grid and frame, the first 20 steps
//     With --transfer, also OpenGL drawing of the spheres of CUDA and Vulkan (transferred: true; to: opengl): draw is
//     none for a transfer alone and for `step` (move and collide_grid alone); work is host, registered or imported
//     (Transfer), with a wait after each image, or the same with _pipelined: transfer, image and step, where only the
//     transfer waits. With both, also positions and radii from one to the other and back (to: cuda, vulkan; draw:
//     none). bytes: what a transfer copies
//   overlaps   with --transfer: n, backend, draw, transfer, frame_ms, step_ms, pipelined_ms, and overlap: the share of
//   the
//     shorter of image and step that the pipelined loop hides
//   left_out   n, backend, draw and reason of whatever was requested but not timed
#pragma once

#include <map>

#include "bench/studies/frames.h"

namespace spherepair {

// --most: spheres by drawing method. Throws std::invalid_argument with the text that is wrong.
std::map<std::string, uint64_t> most_by_draw(const std::vector<std::string>& limits);

class FramesStudy {
 public:
  FramesStudy(Session& session, const FramesOptions& options);

  // Checks, then times, every requested drawing method on every backend with n spheres.
  void measure_size(uint64_t n);

  json frames = json::array(), left_out = json::array(), overlaps = json::array();
  std::string text_of(uint64_t n, size_t width) const;  // the tables of this number of spheres

 private:
  void leave_out(uint64_t n, const Backend& backend, const std::string& draw, const std::string& reason);
  bool beyond_most(uint64_t n, const std::string& draw) const;
  void measure_place(uint64_t n, const std::vector<Backend*>& backends, const Scene& scene, const Bounds& bounds,
                     const std::string& place);
  void measure_tasks(const std::vector<FrameTask>& tasks, const Scene& scene, const std::vector<View>& views);
  void measure_transfers(uint64_t n, Backend& backend, const Scene& scene, const Bounds& bounds);
  void measure_exchanges(uint64_t n, const Scene& scene);
  double measure_transfer(json entry, Backend& backend, const std::function<void()>& step, const Scene* restart);
  void check(uint64_t n, const FrameTask& task, const std::vector<View>& views);

  Session& session_;
  const FramesOptions& options_;
  std::map<std::string, uint64_t> most_;  // spheres by drawing method
  Sampling sampling_;
  Progress progress_;
};

}  // namespace spherepair
