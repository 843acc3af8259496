// SPDX-License-Identifier: MIT
// Draws images of the spheres, coloured by their contacts, through compute kernels, or through OpenGL's pipeline if the
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

  // Launches an image and returns. Tiles that do not fit into their list are missing.
  void enqueue(const View& view, const DrawOptions& options);
  void run(const View& view, const DrawOptions& options);  // draws the complete image

  void set_classes(std::span<const uint> classes);  // one for each uploaded sphere

  // Results of a complete image; they throw BackendError if there is none.
  std::vector<uint> image();
  std::vector<float> depths();
  std::vector<uvec2> visible();
  bool show(uint texture);
  bool through_pipeline() const { return view_.width != 0 && !draws_by_compute(); }  // for the last image
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
  View view_{};  // the last request; width 0: none
  DrawOptions options_;
  Frame frame_{};                                    // of the last image
  bool complete_ = false;                            // it is drawn completely
  bool current_ = false;                             // it shows ...
  uint64_t version_ = 0;                             // ... this version of spheres and contacts
  bool pixels_kept_ = false;                         // its visible spheres are still there
  std::array<uint64_t, SLOT_TOTAL> pixels_clear_{};  // cleared pixels of both buffers; if not 0,
                                                     // the counts of SLOT_DRAWN are clear, too
  uint64_t images_kept_ = 0;
  bool classes_set_ = false;  // SLOT_COLOUR should hold classes; other colours overwrite them
};

}  // namespace spherepair
