// SPDX-License-Identifier: MIT
#include "bench/options/shard.h"

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>

#include "bench/formats/files.h"
#include "bench/io/context.h"
#include "bench/io/file_bytes.h"
#include "bench/io/numbers.h"
#include "bench/options/command.h"
#include "common/scene/counted.h"
#include "common/shared/hash.h"

namespace spherepair {
namespace {

struct Shard {
  size_t index, count;
};

Shard parse_shard(const std::string& text) {
  const auto shard = two_numbers_of(text, '/', kMostSpheres);
  if (!shard || (*shard)[0] > (*shard)[1])
    throw std::invalid_argument(fmt::format("shard '{}' is not i/n with i from 1 to n, such as 2/4", text));
  return {(*shard)[0], (*shard)[1]};
}

std::vector<SweepTask> part_of(const std::vector<SweepTask>& all, const Shard& shard) {
  std::vector<SweepTask> part;
  for (size_t k = shard.index - 1; k < all.size(); k += shard.count) part.push_back(all[k]);
  return part;
}

std::vector<std::string> files_of(const std::vector<SweepTask>& tasks) {
  std::vector<std::string> files;
  for (const SweepTask& task : tasks) files.push_back(task.file);
  return files;
}

}  // namespace

void add_shard_options(CLI::App& command, SweepOptions& options) {
  command.add_option("--results", options.results,
                     "Sweep: folder for a JSON file per configuration; default: results/<host>-<date>");
  command.add_option("--shard", options.shard, "Sweep: only part i of n, e.g. 2/4")->capture_default_str();
  command.add_flag("--resume", options.resume,
                   "Sweep: skip configurations that this commit has already written to the folder");
  command.add_flag("--list", options.list, "Sweep: list the configurations and stop");
}

std::string hash_of(const json& key) {
  uint64_t hash = 0;
  for (const unsigned char letter : json_line(key)) hash = splitmix64(hash ^ letter);
  return hex64(hash);
}

int run_sweep(const std::vector<SweepTask>& all, const SweepOptions& options, bool (*is_record)(const json&)) {
  const std::vector<SweepTask> ours = part_of(all, parse_shard(options.shard));
  if (options.results.empty() && (options.resume || options.shard != SweepOptions{}.shard))
    throw std::invalid_argument("--shard and --resume need the folder that is shared or resumed: --results FOLDER");
  const std::filesystem::path folder = options.results.empty() ? default_results() : options.results;
  if (!options.list) prepare_folder(folder, files_of(ours));
  size_t done = 0, skipped = 0;
  for (const SweepTask& task : ours) {
    const std::filesystem::path path = folder / task.file;
    const bool written = options.resume && std::filesystem::exists(path) &&
                         is_record(json::parse(FileBytes(path).bytes(), nullptr, false));
    fmt::print("{} {}{}\n", task.file, task.title, written ? ": already written" : "");
    std::fflush(stdout);
    if (!written && !options.list) {
      const std::optional<std::string> text = task.run();
      if (!text) return kDifference;
      write_file(path, *text);
    }
    ++(written ? skipped : done);
  }
  if (!options.list) fmt::print("Results: {}\n", folder.string());
  fmt::print("{} of {} {}, {} already written\n", done, counted(all.size(), "configuration"),
             options.list ? "to be timed" : "timed", skipped);
  return kOk;
}

}  // namespace spherepair
