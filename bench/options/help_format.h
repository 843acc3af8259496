// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace spherepair {

// Breaks help between words so that no line is longer than `width`, and indents what follows as what it belongs to.
std::string wrapped_help(const std::string& help, size_t width);

// Puts each option under the heading of what it is about.
void group_options(CLI::App& command);

// CLI11's help in lines of at most 100 columns, or as many as the terminal or COLUMNS has. Of options, it shows what
// they take and their default; what they exclude is said where it is tried.
class HelpFormat : public CLI::Formatter {
 public:
  explicit HelpFormat(size_t width = 0) : width_(width) {}  // 0: the terminal's
  // A positional argument that is also an option refers to that for its description.
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_option_opts(const CLI::Option* option) const override;

 private:
  size_t width_;
};

}  // namespace spherepair
