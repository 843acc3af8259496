// SPDX-License-Identifier: MIT
// The comment line of extended XYZ: key=value pairs (github.com/libAtoms/extxyz, "Extended XYZ specification").
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherepair {

// A key without a value is a flag. A value stands in quotes, brackets or braces, which are taken off, or is a word.
// Within double quotes \n is a line feed, and \ before another character that character.
struct CommentPair {
  std::string key = {};
  std::optional<std::string> value = {};
  bool complete = true;  // false: no value behind =, or one whose quotes or brackets do not end
};

// In their order. What the grammar does not allow is passed over, a character at a time.
std::vector<CommentPair> parse_comment(std::string_view comment);

// True, false, or none of the two, as the specification writes them, and 1 and 0.
std::optional<bool> parse_boolean(std::string_view text);

// Whether a comment has a word for a periodic box, such as `cell` or `box`.
bool mentions_box(std::string_view comment);

}  // namespace spherepair
