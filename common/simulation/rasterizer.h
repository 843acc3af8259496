// SPDX-License-Identifier: MIT
// Images of the spheres, coloured by their contacts, through compute kernels; through OpenGL's pipeline where the
// device has one.
#pragma once

#include "common/simulation/cluster_culling.h"
#include "common/simulation/motion/device_motion.h"
#include "common/simulation/search/pair_search.h"

namespace spherepair {

class Rasterizer {
 public:
  Rasterizer(DeviceContext& context, DeviceMotion& motion, CellSorter& sorter, PairSearch& search)
      : context_(context), motion_(motion), sorter_(sorter), search_(search), culling_(context, sorter) {}

  void upload();

  // Launches an image and returns. Left out: what a list of tiles that was too short lacks.
  void enqueue(const View& view, const DrawOptions& options);
  void run(const View& view, const DrawOptions& options);  // the same, complete

  void set_classes(std::span<const uint> classes);  // of the spheres that were uploaded

  // Of a complete image; BackendError where there is none.
  std::vector<uint> image();
  std::vector<float> depths();
  std::vector<uvec2> visible();
  bool show(uint texture);
  bool through_pipeline() const { return view_.width != 0 && !draws_by_compute(); }  // the last image
  DrawStatistics statistics();

 private:
  bool current(const View& view, const DrawOptions& options) const;
  void require_drawn(bool by_compute) const;
  bool lit() const { return view_.lighting != 0 && draws_by_compute() && context_.n > 0; }
  bool draws_by_compute() const { return options_.method == DrawMethod::compute; }
  void launch();
  void launch_colours();
  void launch_compute();
  Frame make_frame();
  void choose_pixels(Frame& frame, bool alone);
  void make_pixels(uint slot, uint64_t bytes);
  void draw_all(Frame& frame);
  void launch_per_pixel(const Frame& frame, Kernel kernel);
  bool grow_tiles();
  uint64_t statistics_offset() const { return pixels_kept_ ? 0 : DRAWN_WORDS * sizeof(uint); }  // in SLOT_DRAWN

  DeviceContext& context_;
  DeviceMotion& motion_;
  CellSorter& sorter_;
  PairSearch& search_;
  ClusterCulling culling_;
  View view_{};  // of the last image, as it was requested; a width of 0: there was none
  DrawOptions options_;
  Frame frame_{};                                    // of the last image
  bool complete_ = false;                            // all of it is drawn
  bool current_ = false;                             // it shows ...
  uint64_t version_ = 0;                             // ... the spheres and contacts as they were then
  bool pixels_kept_ = false;                         // its visible spheres are still there
  std::array<uint64_t, SLOT_TOTAL> pixels_clear_{};  // of the two slots of pixels; the counts of SLOT_DRAWN are then
                                                     // those of a new image
  uint64_t images_kept_ = 0;
  bool classes_set_ = false;  // SLOT_COLOUR was to have them; other colours write over them
};

}  // namespace spherepair
