// SPDX-License-Identifier: MIT
// The options of what a run starts from, and of its motion.
#include <fmt/format.h>

#include "bench/options/options.h"
#include "bench/text/column_names.h"

namespace spherepair {

namespace {

std::string scene_help() {
  std::string text = "Scene at the start. Known scenes:\n";
  for (const SceneKind& kind : scene_kinds()) text += fmt::format("    {:<11} {}\n", kind.name, kind.summary);
  return text;
}

}  // namespace

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
  command.add_option("--gravity", start.motion.gravity, "Downwards, in m/s^2; default: 9.81, in some scenes 0")
      ->check(real_number(0, 0x1p60));
  command
      .add_option("--plane", start.motion.plane,
                  "Height of the ground below the spheres of --input; default: -5, or below the lowest sphere")
      ->check(real_number(-0x1p60, 0x1p60))
      ->needs(input)
      ->excludes(command.get_option("--box"));
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
  const auto by_default = [](float value) { return fmt::format("{}", value); };
  command.add_option("--dt", motion.dt, "Time step in seconds, from 2^-60 to 2^20")
      ->default_str(by_default(SceneOptions{}.dt));
  command.add_option("--restitution", motion.restitution, "Coefficient of restitution, 0 to 1")
      ->default_str(by_default(SceneOptions{}.restitution));
}

void add_resume_option(CLI::App& command, std::string& file) {
  auto* resume =
      command.add_option("--resume", file,
                         "Continue from this checkpoint, to the same bits as an uninterrupted run. With another "
                         "--restitution, --drag, --stiffness, --dt or --gravity a new run begins from its spheres");
  for (const char* other : {"--input",
                            "--frame",
                            "--columns",
                            "--ignore-periodic",
                            "--scene",
                            "--decimal-comma",
                            "--n",
                            "--seed",
                            "--radius",
                            "--radius-ratio",
                            "--packing-fraction",
                            "--groups",
                            "--group-size",
                            "--offset",
                            "--motion",
                            "--precision",
                            "--contact",
                            "--walls",
                            "--box",
                            "--no-sleeping",
                            "--plane"})
    resume->excludes(command.get_option(other));
}

}  // namespace spherepair
