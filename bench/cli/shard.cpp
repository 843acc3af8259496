// SPDX-License-Identifier: MIT
#include "bench/cli/shard.h"

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>

#include "bench/cli/commands.h"
#include "bench/formats/files.h"
#include "bench/io/file_bytes.h"
#include "bench/io/numbers.h"
#include "common/shared/hash.h"

namespace spherepair {
namespace {

struct Shard {
  size_t index, count;
};

Shard parse_shard(const std::string& text) {
  const auto shard = two_numbers_of(text, '/', kMostSpheres);
  if (!shard || (*shard)[0] > (*shard)[1])
    throw std::invalid_argument(fmt::format("shard '{}' is not understood; the second of four reads 2/4", text));
  return {(*shard)[0], (*shard)[1]};
}

std::vector<SweepTask> part_of(const std::vector<SweepTask>& all, const Shard& shard) {
  std::vector<SweepTask> part;
  for (size_t k = shard.index - 1; k < all.size(); k += shard.count) part.push_back(all[k]);
  return part;
}

std::vector<std::string> files_of(const std::vector<SweepTask>& configurations) {
  std::vector<std::string> files;
  for (const SweepTask& configuration : configurations) files.push_back(configuration.file);
  return files;
}

}  // namespace

void add_shard_options(CLI::App& command, SweepOptions& options) {
  command.add_option("--output", options.output, "Sweep: a JSON file for every configuration into this folder");
  command.add_option("--shard", options.shard, "Of a sweep: only part i of n, e.g. 2/4")->capture_default_str();
  command.add_flag("--resume", options.resume, "Of a sweep: leave out what this commit has already written there");
  command.add_flag("--list", options.list, "Of a sweep: name the configurations and stop");
}

std::string hash_of(const json& what_decides) {
  uint64_t hash = 0;
  for (const unsigned char letter : json_line(what_decides)) hash = splitmix64(hash ^ letter);
  return hex64(hash);
}

int run_sweep(const std::vector<SweepTask>& all, const SweepOptions& options, bool (*is_record)(const json&)) {
  const std::vector<SweepTask> ours = part_of(all, parse_shard(options.shard));
  const std::filesystem::path folder = options.output;
  if (!options.list) prepare_folder(folder, files_of(ours));
  size_t done = 0, skipped = 0;
  for (const SweepTask& configuration : ours) {
    const std::filesystem::path path = folder / configuration.file;
    const bool there = options.resume && std::filesystem::exists(path) &&
                       is_record(json::parse(FileBytes(path).bytes(), nullptr, false));
    fmt::print("{} {}{}\n", configuration.file, configuration.title, there ? ": there already" : "");
    std::fflush(stdout);
    if (!there && !options.list) {
      const std::optional<std::string> text = configuration.run();
      if (!text) return kDifference;
      write_file(path, *text);
    }
    ++(there ? skipped : done);
  }
  fmt::print("{} of {} configurations {}, {} were there already\n", done, all.size(),
             options.list ? "to be timed" : "timed", skipped);
  return kOk;
}

}  // namespace spherepair
