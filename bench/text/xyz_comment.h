// SPDX-License-Identifier: MIT
// Parses the comment line of extended XYZ: key=value pairs (github.com/libAtoms/extxyz, "Extended XYZ specification").
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherepair {

// A key without a value is a flag. A value is a word, or stands in quotes, brackets or braces, which are removed.
// Within double quotes \n is a line feed, and \ before another character is that character.
struct CommentPair {
  std::string key = {};
  std::optional<std::string> value = {};
  bool complete = true;  // false: no value after =, or its quotes or brackets do not end
};

// The pairs in their order. Skips text that the grammar does not allow, one character at a time.
std::vector<CommentPair> parse_comment(std::string_view comment);

// True or false as the specification writes them, or 1 or 0; else none.
std::optional<bool> parse_boolean(std::string_view text);

// Whether a comment has a word for a periodic box, such as `cell` or `box`.
bool mentions_box(std::string_view comment);

}  // namespace spherepair
