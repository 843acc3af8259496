// SPDX-License-Identifier: MIT
#include "bench/cli/commands.h"
#include "bench/options/options.h"

namespace spherepair {
namespace {

void add_length_options(CLI::App& command, RunOptions& options) {
  command.add_option("--steps", options.steps, "Steps to move before the pairs are found")
      ->transform(steps_range)
      ->default_str("0");
  command.add_option("--until-step", options.until_step, "Move to this step, counted from the first start")
      ->transform(steps_range)
      ->excludes("--steps");
  command.add_option("--time", options.seconds, "Move for so many simulated seconds, in whole steps")
      ->check(real_number(0, 1e30))
      ->excludes("--steps")
      ->excludes("--until-step");
  command.add_flag("--until-rest", options.until_rest,
                   "With --drag: end when all spheres are at rest, after these steps at the latest");
}

// Files that a run writes once every N steps.
void add_repeated_outputs(CLI::App& command, RunOptions& options) {
  const CLI::Validator steps = whole_number(1, kMostSteps);
  command.add_option("--save", options.save_file, "Checkpoint of the last step, to go on with to the same bits");
  command.add_option("--save-every", options.save_every, "Steps between two checkpoints")->transform(steps);
  command.add_option(
      "--statistics", options.statistics_file,
      "CSV of energies, momentum, greatest overlap, contacts, virial and force on the plane, with --contact");
  add_number(command, "--statistics-every", options.statistics_every, steps, "Steps between two rows")
      ->needs("--statistics");
  command.add_option("--trajectory", options.trajectory_file,
                     "Frames of extended XYZ, from the first step to the last");
  add_number(command, "--trajectory-every", options.trajectory_every, steps, "Steps between two frames")
      ->needs("--trajectory");
}

}  // namespace

void add_run(CLI::App& app, CommandLine& line, Action& action) {
  auto* command = app.add_subcommand("run", "Move one scene on one backend and find its colliding pairs");
  auto options = std::make_shared<RunOptions>();
  add_backend_option(*command, options->backend, "Where the spheres move and are searched");
  add_start_options(*command, options->start);
  add_length_options(*command, *options);
  command->add_option("--method", options->method,
                      "auto: all pairs or the grid, whichever is likely faster; sequential, parallel (cpu); "
                      "collide_group, collide_tiled, collide_square, collide_triangle, collide_grid; collide_tensor "
                      "(cuda, vulkan)");
  add_block_option(*command, options->block);
  command->add_flag("--naive", options->naive, "Test in plain float32, which is not exact");
  command->add_flag("--swept", options->swept, "Find the pairs that touch within the next step")->excludes("--naive");
  command->add_flag("--per-step", options->per_step, "Print and record every step");
  command->add_flag("--hashes", options->hashes, "Print fingerprints of the pairs and hashes of the state");
  command->add_option("--pairs", options->pairs_file, "Pairs i < j of the last step, sorted: .npy, .csv, .txt or -");
  command->add_option("--contacts", options->contacts_file, "Contacts of each sphere: .npy, .csv, .txt or -");
  command->add_option("--spheres", options->spheres_file,
                      "Spheres after the last step in float32, for --input: .npy, .xyz, .extxyz, .csv, .tsv, .txt, "
                      ".dat or -; for ParaView: .vtp");
  command->add_option("--json", options->json_file, "All results, times and the machine as JSON");
  add_repeated_outputs(*command, *options);
  add_verbosity_options(*command, options->verbosity);
  add_open_options(*command, line.open);
  command->footer(
      "Examples:\n  spherepair run --backend opengl --scene random --n 1024 --steps 100 --pairs pairs.txt\n"
      "  spherepair run --input spheres.txt --pairs pairs.txt\n"
      "  spherepair run --n 4096 --steps 1000 --spheres end.csv");
  command->callback([=, &line, &action] { action = [=, &line] { return run_command(line, *options); }; });
}

}  // namespace spherepair
