// SPDX-License-Identifier: MIT
#include "bench/cli/options_run.h"

#include "bench/options/verbosity.h"

namespace spherepair {

void add_run(CLI::App& app, CommandLine& line, Action& action) {
  auto* command = app.add_subcommand("run", "Move one scene on one backend and find its colliding pairs");
  auto options = std::make_shared<RunOptions>();
  add_backend_option(*command, options->backend, "Where the spheres move and are searched");
  add_start_options(*command, options->start);
  add_length_options(*command, options->steps, options->until_step, options->seconds, options->until_rest);
  command->add_option("--method", options->method,
                      "auto: all pairs or the grid, whichever is likely faster; sequential, parallel (cpu); "
                      "collide_group, collide_tiled, collide_square, collide_triangle, collide_grid; collide_tensor "
                      "(cuda)");
  add_block_option(*command, options->block);
  command->add_flag("--naive", options->naive, "Test in plain float32, which is not exact");
  command->add_flag("--swept", options->swept, "Find the pairs that touch within the next step");
  command->add_flag("--per-step", options->per_step, "Print and record every step");
  command->add_flag("--hashes", options->hashes, "Print fingerprints of the pairs and hashes of the state");
  command->add_option("--pairs", options->pairs_file, "Pairs i < j of the last step, sorted: .npy, .txt or -");
  command->add_option("--contacts", options->contacts_file, "Contacts of each sphere: .npy or .txt");
  command->add_option("--spheres", options->spheres_file,
                      "Spheres after the last step in float32, for --input: .npy, .xyz, .extxyz, .csv, .tsv, .txt, "
                      ".dat or -");
  command->add_option("--json", options->json_file, "All results, times and the machine as JSON");
  add_save_options(*command, options->save_file, options->save_every);
  add_statistics_options(*command, options->statistics_file, options->statistics_every);
  auto* trajectory = command->add_option("--trajectory", options->trajectory_file,
                                         "Frames of extended XYZ, from the first step to the last");
  command->add_option("--trajectory-every", options->trajectory_every, "Steps between two frames")
      ->transform(whole_number(1, kMostSteps))
      ->capture_default_str()
      ->needs(trajectory);
  add_verbosity_options(*command, options->verbosity);
  add_open_options(*command, line.open);
  command->footer(
      "Examples:\n  spherepair run --backend glsl --scene random --n 1024 --steps 100 --pairs pairs.txt\n"
      "  spherepair run --input spheres.txt --pairs pairs.txt\n"
      "  spherepair run --n 4096 --steps 1000 --spheres end.csv");
  command->callback([=, &line, &action] {
    finish_start_options(*command, options->start);
    action = [=, &line] { return run_command(line, *options); };
  });
}

}  // namespace spherepair
