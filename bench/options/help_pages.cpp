// SPDX-License-Identifier: MIT
#include "bench/options/help_pages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <regex>

#include "bench/io/context.h"
#include "bench/options/help_format.h"
#include "common/scene/scene.h"

namespace spherepair {
namespace {

constexpr size_t manual_width = 72;

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> names_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    if (!option->get_lnames().empty()) names.push_back("--" + option->get_lnames().front());
  return names;
}

// Escapes a text so that roff sees no requests in it.
std::string roff(const std::string& text) {
  return std::regex_replace(std::regex_replace(text, std::regex(R"([\\-])"), "\\$&"), std::regex("(^|\n)([.'])"),
                            "$1\\&$2");
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::vector<std::string> commands;
  std::string cases;
  for (const CLI::App* command : commands_of(app)) {
    commands.push_back(command->get_name());
    cases += fmt::format("    {}) words='{}' ;;\n", command->get_name(), fmt::join(names_of(*command), " "));
  }
  return fmt::format(
      "# Completion of spherepair for bash: source <(spherepair completion)\n"
      "_spherepair() {{\n"
      "  local words word=${{COMP_WORDS[COMP_CWORD]}}\n"
      "  case ${{COMP_WORDS[1]}} in\n{}"
      "    *) words='{} --help --version' ;;\n"
      "  esac\n"
      "  [ \"$COMP_CWORD\" -gt 1 ] || words='{} --help --version'\n"
      "  case $word in\n"
      "    -*) ;;\n"
      "    *) [ \"$COMP_CWORD\" -eq 1 ] || words= ;;\n"
      "  esac\n"
      "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
      "}}\n"
      "complete -o default -F _spherepair spherepair\n",
      cases, fmt::join(commands, " "), fmt::join(commands, " "));
}

std::string man_page(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH SPHEREPAIR 1 \"\" \"spherepair {}\"\n.SH NAME\nspherepair \\- exact colliding pairs of spheres on CPU and "
      "GPU\n.SH SYNOPSIS\n.B spherepair\n.I command\n[\n.I options\n]\n",
      build_info.version);
  const auto section = [&text](const std::string& title, const std::string& body) {
    text += fmt::format(".SH {}\n.nf\n{}\n.fi\n", title, roff(body));
  };
  const HelpFormat format(manual_width);
  section("COMMANDS", format.make_help(&app, "spherepair", CLI::AppFormatMode::Normal));
  for (const CLI::App* command : commands_of(app))
    section(command->get_name(),
            format.make_help(command, "spherepair " + command->get_name(), CLI::AppFormatMode::Normal));
  std::string scenes;
  for (const SceneKind& kind : scene_kinds()) scenes += fmt::format("{:<14} {}\n", kind.name, kind.summary);
  section("SCENES", wrapped_help(scenes, manual_width));
  return text;
}

}  // namespace spherepair
