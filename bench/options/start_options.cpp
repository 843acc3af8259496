// SPDX-License-Identifier: MIT
// The options of what a run starts from, and of its motion.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/options/options.h"
#include "bench/text/column_names.h"

namespace spherepair {

namespace {

std::string scene_names() {
  std::vector<std::string> names;
  for (const SceneKind& kind : scene_kinds()) names.emplace_back(kind.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

void add_scene_options(CLI::App& command, SceneOptions& scene) {
  command.add_option("--scene", scene.name, scene_names() + ": see `spherepair man`")->capture_default_str();
  command.add_option("--n", scene.n, "Number of spheres")->transform(count_range)->capture_default_str();
  command.add_option("--seed", scene.seed, "Of random numbers; gives the same scene on every machine")
      ->transform(steps_range)
      ->capture_default_str();
  command.add_option("--radius", scene.radius, "In metres; of the smallest sphere with --radius-ratio")
      ->capture_default_str();
  command.add_option("--radius-ratio", scene.radius_ratio, "Largest radius over smallest; each octave has as many")
      ->capture_default_str();
  command
      .add_option("--packing-fraction", scene.packing_fraction,
                  "Of the scenes uniform, far, clustered and gas, counting all spheres as smallest ones")
      ->check(fraction_range)
      ->capture_default_str();
  command.add_option("--groups", scene.groups, "Of the scene aligned: m of the paper's m x n arrangement")
      ->transform(count_range);
  command.add_option("--group-size", scene.group_size, "n of that arrangement")->transform(count_range);
  command.add_option("--offset", scene.offset, "Added to every coordinate of every centre, in metres")
      ->capture_default_str();
}

void add_file_options(CLI::App& command, std::vector<std::string>& columns, bool& decimal_comma,
                      bool& ignore_periodic) {
  command
      .add_option("--columns", columns,
                  "Of the file, in their order: x, y, z, radius or diameter, vx, vy, vz, species, _ (not read); or by "
                  "its names: x=NAME,y=NAME,z=NAME, pos=NAME for three")
      ->delimiter(',')
      ->check(complaint_of_column);
  command.add_flag("--decimal-comma", decimal_comma, "Numbers of text have a decimal comma: 0,5 is a half");
  command.add_flag("--ignore-periodic", ignore_periodic,
                   "Read XYZ with a periodic box as if it had none: pairs across its boundary are not found");
}

void add_start_options(CLI::App& command, StartOptions& start) {
  add_scene_options(command, start.scene);
  auto* input = command.add_option("--input", start.input_file,
                                   "Spheres of a file in place of a scene, in the formats of pairs --help; at rest "
                                   "unless it has velocities");
  for (const char* scene_option :
       {"--scene", "--n", "--seed", "--radius-ratio", "--packing-fraction", "--groups", "--group-size", "--offset"})
    input->excludes(command.get_option(scene_option));
  command.add_option("--frame", start.frame, "Of a file with several frames, counted from 0")
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
      .add_option("--plane", start.motion.plane, "Height of the ground below a file's spheres; default: -5 or lower")
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
                  "euler, symplectic, paper, paper-clamp, impact-linear, impact or anchored (docs/motion.md)")
      ->capture_default_str();
  command.add_option("--precision", motion.precision, "Of its state: float32, compensated or float64")
      ->capture_default_str();
  const auto by_default = [](float value) { return fmt::format("{}", value); };
  command.add_option("--dt", motion.dt, "Time step in seconds; with --contact from the shortest contact")
      ->default_str(by_default(SceneOptions{}.dt));
  command.add_option("--restitution", motion.restitution, "Coefficient of restitution, 0 to 1")
      ->default_str(by_default(SceneOptions{}.restitution));
}

void add_resume_option(CLI::App& command, std::string& file) {
  auto* resume = command.add_option("--resume", file,
                                    "Go on from a checkpoint, to the same bits; with another --restitution, --drag, "
                                    "--stiffness, --dt or --gravity as a new run of its spheres");
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
                            "--density",
                            "--plane"})
    resume->excludes(command.get_option(other));
}

}  // namespace spherepair
