// SPDX-License-Identifier: MIT
#include "bench/run/run_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace spherepair {
namespace {

constexpr double most_steps = 0x1p53;

std::string quoted(const std::string& word) {
  const bool plain =
      std::ranges::all_of(word, [](unsigned char c) { return std::isalnum(c) || std::strchr("._-/+=:,", c); });
  if (plain && !word.empty()) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string with_step(const std::filesystem::path& file, uint64_t step) {
  if (file == kStandardOutput) return file;
  return (file.parent_path() / fmt::format("{}-{}{}", file.stem().string(), step, file.extension().string())).string();
}

}  // namespace

uint64_t end_of(const RunOptions& options, const Start& start) {
  if (options.until_step) {
    if (*options.until_step >= start.step) return *options.until_step;
    throw std::invalid_argument(fmt::format("--until-step is {}, but the run is at step {} already: give a later one",
                                            *options.until_step, start.step));
  }
  if (options.seconds) {
    const double rounding = 1 - 0x1p-23;  // dt was rounded to float32: 0.1 s are 250 steps of 0.0004 s
    const double steps = std::ceil(rounding * *options.seconds / double(start.scene.dt));
    if (!(double(start.step) + steps <= most_steps))
      throw std::invalid_argument(fmt::format("--time {} takes {:.3g} steps of {:.3g} s: give a shorter one",
                                              *options.seconds, steps, start.scene.dt));
    return start.step + uint64_t(steps);
  }
  if (options.steps) return start.step + *options.steps;
  return options.until_rest ? uint64_t(most_steps) : start.step;
}

std::string command_to_go_on(const RunOptions& options, uint64_t step, uint64_t end) {
  std::string command = "spherepair run --resume " + quoted(options.save_file);
  const auto add = [&](const std::string& option, const std::string& value) {
    if (!value.empty()) command += " " + option + " " + quoted(value);
  };
  const auto every = [&](const std::string& option, uint64_t steps) { add(option, std::to_string(steps)); };
  add("--backend", options.backend);
  add("--method", options.method);
  if (options.naive) command += " --naive";
  if (options.swept) command += " --swept";
  if (options.until_rest) command += " --until-rest";
  if (end < uint64_t(most_steps)) every("--until-step", end);
  add("--save", options.save_file);
  if (options.save_every) every("--save-every", options.save_every);
  add("--statistics", options.statistics_file);
  if (!options.statistics_file.empty()) every("--statistics-every", options.statistics_every);
  if (!options.trajectory_file.empty()) {
    add("--trajectory", with_step(options.trajectory_file, step));
    every("--trajectory-every", options.trajectory_every);
  }
  add("--pairs", options.pairs_file);
  add("--contacts", options.contacts_file);
  add("--spheres", options.spheres_file);
  add("--json", options.json_file);
  return command;
}

}  // namespace spherepair
