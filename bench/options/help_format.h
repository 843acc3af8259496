// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace spherepair {

// Breaks help between words so that no line is longer than `width`, and indents continuation lines like their column.
std::string wrapped_help(const std::string& help, size_t width);

// Puts each option under the heading of its subject.
void group_options(CLI::App& command);

// CLI11's help in lines of at most 100 columns, or the width of the terminal or COLUMNS. It shows the values and
// defaults of options. It does not list excluded options: errors name them.
class HelpFormat : public CLI::Formatter {
 public:
  explicit HelpFormat(size_t width = 0) : width_(width) {}  // 0: the terminal's
  // A positional argument that is also an option refers to the option's description.
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_option_opts(const CLI::Option* option) const override;

 private:
  size_t width_;
};

}  // namespace spherepair
