// SPDX-License-Identifier: MIT
#include "bench/options/help_pages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/io/context.h"
#include "bench/options/help_format.h"
#include "common/scene/scene.h"

namespace spherepair {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> names_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    if (!option->get_lnames().empty()) names.push_back("--" + option->get_lnames().front());
  return names;
}

// Text in which roff sees no requests.
std::string roff(const std::string& text) {
  std::string out = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if (c == '\n')
      out += out.ends_with('\n') ? "" : "\n.br\n";
    else
      out += c;
  }
  return out;
}

std::string options_text(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options())
    text += fmt::format(".TP\n.B {}{}\n{}\n",
                        roff(option->get_lnames().empty() ? option->get_name() : option->get_name(false, true)),
                        roff(values_of(*option)), roff(option->get_description()));
  return text;
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
      "GPU\n"
      ".SH SYNOPSIS\n.B spherepair\n.I command\n[\n.I options\n]\n.SH DESCRIPTION\n{}\n.SH COMMANDS\n",
      build_info.version, roff(app.get_description()));
  for (const CLI::App* command : commands_of(app))
    text += fmt::format(".TP\n.B {}\n{}\n", roff(command->get_name()), roff(command->get_description()));
  for (const CLI::App* command : commands_of(app))
    text += fmt::format(".SH OPTIONS OF {}\n{}", roff(command->get_name()), options_text(*command));
  text += ".SH SCENES\n";
  for (const SceneKind& kind : scene_kinds())
    text += fmt::format(".TP\n.B {}\n{}\n", roff(kind.name), roff(kind.summary));
  return text + fmt::format(".SH NOTES\n{}\n", roff(app.get_footer()));
}

}  // namespace spherepair
