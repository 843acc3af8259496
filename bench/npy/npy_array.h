// SPDX-License-Identifier: MIT
// Finds the table of numbers in an NPY array.
#pragma once

#include <span>

#include "bench/npy/npy_header.h"
#include "bench/npy/number_table.h"

namespace spherepair {

// Whether this is a dtype of real numbers that we can read.
bool is_real_dtype(std::string_view dtype);

// Checks dtypes, shape and size. option: the words of --columns, if given.
NumberTable table_of(const FileBytes& file, const NpyHeader& header, std::span<const std::string> option);

// The table of an array of real numbers with two axes. Throws if the file has another size.
NumberTable plain_table(const FileBytes& file, const NpyHeader& header, const Columns& columns);

std::string describe(const NumberTable& table, const NpyHeader& header);

}  // namespace spherepair
