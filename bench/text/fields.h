// SPDX-License-Identifier: MIT
// The fields of a line of text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace spherepair {

// Without blanks and tabs at both ends.
std::string_view trimmed(std::string_view text);

std::string lower_case(std::string_view text);  // ASCII

// Splits at blanks and tabs into at most `most` fields; overwrites `fields`.
void split_fields(std::string_view text, size_t most, std::vector<std::string_view>& fields);

std::vector<std::string> words_in(std::string_view text);  // the same, all of them

// The separator of a file whose first line this is: ; or , outside double quotes, else blanks and tabs (' '). A comma
// separates nothing where it is the decimal comma.
char separator_of(std::string_view line, bool decimal_comma);

// Splits at a separator outside double quotes, which it takes off; overwrites `fields`.
void split_line(std::string_view text, char separator, std::vector<std::string_view>& fields);

// A line up to the first # outside double quotes.
std::string_view without_comment(std::string_view line);

// The names in a line of them. Of `x [mm] y [mm]` two: a unit in brackets belongs to the name before it.
std::vector<std::string> names_in(std::string_view line, char separator);

}  // namespace spherepair
