// SPDX-License-Identifier: MIT
// The options for the start of a run and for its motion.
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

constexpr const char* of_scene = "--scene --n --seed --radius-ratio --packing-fraction --groups --group-size --offset";
constexpr const char* of_file = "--frame --columns --decimal-comma --ignore-periodic";
constexpr const char* of_start =
    "--input --radius --motion --precision --contact --walls --box --periodic --no-sleeping --density --plane";

// Calls `act` with each of the options in `names`.
void for_each(CLI::App& command, const std::string& names, const std::function<void(CLI::Option*)>& act) {
  for (const std::string& name : CLI::detail::split(names, ' ')) act(command.get_option(name));
}

void add_scene_options(CLI::App& command, SceneOptions& scene) {
  command.add_option("--scene", scene.name, scene_names() + ": see `spherepair man`")->capture_default_str();
  add_number(command, "--n", scene.n, count_range, "Number of spheres");
  add_number(command, "--seed", scene.seed, steps_range, "Of random numbers; gives the same scene on every machine");
  command.add_option("--radius-ratio", scene.radius_ratio, "Largest radius over smallest; each octave has as many")
      ->capture_default_str();
  add_number(command, "--packing-fraction", scene.packing_fraction, fraction_range,
             "Of the scenes uniform, far, clustered and gas, counting all spheres as smallest ones");
  command.add_option("--groups", scene.groups, "Of the scene aligned: m of the paper's m x n arrangement")
      ->transform(count_range);
  command.add_option("--group-size", scene.group_size, "n of that arrangement")->transform(count_range);
  command.add_option("--offset", scene.offset, "Added to every coordinate of every centre, in metres")
      ->capture_default_str();
}

}  // namespace

void add_file_options(CLI::App& command, std::vector<std::string>& columns, bool& decimal_comma,
                      bool& ignore_periodic) {
  add_list(command, "--columns", columns,
           "Of the file, in their order: x, y, z, radius or diameter, vx, vy, vz, species, _ (not read); or by its "
           "names: x=NAME,y=NAME,z=NAME, pos=NAME for three")
      ->check(complaint_of_column);
  command.add_flag("--decimal-comma", decimal_comma, "Numbers of text have a decimal comma: 0,5 is a half");
  command.add_flag("--ignore-periodic", ignore_periodic,
                   "Read a file with a periodic box as if it had none: pairs across its boundary are not found");
}

void add_start_options(CLI::App& command, StartOptions& start) {
  add_scene_options(command, start.scene);
  const auto take_radius = [&start](long double radius) {
    start.scene.radius = float(radius), start.radius = double(radius);  // a file has no default
  };
  command
      .add_option_function<long double>("--radius", take_radius,
                                        "In metres; of the smallest sphere with --radius-ratio")
      ->default_str(fmt::format("{}", start.scene.radius));
  auto* input = command.add_option("--input", start.input_file,
                                   "Spheres of a file in place of a scene, in the formats of pairs --help; at rest "
                                   "unless it has velocities");
  command.add_option("--frame", start.frame, "Of a file with several frames, counted from 0")->transform(count_range);
  add_file_options(command, start.columns, start.decimal_comma, start.ignore_periodic);
  add_motion_options(command, start.motion);
  add_contact_options(command, start.motion);
  command.add_option("--gravity", start.motion.gravity, "Downwards, in m/s^2; default: 9.81, in some scenes 0")
      ->check(real_number(0, 0x1p60));
  command
      .add_option("--plane", start.motion.plane, "Height of the ground below a file's spheres; default: -5 or lower")
      ->check(real_number(-0x1p60, 0x1p60))
      ->needs(input)
      ->excludes("--box");
  auto* resume = command.add_option("--resume", start.resume_file,
                                    "Go on from a checkpoint, to the same bits; with another --restitution, --drag, "
                                    "--stiffness, --dt or --gravity as a new run of its spheres");
  for_each(command, of_scene, [=](CLI::Option* one) { one->excludes(input)->excludes(resume); });
  for_each(command, of_file, [=](CLI::Option* one) { one->needs(input)->excludes(resume); });
  for_each(command, of_start, [=](CLI::Option* one) { one->excludes(resume); });
}

void add_motion_options(CLI::App& command, MotionChoice& motion) {
  command
      .add_option("--motion", motion.method,
                  "euler, symplectic, paper, paper-clamp, impact-linear, impact or anchored (docs/motion.md)")
      ->capture_default_str();
  command.add_option("--precision", motion.precision, "Of its state: float32, compensated or float64")
      ->capture_default_str();
  command.add_option("--dt", motion.dt, "Time step in seconds; with --contact from the shortest contact")
      ->default_str(fmt::format("{}", SceneOptions{}.dt));
  command.add_option("--restitution", motion.restitution, "Coefficient of restitution, 0 to 1")
      ->default_str(fmt::format("{}", SceneOptions{}.restitution));
}

}  // namespace spherepair
