// SPDX-License-Identifier: MIT
// The table of numbers in an NPY array.
#pragma once

#include <span>

#include "bench/npy/npy_header.h"
#include "bench/npy/number_table.h"

namespace spherepair {

// Whether a dtype is one of real numbers that are read.
bool is_real_dtype(std::string_view dtype);

// Checks dtypes, shape and size. option: the words of --columns, if given.
NumberTable table_of(const FileBytes& file, const NpyHeader& header, std::span<const std::string> option);

// Of an array of real numbers with two axes; throws for another size of the file.
NumberTable plain_table(const FileBytes& file, const NpyHeader& header, const Columns& columns);

std::string describe(const NumberTable& table, const NpyHeader& header);

}  // namespace spherepair
