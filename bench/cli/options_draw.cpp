// SPDX-License-Identifier: MIT
// The options of the subcommands that draw.
#include <fmt/format.h>

#include "bench/cli/options.h"
#include "bench/studies/frames.h"

namespace spherepair {

void add_size_option(CLI::App& command, uint& width, uint& height) {
  const auto read = [&width, &height](const std::string& text) {
    const auto size = two_numbers_of(text, 'x', widest_image);
    if (!size)
      throw CLI::ValidationError(
          "--size", fmt::format("'{}' is not a size in pixels such as 1280x720, each at most {}", text, widest_image));
    width = uint((*size)[0]);
    height = uint((*size)[1]);
  };
  command.add_option_function<std::string>("--size", read,
                                           fmt::format("Width x height in pixels (default {}x{})", width, height));
}

namespace {

void add_camera_options(CLI::App& command, CameraOptions& camera) {
  const auto vector = [&](const char* name, std::vector<double>& value, const char* text) {
    command.add_option(name, value, text)->expected(3)->delimiter(',');
  };
  command.add_option("--azimuth", camera.azimuth, "Direction of the camera around the vertical, degrees from +z to +x")
      ->check(real_number(-360, 360))
      ->capture_default_str();
  command.add_option("--elevation", camera.elevation, "Of the camera above the horizon, degrees")
      ->check(real_number(-90, 90))
      ->capture_default_str();
  command.add_option("--field", camera.field, "Vertical field of view, degrees")->capture_default_str();
  vector("--eye", camera.eye, "Place of the camera, x,y,z in metres; default: so that all spheres are in view");
  vector("--target", camera.target, "What it looks at, x,y,z; default: the middle of the spheres");
  vector("--up", camera.up, "What is upwards in the picture (default 0,1,0)");
  command
      .add_option("--near", camera.near, "Least depth that is drawn, metres; 0: a thousandth of the way to --target")
      ->capture_default_str();
}

}  // namespace

void add_render(CLI::App& app, CommandLine& line, Action& action) {
  auto* command = app.add_subcommand("render", "Draw spheres, coloured by their contacts, into a PNG or a series");
  auto options = std::make_shared<RenderOptions>();
  command->add_option(
      "--output", options->output_file,
      "The picture, .png; a JSON of the same name holds all that makes it again, and replaces no JSON but "
      "one that render wrote. Of several pictures, each gets its number before the dot");
  command->add_option("--video", options->video_file,
                      "A film of the pictures, .mp4, through ffmpeg; its JSON beside it");
  command->add_option("--rate", options->pictures_per_second, "Pictures a second of the --video")
      ->check(whole_number(1, 1000))
      ->capture_default_str();
  add_start_options(*command, options->start);
  command->add_option("--steps", options->steps, "Steps before the first picture")
      ->check(steps_range)
      ->capture_default_str();
  command->add_option("--pictures", options->images, "How many pictures")->check(positive_range)->capture_default_str();
  command->add_option("--every", options->every, "Steps from each picture to the next")
      ->check(positive_range)
      ->capture_default_str();
  add_size_option(*command, options->width, options->height);
  command->add_option("--samples", options->samples, "Pictures, each moved by part of a pixel, whose mean is taken")
      ->check(whole_number(1, 1024))
      ->capture_default_str();
  add_camera_options(*command, options->camera);
  command
      ->add_option("--draw", options->draw,
                   "compute (every backend), or of the backend glsl: mesh_each, mesh (the paper's 80 triangles), "
                   "points, impostor")
      ->capture_default_str();
  command->add_flag_callback(
      "--no-legend", [=] { options->legend = false; }, "Leave the key to the colours out");
  command->add_flag_callback(
      "--no-box", [=] { options->box = false; },
      "Leave the edges of the box out that holds all spheres of the first picture (only --draw compute has them)");
  command->add_flag("--plain", options->plain, "Leave ambient occlusion, shadows and the ground out");
  command->add_option("--backend", options->backend, "cpu, glsl or cuda; default: a GPU where there is one, else cpu");
  command->add_option("--method", options->method, "Of collision, see run --help; default: auto");
  add_open_options(*command, line.open);
  command->footer(
      "Examples:\n  spherepair render --scene random --n 16384 --steps 120 --output spheres.png\n"
      "  spherepair render --input atoms.extxyz --azimuth 60 --elevation 30 --size 1920x1080 --output atoms.png\n"
      "  spherepair render --scene aligned --n 512 --pictures 240 --every 2 --video aligned.mp4");
  command->callback([=, &line, &action] {
    finish_start_options(*command, options->start);
    action = [=, &line] { return render_command(line, *options); };
  });
}

void add_frames(CLI::App& app, CommandLine& line, Action& action) {
  auto* command = app.add_subcommand("frames", "Time drawing: every method, backend and number of spheres");
  auto options = std::make_shared<FramesOptions>();
  const auto list = [&](const char* name, std::vector<std::string>& values, const char* text) {
    command->add_option(name, values, text)->delimiter(',')->capture_default_str();
  };
  list("--backends", options->backends, "Only these, and each must open: cpu,glsl,cuda");
  list("--draws", options->draws, "Methods of drawing, see render --help");
  list("--places", options->places, "Of the camera: outside, inside");
  list("--works", options->works,
       "frame: a picture from a new place each time; frame_all: the same with nothing skipped; lit: with ambient "
       "occlusion, shadows and the ground; loop: move, collide_grid and frame");
  command->add_flag("--hand-over", options->transfer,
                    "Time CUDA's spheres drawn by OpenGL too, handed over in three ways");
  command->add_option("--n", options->sizes, "Numbers of spheres, put in cell order before")
      ->delimiter(',')
      ->check(positive_range)
      ->capture_default_str();
  command
      ->add_option("--most", options->most, "Time a method of drawing up to so many spheres only, e.g. mesh_each:65536")
      ->delimiter(',');
  add_size_option(*command, options->width, options->height);
  command->add_option("--packing-fraction", options->packing_fraction, "Of the spheres")
      ->check(fraction_range)
      ->capture_default_str();
  command->add_option("--rounds", options->rounds, "Rounds of each timing")
      ->check(whole_number(1, 100000))
      ->capture_default_str();
  command->add_option("--min-seconds", options->min_seconds, "Least time of one sample")->check(sample_range);
  command->add_option("--json", options->json_file, "Where the record goes")->capture_default_str();
  add_open_options(*command, line.open);
  command->footer(
      "Pictures of the exact methods are compared first; a wrong one is never timed.\n"
      "Example:\n  spherepair frames --n 16384,1000000 --most mesh_each:16384,mesh:1000000 --json frames.json");
  command->callback([=, &line, &action] { action = [=, &line] { return frames_command(line, *options); }; });
}

}  // namespace spherepair
