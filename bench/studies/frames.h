// SPDX-License-Identifier: MIT
// Options and tasks of spherepair frames; cell order and camera paths, which other studies use too.
#pragma once

#include <functional>

#include "bench/measure/session.h"
#include "bench/measure/timing.h"
#include "common/scene/camera.h"

namespace spherepair {

struct FramesOptions {
  std::vector<std::string> backends = {};  // empty: all that open
  std::vector<uint64_t> sizes = {16384, 1000000};
  std::vector<std::string> draws = {"compute", "mesh_each", "mesh", "quadric", "points", "impostor"};
  std::vector<std::string> places = {"outside", "inside"};  // camera positions
  std::vector<std::string> works = {"frame", "frame_all", "lit", "loop"};
  uint width = 1920, height = 1080;
  double packing_fraction = 0.3;
  bool transfer = false;  // also times OpenGL drawing of CUDA's and Vulkan's spheres, and exchanges between these two
  int rounds = 11;
  double min_seconds = 0;              // of the longest batch; 0: as study_sampling()
  std::vector<std::string> most = {};  // METHOD:n, the most spheres with which a drawing method is timed
  std::string results = {};            // folder; empty: a new one
};

// One drawing method on one backend: each image from a new camera.
struct FrameTask {
  Backend* backend;
  DrawMethod draw;
  std::string place, work;  // as in FramesOptions
};
std::string label(const FrameTask& task);

// A step through the grid with the group size that `auto` chooses. Dense, since lighting needs dense cells.
CollideOptions in_dense_cells(const Backend& backend, uint64_t n);

// Uploads the scene and searches it so.
std::function<void(Backend&)> start_of_loop(const Scene& scene);

// OpenGL drawing of another backend's spheres.
struct TransferTask {
  Backend* backend;
  CollideOptions collide;   // of a step
  std::vector<View> views;  // one per image
  std::vector<DrawMethod> draws;
};
// Times a step and records it under draw and work; returns seconds. moves: the step moves the spheres.
using TimeStep = std::function<double(const std::string& draw, const std::string& work,
                                      const std::function<void()>& step, bool moves)>;
// Times every transfer alone, with an image, and with image and next step pipelined; returns `overlaps` of the record
// (frames_study.h). Moves the spheres.
json time_transfers(const TransferTask& task, const TimeStep& time);

// Sorts the spheres into cell order, in which a sorting simulation would keep them.
Scene in_cell_order(Scene scene);

// Cameras on a short path around the spheres ("outside") or through their middle ("inside").
std::vector<View> camera_path(const Bounds& bounds, const std::string& place, uint width, uint height,
                              const Look& look);

}  // namespace spherepair
