// SPDX-License-Identifier: MIT
#include "bench/cli/command_line.h"

#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/cli/studies.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/io/interruption.h"
#include "bench/options/complaint.h"
#include "bench/options/help_format.h"
#include "bench/options/help_pages.h"
#include "bench/options/options.h"
#include "bench/options/program_threads.h"
#include "bench/options/unused_options.h"
#include "bench/tables/study.h"

namespace spherepair {
namespace {

void add_devices(CLI::App& app, CommandLine& line, Action& action) {
  auto* command =
      app.add_subcommand("devices", "List every backend: its device, versions and limits, or why it is missing");
  auto options = std::make_shared<DevicesOptions>();
  add_backends_option(*command, options->backends);
  command->add_flag("--compile", options->compile, "Time the driver's compilation of each shader");
  command->add_flag(
      "--first-use", options->first_use,
      "Time opening each backend and its first search of a million spheres, and measure its memory; name one "
      "backend, since later ones find shared libraries loaded");
  command->add_option("--json", options->json_file, "Write the same as JSON to this file; -: to standard output");
  add_open_options(*command, line.open);
  command->footer("Example:\n  spherepair devices");
  command->callback([=, &line, &action] { action = [=, &line] { return devices_command(line, *options); }; });
}

void add_selection(CLI::App& command, CompareOptions& options) {
  PlanOptions& plan = options.plan;
  add_backends_option(command, options.backends);
  add_list(command, "--scenes", plan.scenes, "Scenes to check, e.g. random,aligned:8x16,grazing (see run --help)");
  add_list(command, "--methods", plan.methods, "Only these methods (see run --help)");
  add_list(command, "--blocks", plan.blocks, "Only these group sizes: 32,64,128,256,512,1024");
  add_list(command, "--n", plan.sizes,
           "Numbers of spheres for the check and for every table but `counts` and `arrangements`")
      ->transform(positive_range);
  std::vector<std::string> tables;
  for (const TableKind& kind : table_kinds()) tables.push_back(kind.name);
  add_list(command, "--tables", plan.tables,
           fmt::format("Only these tables: {}; `none`: check only", fmt::join(tables, ", ")));
}

void add_compare(CLI::App& app, CommandLine& line, Action& action) {
  auto* command = app.add_subcommand("compare", "Check that all backends find the same pairs, then time them");
  auto options = std::make_shared<CompareOptions>();
  PlanOptions& plan = options->plan;
  add_selection(*command, *options);
  command->add_option("--steps", plan.steps, "Steps to check")->transform(steps_range);
  add_motion_options(*command, plan.motion);
  add_contact_options(*command, plan.motion);
  add_number(*command, "--every", plan.every, positive_range, "Steps between two comparisons");
  add_number(*command, "--seed", plan.seed, steps_range, "Seed of the scenes and of the order within the rounds");
  command->add_option("--rounds", plan.rounds, "Rounds per timing (default 11)")->transform(whole_number(1, 100000));
  add_min_seconds_option(*command, plan.min_seconds);
  command->add_flag("--quick", plan.quick, "Small sizes; without a GPU 6 rounds");
  command->add_flag("--full", plan.full, "All sizes, more steps and rounds");
  add_results_option(*command, options->results, "results.json, a .txt and a .csv per table");
  add_open_options(*command, line.open);
  command->footer(
      "Every configuration is checked before it is timed.\n"
      "Examples:\n  spherepair compare\n  spherepair compare --quick --backends cpu,opengl\n"
      "  spherepair compare --tables none --scenes random --n 4096 --steps 100000 --every 1000");
  command->callback([=, &line, &action] { action = [=, &line] { return compare_command(line, *options); }; });
}

void add_equal(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("equal", "Compare the collision sets and states recorded by two compare runs");
  auto options = std::make_shared<EqualOptions>();
  command->add_option("left", options->left, "results.json of one run")->required();
  command->add_option("right", options->right, "results.json of another run, on another machine")->required();
  command->footer("Example:\n  spherepair equal here/results.json there/results.json");
  command->callback([=, &action] { action = [=] { return equal_command(*options); }; });
}

void add_page(CLI::App& app, Action& action, const char* name, const char* what, std::string (*page)(const CLI::App&)) {
  app.add_subcommand(name, what)->callback([&app, &action, page] {
    action = [&app, page] {
      fmt::print("{}", page(app));
      return int(kOk);
    };
  });
}

// A study has its own options, the options for opening backends, and a function that runs it.
template <typename AddOptions, typename Study>
void add_study(CLI::App& app, CommandLine& line, Action& action, const char* name, const char* what,
               AddOptions add_options, Study study) {
  auto* command = app.add_subcommand(name, what);
  const auto options = add_options(*command);
  add_open_options(*command, line.open);
  command->callback([=, &line, &action] { action = [=, &line] { return study(line, *options); }; });
}

void add_studies(CLI::App& app, CommandLine& line, Action& action) {
  add_study(app, line, action, "precision", "Measure error and run time of every motion method and precision",
            add_precision_options, precision_command);
  add_study(app, line, action, "contacts", "Measure error and run time of contacts, and what their sums cost",
            add_contacts_options, contacts_command);
  add_study(app, line, action, "sets", "Measure how many pairs motion, storage and naive tests get wrong",
            add_sets_options, sets_command);
  add_study(app, line, action, "sweep", "Time a collision step up to 10^9 spheres", add_sweep_options, sweep_command);
  add_study(app, line, action, "crossover", "Time all pairs, the grid and the automatic choice between them",
            add_crossover_options, crossover_command);
  add_study(app, line, action, "ablate", "Time each optimisation and API feature on and off", add_ablate_options,
            ablate_command);
  add_study(app, line, action, "launches", "Time the ways in which a step's launches reach a GPU", add_launches_options,
            launches_command);
  add_study(app, line, action, "energy", "Measure the energy of a step on the GPU", add_energy_options, energy_command);
}

}  // namespace

int run_program(int argc, const char* const* argv, const Opener& opener, Runner run, const Clocks& clocks) {
  CLI::App app(
      "spherepair finds the colliding pairs of spheres exactly, on the CPU, with GLSL through OpenGL and Vulkan, and "
      "with CUDA; checks that all backends find the same pairs; and times them.");
  app.set_version_flag("--version", fmt::format("spherepair {} ({})", build_info.version, build_info.commit));
  app.formatter(std::make_shared<HelpFormat>());  // before the subcommands, which inherit it
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 success; 1 a difference was found; 2 bad usage or input, or output that cannot be written; "
      "3 a backend or device is missing or failed, or memory or threads ran out.\n"
      "Whole numbers may be written 16k, 1.5M or 1e6.\n"
      "Words: a step moves all spheres by dt and finds the pairs; a group is the threads of a GPU that share memory "
      "(work-group, block), --block its size; a round takes one sample of each contender, in random order; cold is the "
      "random order of spheres, in which each step sorts them, warm the order of the cells.\n"
      "Start with:\n  spherepair devices\n  spherepair compare --quick\nHelp on a subcommand: spherepair compare "
      "--help");
  CommandLine line;
  line.words.assign(argv, argv + argc);
  line.opener = opener, line.clocks = clocks;
  Action action;
  add_devices(app, line, action);
  add_run(app, line, action);
  add_pairs(app, line, action);
  add_render(app, line, action);
  add_view(app, line, action);
  add_frames(app, line, action);
  add_compare(app, line, action);
  add_equal(app, action);
  add_studies(app, line, action);
  add_page(app, action, "completion", "Print a script that completes commands and options in bash", bash_completion);
  add_page(app, action, "man", "Print the manual page: spherepair man > spherepair.1", man_page);
  for (CLI::App* command : app.get_subcommands({})) refuse_empty_values(*command), group_options(*command);
  return run_action([&]() -> int {
    try {
      app.parse(argc, argv);
      refuse_unused_options(parsed_command(app));
      handle_interruption(parsed_command(app).get_name());
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code()) throw std::invalid_argument(complaint_about(error, app));
      app.exit(error);  // prints the help or the version
      return kOk;
    }
    return run([&] {
      start_team(line.open.threads);
      return action();
    });
  });
}

}  // namespace spherepair
