// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/image/colour_values.h"
#include "bench/image/image_files.h"
#include "bench/io/arguments.h"
#include "bench/options/options.h"
#include "bench/spheres/sphere_formats.h"
#include "bench/studies/frames.h"

namespace spherepair {
namespace {

void add_camera_options(CLI::App& command, CameraOptions& camera) {
  add_number(
      command, "--azimuth", camera.azimuth, real_number(-360, 360),
      "Azimuth of the camera around --up, degrees: for y from +z to +x, for z from +x to +y, for x from +y to +z");
  add_number(command, "--elevation", camera.elevation, real_number(-90, 90),
             "Elevation of the camera above the horizon, degrees");
  command.add_option("--field", camera.field, "Vertical field of view, degrees")->capture_default_str();
  add_list(command, "--eye", camera.eye, "Position of the camera, x,y,z in metres; default: all spheres in view")
      ->expected(3)
      ->excludes("--azimuth")
      ->excludes("--elevation");
  add_list(command, "--target", camera.target,
           "Point that the camera looks at, x,y,z; default: the centre of the spheres")
      ->expected(3);
  add_list(command, "--up", camera.up, "Up direction of camera, light and ground, such as 0,0,1 (default 0,1,0)")
      ->expected(3);
  command.add_option("--near", camera.near, "Near plane in metres; 0: a thousandth of the distance to --target")
      ->capture_default_str();
}

void add_image_options(CLI::App& command, RenderOptions& options) {
  auto* frames = command.add_flag("--frames", options.frames,
                                  "All frames of the file given by --input: an image each, from one camera");
  for (CLI::Option* other : {add_number(command, "--steps", options.steps, steps_range, "Steps before the first image"),
                             add_number(command, "--images", options.images, positive_range, "Number of images"),
                             add_number(command, "--every", options.every, positive_range, "Steps between two images"),
                             command.get_option("--frame")})
    frames->excludes(other);
  add_size_option(command, options.width, options.height);
  add_number(command, "--samples", options.samples, whole_number(1, 1024), "Samples per pixel");
  add_camera_options(command, options.camera);
  command
      .add_option(
          "--draw", options.draw,
          "compute, the same bits on every backend; through OpenGL, to which CUDA's and the CPU's spheres are "
          "transferred: mesh (the paper's 80 triangles, one instanced draw), mesh_each (the same, one draw a sphere), "
          "quadric (glutSolidSphere's, one draw a sphere), points, impostor. Occlusion and shadows on the spheres are "
          "compute's alone")
      ->capture_default_str();
  command.add_flag_callback(
      "--no-legend", [&options] { options.legend = false; },
      "Omit the strip below the image that explains the colours and counts spheres and pairs");
  command.add_flag_callback(
      "--no-box", [&options] { options.box = false; },
      "Omit the edges of the bounding box of the first image's spheres, or of all --frames'");
  auto* plain = command.add_flag("--plain", options.plain, "Omit ambient occlusion, shadows and the ground");
  command
      .add_option(
          "--ground", options.ground,
          "none; plane, the scene's (default for spheres that move); lowest, below the lowest sphere along --up "
          "(default for spheres at rest); or a height along --up in metres")
      ->excludes(plain);
  command
      .add_option("--color", options.colour,
                  "What colours the spheres: contacts, radius, speed, or species, of " +
                      names_of_formats(FORMAT_HAS_SPECIES) + ". The colours fit the range of all images")
      ->capture_default_str();
  const auto take_range = [&options](const std::vector<double>& range) { options.colour_range = {range[0], range[1]}; };
  command
      .add_option_function<std::vector<double>>("--color-range", take_range,
                                                "LOW,HIGH: radii or speeds with the first and the last colour")
      ->delimiter(',')
      ->expected(2)
      ->needs("--color");
}

void check_extension(const std::string& file, const std::string& extension) {
  if (!file.empty() && std::filesystem::path(file).extension() != extension)
    throw std::invalid_argument(fmt::format("the output {} does not end in {}", file, extension));
}

}  // namespace

void check_render_files(const RenderOptions& options, uint64_t images) {
  check_extension(options.output_file, ".png");
  check_extension(options.video_file, ".mp4");
  OutputFiles files;
  add_inputs(files, options.start);
  for (uint64_t k = 0; !options.output_file.empty() && k < images; ++k)
    add_image(files, "--output", numbered(options.output_file, k, images));
  if (!options.video_file.empty()) add_image(files, "--video", options.video_file);
}

void check_render_options(const RenderOptions& options) {
  if (options.output_file.empty() && options.video_file.empty())
    throw std::invalid_argument("nothing to write: give --output image.png or --video video.mp4");
  check_render_files(options, options.images);
  draw_method_from_name(options.draw);
  const ColourBy by = colour_by_name(options.colour);
  if (options.frames && options.start.input_file.empty())
    throw std::invalid_argument("--frames draws the frames of a file: give it with --input");
  if (options.frames && by == ColourBy::speed)
    throw std::invalid_argument("--color speed: the spheres of a file's frames have no speeds");
  if (!options.colour_range) return;
  check_colour_range(by, options.colour_range->front(), options.colour_range->back());
}

void add_render(CLI::App& app, CommandLine& line, Action& action) {
  auto* command = app.add_subcommand(
      "render", "Draw spheres, coloured by contacts, radius, speed or species, to PNG images or a video");
  auto options = std::make_shared<RenderOptions>();
  command->add_option(
      "--output", options->output_file,
      "The image, .png; a JSON file of the same name records how to reproduce it and replaces only a JSON file "
      "written by render. With several images, a number precedes the extension");
  command->add_option("--video", options->video_file,
                      "A video of the images, .mp4, encoded by ffmpeg, and its JSON file");
  add_number(*command, "--rate", options->images_per_second, whole_number(1, 1000), "Images per second of the --video")
      ->needs("--video");
  add_start_options(*command, options->start);
  add_image_options(*command, *options);
  add_backend_option(*command, options->backend, "Where the spheres move and are drawn");
  command->add_option("--method", options->method, "Collision method, see run --help; default: auto");
  add_open_options(*command, line.open);
  command->footer(
      "Examples:\n  spherepair render --scene random --n 16384 --steps 120 --output spheres.png\n"
      "  spherepair render --input atoms.extxyz --azimuth 60 --elevation 30 --size 1920x1080 --output atoms.png\n"
      "  spherepair render --input atoms.extxyz --up 0,0,1 --color species --frames --video atoms.mp4\n"
      "  spherepair render --scene aligned --n 512 --images 240 --every 2 --video aligned.mp4");
  command->callback([=, &line, &action] { action = [=, &line] { return render_command(line, *options); }; });
}

void add_frames(CLI::App& app, CommandLine& line, Action& action) {
  auto* command = app.add_subcommand("frames", "Time drawing: every method, backend and number of spheres");
  auto options = std::make_shared<FramesOptions>();
  add_backends_option(*command, options->backends);
  add_list(*command, "--draws", options->draws, "Drawing methods, see render --help");
  add_list(*command, "--places", options->places, "Camera positions: outside, inside");
  add_list(*command, "--works", options->works,
           "frame: an image, each from a new camera; frame_all: the same without culling or reuse; lit: with ambient "
           "occlusion, shadows and the ground plane; loop: move, collide_grid and frame");
  command->add_flag(
      "--transfer", options->transfer,
      "Also time OpenGL drawing of the spheres of CUDA and Vulkan, transferred in every way, and transfers "
      "between these two");
  add_list(*command, "--n", options->sizes, "Numbers of spheres, sorted into cell order")->transform(positive_range);
  add_list(*command, "--most", options->most, "Most spheres that a drawing method is timed with, e.g. mesh_each:65536");
  add_size_option(*command, options->width, options->height);
  add_number(*command, "--packing-fraction", options->packing_fraction, fraction_range,
             "Packing fraction of the spheres");
  add_rounds_option(*command, options->rounds);
  add_min_seconds_option(*command, options->min_seconds);
  add_results_option(*command, options->results, "frames.json, .txt and .csv");
  add_open_options(*command, line.open);
  command->footer(
      "Images of the exact methods are compared before they are timed.\n"
      "Example:\n  spherepair frames --n 16384,1000000 --most mesh_each:16384,mesh:1000000 --results frames");
  command->callback([=, &line, &action] { action = [=, &line] { return frames_command(line, *options); }; });
}

}  // namespace spherepair
