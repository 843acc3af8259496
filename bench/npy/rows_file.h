// SPDX-License-Identifier: MIT
// Writes rows of numbers, by the file's extension as NPY (C order) or text. Replaces the file atomically.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/io/output_files.h"

namespace spherepair {

constexpr size_t rows_at_a_time = 65536;

// Appends the rows from `first` to `last` as text.
using Rows = std::function<void(fmt::memory_buffer& text, size_t first, size_t last)>;
using Sink = std::function<void(std::string_view)>;

std::string lower_extension(const std::string& file);  // .npy

// Throws std::invalid_argument if `file` has none of the extensions; the message names `option` and `known`. Pipes and
// devices may have any name: they get text.
void check_rows_file(const std::string& option, const std::string& file, const std::vector<std::string>& extensions,
                     const std::string& known);

// The header of an NPY 1.0 file. @ in the dtype stands for the byte order.
std::string npy_head(std::string dtype, const std::string& shape);

// Writes a .npy or .vtp file by write_binary, and any other as text: `head`, then the rows. -: text to standard output.
void write_rows(const std::string& file, size_t count, const Rows& rows,
                const std::function<void(const Sink&)>& write_binary, const std::string& head = "");

template <typename Number>
std::string_view bytes_of(std::span<const Number> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

}  // namespace spherepair
