// SPDX-License-Identifier: MIT
#include "bench/options/options.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/io/arguments.h"
#include "bench/measure/choice.h"
#include "bench/text/column_names.h"
#include "common/backend/device_name.h"
#include "common/scene/camera.h"
#include "common/scene/known_name.h"

namespace spherepair {

// CLI11 reports "abc" as out of range, reads 010 as 8 and does not know 1e6.
CLI::Validator whole_number(uint64_t low, uint64_t high) {
  const auto read = [=](std::string& text) -> std::string {
    if (const auto number = count_of(text, low, high)) {
      text = std::to_string(*number);
      return {};
    }
    return fmt::format("'{}' is not a whole number from {} to {}, written like 16384, 16k, 1.5M or 1e6", text, low,
                       high);
  };
  return CLI::Validator(read, fmt::format("{}..{}", low, high));
}

CLI::Validator real_number(double low, double high) {
  const auto check = [=](std::string& text) -> std::string {
    if (real_number_of(text, low, high)) return {};
    return fmt::format("'{}' is not a number from {} to {}", text, low, high);
  };
  return CLI::Validator(check, fmt::format("{}..{}", low, high));
}

void refuse_empty_values(CLI::App& command) {
  const auto check = [](const std::string& text) {
    return text.empty() ? "no value was given: omit the option or give one" : std::string();
  };
  for (CLI::Option* option : command.get_options())
    if (option->get_expected_max() > 0) option->check(check);
}

namespace {

std::string scene_help() {
  std::string text = "Scene at the start. Known scenes:\n";
  for (const SceneKind& kind : scene_kinds()) text += fmt::format("    {:<11} {}\n", kind.name, kind.summary);
  return text;
}

}  // namespace

void add_backend_option(CLI::App& command, std::string& backend, const std::string& what) {
  const auto take = [&](const std::string& name) {
    std::vector<std::string> known = backend_names();
    known.push_back(kAutomaticBackend);
    require_known("backend", name, known);
    backend = name == kAutomaticBackend ? "" : name;
  };
  command
      .add_option_function<std::string>(
          "--backend", take, what + ": cpu, glsl or cuda; auto: the first that opens of cuda, glsl on a GPU, and cpu")
      ->default_str(kAutomaticBackend);
}

void add_backends_option(CLI::App& command, std::vector<std::string>& backends) {
  const auto take = [&](const std::vector<std::string>& names) {
    if (names != std::vector<std::string>{kAutomaticBackend}) require_known_backends(names), backends = names;
  };
  command
      .add_option_function<std::vector<std::string>>(
          "--backends", take,
          "Only these of cpu,glsl,cuda and glsl-core (OpenGL without vendors' extensions and storage), and each must "
          "open; auto: all that open but the last")
      ->delimiter(',')
      ->default_str(kAutomaticBackend);
}

void add_results_option(CLI::App& command, std::string& results, const std::string& files) {
  command.add_option("--results", results, fmt::format("Folder for {}; default: results/<host>-<date>", files));
}

void add_block_option(CLI::App& command, uint& block) {
  command
      .add_option("--block", block,
                  "Group size of a GPU's kernels: 32, 64, 128, 256, 512 or 1024; default: 128, and "
                  "with the method auto as it chooses")
      ->transform(block_range);
}

void add_open_options(CLI::App& command, OpenOptions& open) {
  const auto device = [&](const char* name, std::string& value, const char* text) {
    command.add_option(name, value, text)->check([](const std::string& given) -> std::string {
      try {
        static_cast<void>(DeviceName(given));
        return {};
      } catch (const std::invalid_argument& error) {
        return error.what();
      }
    });
  };
  device("--cuda-device", open.cuda_device,
         "GPU for CUDA: a number counted from 0 as CUDA does, or a UUID as nvidia-smi -L prints it; default: that of "
         "--gl-device, or the first");
  device("--gl-device", open.gl_device,
         "GPU for OpenGL: a number or UUID; default: that of --cuda-device, or the first that CUDA_VISIBLE_DEVICES "
         "leaves to CUDA");
  command.add_flag("--require-hardware", open.require_hardware, "Refuse software OpenGL");
  command
      .add_flag_callback(
          "--no-gpu", [&open] { open.allow_gpu = false; },
          "Use no GPU even if there is one: OpenGL in software; auto takes the CPU")
      ->excludes(command.get_option("--cuda-device"))
      ->excludes(command.get_option("--gl-device"));
  command
      .add_option("--threads", open.threads,
                  "Threads of the CPU backend and of the host's work on scenes and files; 0: all cores")
      ->transform(whole_number(0, 4096))
      ->capture_default_str();
}

void add_scene_options(CLI::App& command, SceneOptions& scene) {
  command.add_option("--scene", scene.name, scene_help())->capture_default_str();
  command.add_option("--n", scene.n, "Number of spheres")->transform(count_range)->capture_default_str();
  command.add_option("--seed", scene.seed, "Seed of the scene; the same on every machine")
      ->transform(steps_range)
      ->capture_default_str();
  command.add_option("--radius", scene.radius, "Radius in metres; of the smallest sphere if radii are unequal")
      ->capture_default_str();
  command
      .add_option("--radius-ratio", scene.radius_ratio,
                  "Largest radius over smallest; radii are evenly spread over the octaves between")
      ->capture_default_str();
  command
      .add_option(
          "--packing-fraction", scene.packing_fraction,
          "Packing fraction of the scenes uniform, far and clustered, as if all spheres had the smallest radius")
      ->check(fraction_range)
      ->capture_default_str();
  command.add_option("--groups", scene.groups, "Scene `aligned`: m of the paper's m x n arrangement")
      ->transform(count_range);
  command.add_option("--group-size", scene.group_size, "Scene `aligned`: n of the paper's m x n arrangement")
      ->transform(count_range);
  command.add_option("--offset", scene.offset, "Added to every coordinate of every centre, in metres")
      ->capture_default_str();
}

void add_file_options(CLI::App& command, std::vector<std::string>& columns, bool& decimal_comma,
                      bool& ignore_periodic) {
  command
      .add_option(
          "--columns", columns,
          "What the file's columns are, in their order: x,y,z, radius or diameter, vx,vy,vz, species, and _ for "
          "one that is not read; or by their names in the file: x=NAME,y=NAME,z=NAME, or pos=NAME for one of three "
          "columns. A first line of names is "
          "skipped. Default: by the names in the file, else x y z [radius [vx vy vz]]")
      ->delimiter(',')
      ->check(complaint_of_column);
  command.add_flag("--decimal-comma", decimal_comma, "Numbers of text have a decimal comma: 0,5 is a half");
  command.add_flag(
      "--ignore-periodic", ignore_periodic,
      "Read an XYZ file with a periodic box (Lattice, cell, box, pbc) as if it had none: pairs across its boundary "
      "are not found");
}

void add_start_options(CLI::App& command, StartOptions& start) {
  add_scene_options(command, start.scene);
  auto* input =
      command.add_option("--input", start.input_file,
                         "Read the spheres from a file instead: .xyz, .extxyz, .npy, or text with columns by their "
                         "names or --columns, else "
                         "`x y z radius [vx vy vz]` (see pairs --help); without velocities they start at rest");
  for (const char* scene_option :
       {"--scene", "--n", "--seed", "--radius-ratio", "--packing-fraction", "--groups", "--group-size", "--offset"})
    input->excludes(command.get_option(scene_option));
  command.add_option("--frame", start.frame, "Frame of an --input with several, counted from 0")
      ->transform(count_range)
      ->needs(input);
  add_file_options(command, start.columns, start.decimal_comma, start.ignore_periodic);
  for (const char* file_option : {"--columns", "--decimal-comma", "--ignore-periodic"})
    command.get_option(file_option)->needs(input);
  add_motion_options(command, start.motion);
  add_contact_options(command, start.motion);
  add_resume_option(command, start.resume_file);
}

void finish_start_options(const CLI::App& command, StartOptions& start) {
  const bool given = command.count("--radius") > 0;  // a scene has a default radius, a file has not
  if (given) start.radius = command.get_option("--radius")->as<double>();
}

void add_motion_options(CLI::App& command, MotionChoice& motion) {
  command
      .add_option("--motion", motion.method,
                  "euler, symplectic, paper, paper-clamp, impact-linear, impact or anchored: see docs/motion.md")
      ->capture_default_str();
  command
      .add_option("--precision", motion.precision, "Precision of the motion's state: float32, compensated or float64")
      ->capture_default_str();
  command.add_option("--dt", motion.dt, "Time step in seconds, from 2^-60 to 2^20")->capture_default_str();
  command.add_option("--restitution", motion.restitution, "Coefficient of restitution, 0 to 1")->capture_default_str();
}

void add_save_options(CLI::App& command, std::string& file, uint64_t& every) {
  command.add_option("--save", file, "Write a checkpoint to this file after the last step");
  command.add_option("--save-every", every, "Also write it every so many steps")
      ->transform(whole_number(1, kMostSteps));
}

void add_statistics_options(CLI::App& command, std::string& file, uint64_t& every) {
  auto* statistics = command.add_option(
      "--statistics", file,
      "Write energies, momentum, greatest overlap, contacts, virial and the force on the plane to this file as CSV, at "
      "the start, after the last step and between; -: to standard output. With --contact");
  command.add_option("--statistics-every", every, "Steps between two rows of it")
      ->transform(whole_number(1, kMostSteps))
      ->capture_default_str()
      ->needs(statistics);
}

void add_resume_option(CLI::App& command, std::string& file) {
  auto* resume =
      command.add_option("--resume", file, "Continue from this checkpoint, to the same bits as an uninterrupted run");
  for (const char* other :
       {"--input",  "--frame",      "--columns",      "--ignore-periodic",  "--scene",   "--decimal-comma", "--n",
        "--seed",   "--radius",     "--radius-ratio", "--packing-fraction", "--groups",  "--group-size",    "--offset",
        "--motion", "--precision",  "--dt",           "--restitution",      "--contact", "--stiffness",     "--drag",
        "--walls",  "--no-sleeping"})
    resume->excludes(command.get_option(other));
}

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

}  // namespace spherepair
