// SPDX-License-Identifier: MIT
#include "bench/options/help_format.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "bench/io/numbers.h"
#include "bench/io/report.h"

namespace spherepair {
namespace {

constexpr size_t widest = 100, narrowest = 40;
constexpr size_t column = 30;        // where CLI11's descriptions begin
constexpr size_t too_narrow = 70;    // below this width descriptions go below the names ...
constexpr size_t narrow_column = 8;  // ... at this one

struct Group {
  const char *heading, *options;  // separated by blanks
};
constexpr Group groups[] = {
    {"Spheres of a scene",
     "--scene --n --seed --radius --radius-ratio --packing-fraction --groups --group-size --offset"},
    {"Spheres of a file", "--input --frame --columns --decimal-comma --ignore-periodic --resume --cutoff"},
    {"Motion", "--motion --precision --dt --restitution --gravity --plane --steps --until-step --time --until-rest"},
    {"Contacts", "--contact --stiffness --density --drag --no-sleeping --walls --box --periodic"},
    {"Search", "--backend --backends --method --block --naive --swept"},
    {"Camera and look",
     "--azimuth --elevation --eye --target --up --field --near --size --samples --color --color-range --ground "
     "--no-legend --no-box --plain --draw"},
    {"Results",
     "--output --pairs --contacts --geometry --distances --csr --spheres --save --save-every --statistics "
     "--statistics-every --trajectory --trajectory-every --json --per-step --hashes --quiet --verbose --results "
     "--video --rate --screenshot"},
    {"Devices", "--cuda-device --gl-device --vulkan-device --require-hardware --no-gpu --threads"}};

std::string kind_of_value(const CLI::Option& option) {
  const std::string name = option.get_name(), type = option.get_type_name();
  const auto among = [&](std::initializer_list<const char*> names) { return std::ranges::count(names, name) > 0; };
  if (option.get_expected_max() == 0) return "";
  if (among({"--input", "--resume", "--output", "--pairs", "--contacts", "--spheres", "--save", "--statistics",
             "--trajectory", "--json", "--video", "--screenshot", "left", "right"}))
    return "FILE";
  if (name == "--results") return "FOLDER";
  if (among({"--cuda-device", "--gl-device", "--vulkan-device"})) return "ID";
  if (type.starts_with("UINT") || type.starts_with("INT")) return "N";
  return type.starts_with("FLOAT") ? "X" : "NAME";
}

// The values of an option and its default: " FILE", " N=16384", empty for a flag.
std::string values_of(const CLI::Option& option) {
  std::string text = kind_of_value(option);
  if (text.empty()) return "";
  if (option.get_expected_max() > 1) text += ",...";
  if (!option.get_default_str().empty()) text += "=" + option.get_default_str();
  return " " + text + (option.get_required() ? " (needed)" : "");
}

size_t terminal_width() {
  if (const char* columns = std::getenv("COLUMNS"))
    if (const auto width = whole_number_of(columns, 1, 100000)) return std::clamp<size_t>(*width, narrowest, widest);
  winsize size{};
  if (!isatty(STDOUT_FILENO) || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return widest;
  return std::clamp<size_t>(size.ws_col, narrowest, widest);
}

// Breaks a line between words; indents the first line by `first` spaces and the others by `next`.
std::string broken(const std::string& text, size_t first, size_t next, size_t width) {
  return wrapped(text, std::string(first, ' '), std::string(next, ' '), width) + "\n";
}

// Breaks a line of one column, or of two columns, which two blanks separate.
std::string wrapped_line(const std::string& line, size_t width) {
  const bool narrow = width < too_narrow;
  const size_t start = std::min(line.find_first_not_of(' '), line.size()), gap = line.find("  ", start);
  const size_t second = gap == line.npos ? gap : line.find_first_not_of(' ', gap);
  const size_t indent = narrow && start >= column ? narrow_column : start;
  if (second == line.npos) return broken(line.substr(start), indent, start == 2 ? column : indent, width);
  if (narrow) {
    const size_t below = std::max(narrow_column, indent + 2);
    return broken(line.substr(start, gap - start), indent, indent, width) +
           broken(line.substr(second), below, below, width);
  }
  return line.substr(0, second) + broken(line.substr(second), second, second, width).substr(second);
}

}  // namespace

std::string wrapped_help(const std::string& help, size_t width) {
  std::istringstream lines(help);
  std::string out;
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(' ') != line.npos)
      out += wrapped_line(line, width);
    else if (!out.ends_with("\n\n"))
      out += "\n";
  return out;
}

void group_options(CLI::App& command) {
  for (const Group& group : groups)
    for (const std::string& name : CLI::detail::split(group.options, ' '))
      if (CLI::Option* option = command.get_option_no_throw(name)) option->group(group.heading);
  if (!command.get_option_no_throw("--scene") && command.get_option_no_throw("--columns"))
    command.get_option("--radius")->group("Spheres of a file");
}

std::string HelpFormat::make_option_opts(const CLI::Option* option) const { return values_of(*option); }

std::string HelpFormat::make_option(const CLI::Option* option, bool is_positional) const {
  if (!is_positional || !option->nonpositional()) return CLI::Formatter::make_option(option, is_positional);
  std::ostringstream line;
  CLI::detail::format_help(line, make_option_name(option, true), "The same as " + make_option_name(option, false),
                           get_column_width());
  return line.str();
}

std::string HelpFormat::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  return wrapped_help(CLI::Formatter::make_help(app, std::move(name), mode), width_ ? width_ : terminal_width());
}

}  // namespace spherepair
