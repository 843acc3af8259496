// SPDX-License-Identifier: MIT
// The studies among the subcommands: their options, and the functions that run them.
#pragma once

#include <CLI/App.hpp>
#include <memory>

#include "bench/cli/commands.h"
#include "bench/gpu/energy_study.h"
#include "bench/gpu/launch_study.h"
#include "bench/options/command.h"
#include "bench/studies/ablation_study.h"
#include "bench/studies/contact/contact_study.h"
#include "bench/studies/crossover_sweep.h"

namespace spherepair {

// Measures the saving of each optimisation and API feature. Each is timed on and off, in interleaved rounds, after a
// check that both give the same results.
std::shared_ptr<AblateOptions> add_ablate_options(CLI::App& command);
int ablate_command(const CommandLine& line, const AblateOptions& options);

// Measures from how many spheres on the grid is faster than all pairs, and whether Method::automatic chooses the faster
// one.
std::shared_ptr<CrossoverOptions> add_crossover_options(CLI::App& command);
int crossover_command(const CommandLine& line, const CrossoverOptions& options);

// Times the ways in which a step's launches reach the GPU.
std::shared_ptr<LaunchesOptions> add_launches_options(CLI::App& command);
int launches_command(const CommandLine& line, const LaunchesOptions& options);

// Measures the energy of a step on the GPU by NVML.
std::shared_ptr<EnergyOptions> add_energy_options(CLI::App& command);
int energy_command(const CommandLine& line, const EnergyOptions& options);

struct PrecisionOptions {
  std::vector<std::string> backends, methods, precisions;  // empty: all
  std::vector<int> steps;                                  // k of dt = 2^-k; empty: by machine
  uint64_t n = 0;                                          // of the timings; 0: by machine
  int rounds = 11;
  bool quick = false;
  std::string results;  // empty: default_results()
};
std::shared_ptr<PrecisionOptions> add_precision_options(CLI::App& command);
int precision_command(const CommandLine& line, const PrecisionOptions& options);

// Measures error and run time of contacts by law and time step, and the cost of each way to sum impulses.
struct ContactsOptions {
  std::vector<std::string> backends, measurements, laws, steps;  // empty: all; steps: by machine
  std::vector<uint64_t> sizes;                                   // empty: by machine
  uint64_t averaged = 0;                                         // whole steps whose mean is taken; 0: by machine
  uint64_t rest_layers = 10;
  std::vector<std::string> drag_steps;  // DRAG:STEPS, one for each stage; empty: RestPlan's
  int rounds = 11;
  std::string results;  // empty: default_results()
};
std::shared_ptr<ContactsOptions> add_contacts_options(CLI::App& command);
int contacts_command(const CommandLine& line, const ContactsOptions& options);

struct SetsOptions {
  std::vector<std::string> backends, methods, precisions;  // empty: all
  bool quick = false;
  std::string results;  // empty: default_results()
};
std::shared_ptr<SetsOptions> add_sets_options(CLI::App& command);
int sets_command(const CommandLine& line, const SetsOptions& options);

struct SweepCommandOptions {
  std::vector<std::string> backends, methods;  // empty: all
  std::vector<uint64_t> sizes;                 // empty: by machine
  std::vector<double> packing_fractions = {0.3, 0.05};
  std::vector<std::string> orders = {"cold", "warm"};
  uint block = 0;  // 0: auto's choice
  int rounds = 11;
  std::string results;  // a file per configuration; empty: default_results()
  bool resume = false;  // skips configurations whose file exists
};
std::shared_ptr<SweepCommandOptions> add_sweep_options(CLI::App& command);
int sweep_command(const CommandLine& line, const SweepCommandOptions& options);

}  // namespace spherepair
