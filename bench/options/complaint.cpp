// SPDX-License-Identifier: MIT
#include "bench/options/complaint.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>

#include "common/scene/counted.h"
#include "common/scene/known_name.h"

namespace spherepair {

const CLI::App& parsed_command(const CLI::App& app) {
  const auto given = app.get_subcommands();
  return given.empty() ? app : *given.front();
}

namespace {

// The message about the first word that nothing takes; empty if every word is taken.
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
      if (one->nonpositional()) known.push_back(one->get_name());
    const std::string name = option->substr(0, option->find('=')), nearest = nearest_name(name, known);
    if (name.starts_with("--friction") || name.starts_with("--rolling"))
      return fmt::format("there is no option {}: contacts have neither friction nor rotation", name);
    return fmt::format("unknown option {}{} ({} --help lists all)", name,
                       nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest),
                       &command == &app ? "spherepair" : "spherepair " + command.get_name());
  }
  if (left.empty()) return {};
  return fmt::format("'{}' is no option of {}: options begin with --", left.front(), command.get_name());
}

// The two names in "--a MARK --b" of CLI11's message.
std::optional<std::pair<std::string, std::string>> names_around(const std::string& mark, const std::string& message) {
  const size_t at = message.find(mark);
  if (at == message.npos) return std::nullopt;
  return std::pair{message.substr(0, at), message.substr(at + mark.size())};
}

// The option that has too few values or too many.
std::string number_of_values(const CLI::App& command, const std::string& message) {
  for (const CLI::Option* option : command.get_options()) {
    if (!option->nonpositional() || !message.starts_with(option->get_name() + ":")) continue;
    const auto least = uint64_t(option->get_items_expected_min());
    const bool more = option->get_items_expected_max() > option->get_items_expected_min();
    const std::string takes = counted(least, "value") + (more ? " or more" : "");
    const size_t given = message.find("received ");
    const std::string found = given != message.npos ? message.substr(given + 9) : least == 1 ? "none" : "fewer";
    return fmt::format("{} needs {}, but {} {} given", option->get_name(), takes, found,
                       found == "none" ? "was" : "were");
  }
  return message;
}

}  // namespace

std::string complaint_about(const CLI::ParseError& error, const CLI::App& app) {
  const std::string unknown = unknown_word(app), message = error.what(), kind = error.get_name();
  if (!unknown.empty()) return unknown;
  const CLI::App& command = parsed_command(app);
  if (&command == &app && kind == "RequiredError")
    return "no subcommand was given: spherepair --help lists them; spherepair devices is a start";
  if (const auto two = names_around(" excludes ", message); two && kind == "ExcludesError")
    return fmt::format("{} does not go with {}: omit one of the two", two->first, two->second);
  if (const auto two = names_around(" requires ", message); two && kind == "RequiresError")
    return fmt::format("{} has no effect without {}: give both, or omit it", two->first, two->second);
  if (const auto two = names_around(" is required", message); two && kind == "RequiredError")
    return fmt::format("{} needs {}: spherepair {} --help says what it is", command.get_name(), two->first,
                       command.get_name());
  if (const auto two = names_around(" = ", message); two && kind == "ConversionError")
    return fmt::format("{}: '{}' is not made of numbers", two->first.substr(two->first.find("--")), two->second);
  return kind == "ArgumentMismatch" ? number_of_values(command, message) : message;
}

}  // namespace spherepair
