// SPDX-License-Identifier: MIT
// Splits lines of text into fields.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace spherepair {

// The text without blanks and tabs at both ends.
std::string_view trimmed(std::string_view text);

std::string lower_case(std::string_view text);  // ASCII

// Splits at blanks and tabs into at most `most` fields; overwrites `fields`.
void split_fields(std::string_view text, size_t most, std::vector<std::string_view>& fields);

std::vector<std::string> words_in(std::string_view text);  // all fields

// The separator of a file, from its first line: ; or , outside double quotes, else blanks and tabs (' '). With decimal
// commas a comma is no separator.
char separator_of(std::string_view line, bool decimal_comma);

// Splits at a separator outside double quotes, and removes the quotes; overwrites `fields`.
void split_line(std::string_view text, char separator, std::vector<std::string_view>& fields);

// The line up to the first # outside double quotes.
std::string_view without_comment(std::string_view line);

// The names in a line of names. `x [mm] y [mm]` has two: a unit in brackets belongs to the name before it.
std::vector<std::string> names_in(std::string_view line, char separator);

}  // namespace spherepair
