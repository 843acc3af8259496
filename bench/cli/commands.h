// SPDX-License-Identifier: MIT
// The subcommands and their options. Each returns the exit code.
#pragma once

#include <optional>

#include "bench/formats/start.h"
#include "bench/options/command.h"
#include "bench/run/run_options.h"
#include "bench/tables/plan.h"
#include "common/image/antialiased_image.h"

namespace CLI {  // not its header, which takes long to compile
class App;
}

namespace spherepair {

struct DevicesOptions {
  std::vector<std::string> backends;
  bool compile = false;    // time the driver's compilation of each kernel
  bool first_use = false;  // time opening and the first search, and measure memory
  std::string json_file;
};
int devices_command(const CommandLine& line, const DevicesOptions& options);

void add_run(CLI::App& app, CommandLine& line, Action& action);
int run_command(const CommandLine& line, const RunOptions& options);

struct PairsOptions {
  std::string backend, method;                     // no backend: the fastest that opens; no method: auto
  std::string input_file, output_file, json_file;  // no output: only the summary
  std::string contacts_file;                       // the number of contacts of each sphere
  bool geometry = false;                           // also the overlap, normal and point of each pair
  bool distances = false;                          // also the distance of the centres of each pair
  bool csr = false;                                // a full neighbour list in place of the pairs
  std::optional<double> radius = {}, cutoff = {};  // cutoff: points up to this distance are a pair
  std::optional<uint64_t> frame;
  std::vector<std::string> columns;
  bool decimal_comma = false, ignore_periodic = false;
  uint block = 0;  // 0: not given
  Verbosity verbosity = Verbosity::normal;
};
void add_pairs(CLI::App& app, CommandLine& line, Action& action);
// Throws std::invalid_argument before any work for options that are wrong.
void check_pairs_options(const PairsOptions& options);
int pairs_command(const CommandLine& line, const PairsOptions& options);

struct RenderOptions {
  std::string backend, method;
  StartOptions start;
  std::string output_file, video_file;  // .png, .mp4: at least one
  uint images_per_second = 30;          // of the video
  uint64_t steps = 0;                   // before the first image
  uint64_t images = 1, every = 1;       // steps between two images
  uint width = 1280, height = 720, samples = 16;
  CameraOptions camera;
  std::string draw = "compute";     // DrawMethod
  std::string colour = "contacts";  // ColourBy
  std::optional<std::array<double, 2>> colour_range = {};
  std::string ground;              // see place_ground
  bool frames = false;             // draws all frames of an XYZ file instead of steps
  bool legend = true, box = true;  // box: draws the edges of the bounding box of the first image or of all frames
  bool plain = false;              // no occlusion, shadow or ground
};
void add_render(CLI::App& app, CommandLine& line, Action& action);
int render_command(const CommandLine& line, const RenderOptions& options);
// Throw std::invalid_argument for options that exclude each other, and for invalid names of images or videos.
void check_render_options(const RenderOptions& options);
void check_render_files(const RenderOptions& options, uint64_t images);

struct ViewOptions {
  std::string backend, method;  // at the start
  StartOptions start;
  uint width = 1280, height = 720;  // of the window, pixels
  std::optional<double> speed;      // see Viewer::Options; none: 1, or 0 with `frames`
  uint64_t frames = 0;              // the window closes after them; 0: never
  std::string screenshot_file;      // of the last frame
  std::string keys;                 // one key press per frame, as if by the user
};
void add_view(CLI::App& app, CommandLine& line, Action& action);
int view_command(const CommandLine& line, const ViewOptions& options);

struct FramesOptions;  // frames.h
void add_frames(CLI::App& app, CommandLine& line, Action& action);
int frames_command(const CommandLine& line, const FramesOptions& options);

struct CompareOptions {
  std::vector<std::string> backends;
  PlanOptions plan;
  std::string results;  // empty: default_results()
};
int compare_command(const CommandLine& line, const CompareOptions& options);

struct EqualOptions {
  std::string left, right;
};
int equal_command(const EqualOptions& options);

}  // namespace spherepair
