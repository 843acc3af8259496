// SPDX-License-Identifier: MIT
#include "shard.h"

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>

#include "commands.h"
#include "files.h"
#include "hash.h"
#include "numbers.h"

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

}  // namespace

void add_shard_options(CLI::App& command, SweepOptions& options) {
  command.add_option("--output", options.output, "Sweep: a JSON file for every configuration into this folder");
  command.add_option("--shard", options.shard, "Of a sweep: only part i of n, e.g. 2/4")->capture_default_str();
  command.add_flag("--resume", options.resume, "Of a sweep: leave out what this commit has already written there");
  command.add_flag("--list", options.list, "Of a sweep: name the configurations and stop");
}

std::string hash_of(const json& what_decides) {
  uint64_t hash = 0;
  for (const unsigned char letter : what_decides.dump()) hash = splitmix64(hash ^ letter);
  return hex64(hash);
}

int run_sweep(const std::vector<Configuration>& all, const SweepOptions& options) {
  const Shard shard = parse_shard(options.shard);
  const std::filesystem::path folder = options.output;
  if (!options.list) prepare_folder(folder);
  size_t done = 0, skipped = 0;
  for (size_t k = shard.index - 1; k < all.size(); k += shard.count) {
    const bool there = options.resume && std::filesystem::exists(folder / all[k].file);
    fmt::print("{} {}{}\n", all[k].file, all[k].title, there ? ": there already" : "");
    std::fflush(stdout);
    if (!there && !options.list) {
      const std::optional<std::string> text = all[k].run();
      if (!text) return kDifference;
      write_file(folder / all[k].file, *text);
    }
    ++(there ? skipped : done);
  }
  fmt::print("{} of {} configurations {}, {} were there already\n", done, all.size(),
             options.list ? "to be timed" : "timed", skipped);
  return kOk;
}

}  // namespace spherepair
