// SPDX-License-Identifier: MIT
#include "bench/options/unknown_word.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "common/scene/known_name.h"

namespace spherepair {

const CLI::App& parsed_command(const CLI::App& app) {
  const auto given = app.get_subcommands();
  return given.empty() ? app : *given.front();
}

std::string unknown_word(const CLI::App& app) {
  const CLI::App& command = parsed_command(app);
  const std::vector<std::string> left = app.remaining(true);
  if (&command == &app && !left.empty() && !left.front().starts_with("-")) {
    std::vector<std::string> known;
    for (const CLI::App* one : app.get_subcommands({})) known.push_back(one->get_name());
    return unknown_name("subcommand", left.front(), known);
  }
  const auto option = std::ranges::find_if(left, [](const std::string& word) { return word.starts_with("-"); });
  if (option != left.end()) {
    std::vector<std::string> known;
    for (const CLI::Option* one : command.get_options())
      if (!one->get_positional()) known.push_back(one->get_name());
    const std::string name = option->substr(0, option->find('=')), nearest = nearest_name(name, known);
    return fmt::format("unknown option {}{} ({} --help lists all)", name,
                       nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest),
                       &command == &app ? "spherepair" : "spherepair " + command.get_name());
  }
  if (left.empty()) return {};
  return fmt::format("'{}' is no option of {}: options begin with --", left.front(), command.get_name());
}

}  // namespace spherepair
