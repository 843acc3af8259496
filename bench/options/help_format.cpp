// SPDX-License-Identifier: MIT
#include "bench/options/help_format.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include "bench/io/report.h"

namespace spherepair {
namespace {

constexpr size_t widest = 100, narrowest = 40;
constexpr size_t column = 30;        // CLI11's, of the descriptions
constexpr size_t too_narrow = 70;    // for two columns: descriptions go below the names ...
constexpr size_t narrow_column = 8;  // ... at this one

size_t terminal_width() {
  winsize size{};
  if (!isatty(STDOUT_FILENO) || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return widest;
  return std::clamp<size_t>(size.ws_col, narrowest, widest);
}

// The words of a line, the first after `first` spaces and those of further lines after `next`.
std::string broken(const std::string& text, size_t first, size_t next, size_t width) {
  return wrapped(text, std::string(first, ' '), std::string(next, ' '), width) + "\n";
}

std::string wrapped_line(const std::string& line, size_t width) {
  const size_t start = std::min(line.find_first_not_of(' '), line.size());
  const bool narrow = width < too_narrow;
  const bool two_columns = start == 2 && line.size() > column && line[column - 1] == ' ' && line[column] != ' ';
  if (two_columns && narrow)
    return broken(line.substr(0, column), start, start, width) +
           broken(line.substr(column), narrow_column, narrow_column, width);
  const size_t indent = narrow && start >= column ? start - column + narrow_column : start;
  if (line.size() <= width && indent == start) return line + "\n";
  const size_t gap = line.find("  ", start);  // before the second column, also of a list within a description
  if (gap != line.npos && !narrow) {
    const size_t second = std::min(line.find_first_not_of(' ', gap), line.size());
    const std::string rest = broken(line.substr(second), second, second, width);
    return line.substr(0, second) + rest.substr(second);
  }
  return broken(line.substr(start), indent, start == 2 ? column : indent, width);
}

}  // namespace

std::string wrapped_help(const std::string& help, size_t width) {
  std::istringstream lines(help);
  std::string out;
  for (std::string line; std::getline(lines, line);)
    out += line.find_first_not_of(' ') == line.npos ? "\n" : wrapped_line(line, width);
  return out;
}

std::string HelpFormat::make_option(const CLI::Option* option, bool is_positional) const {
  if (!is_positional || !option->nonpositional()) return CLI::Formatter::make_option(option, is_positional);
  std::ostringstream line;
  CLI::detail::format_help(line, make_option_name(option, true), "The same as " + make_option_name(option, false),
                           get_column_width());
  return line.str();
}

std::string HelpFormat::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  return wrapped_help(CLI::Formatter::make_help(app, std::move(name), mode), terminal_width());
}

}  // namespace spherepair
