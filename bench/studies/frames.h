// SPDX-License-Identifier: MIT
// Timing of pictures: the tasks of spherepair frames, and its record.
#pragma once

#include <functional>

#include "bench/measure/session.h"
#include "bench/measure/timing.h"
#include "common/backend/shared_drawing.h"
#include "common/scene/camera.h"

namespace spherepair {

struct FramesOptions {
  std::vector<std::string> backends;  // empty: all that open
  std::vector<uint64_t> sizes = {16384, 1000000};
  std::vector<std::string> draws = {"compute", "mesh_each", "mesh", "points", "impostor"};
  std::vector<std::string> places = {"outside", "inside"};  // of the camera
  std::vector<std::string> works = {"frame", "frame_all", "lit", "loop"};
  uint width = 1920, height = 1080;
  double packing_fraction = 0.3;
  bool transfer = false;  // CUDA's spheres through OpenGL too
  int rounds = 11;
  double min_seconds = 0;         // of a sample; 0: the timing core's own
  std::vector<std::string> most;  // METHOD:n, spheres that a method of drawing is timed with
  std::string json_file = "frames.json";
};

// What is timed: one picture from a new place each time.
struct FrameTask {
  Backend* backend;
  DrawMethod draw;
  std::string place, work;  // as FramesOptions has them
};
std::string label(const FrameTask& task);

// Steps through the grid, in the groups that `auto` takes; light needs the dense cells.
CollideOptions in_dense_cells(const Backend& backend, uint64_t n);

// CUDA's spheres drawn by OpenGL, from one camera after the other.
struct SharedTask {
  Backend* cuda;
  CollideOptions collide;  // of a step
  std::vector<View> views;
  std::vector<DrawMethod> draws;
};
// Measures a step named by draw and work; seconds.
using TimeStep =
    std::function<double(const std::string& draw, const std::string& work, const std::function<void()>& step)>;
// Every way to hand over, alone, with a picture, and with picture and next step pipelined: how much of it overlaps, as
// frames.cpp says. The spheres have moved afterwards.
json time_transfers(const SharedTask& task, SharedDrawing& shared, const TimeStep& time);

// The spheres put into the order of the grid's cells, in which a simulation that sorts would keep them.
Scene in_cell_order(Scene scene);

// Cameras on a short way around the spheres, or through their middle.
std::vector<View> way(const Bounds& bounds, const std::string& place, uint width, uint height, uint lighting);

}  // namespace spherepair
