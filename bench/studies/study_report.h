// SPDX-License-Identifier: MIT
// Writes the page of tables of a study, and every sample as CSV.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "bench/measure/samples.h"

namespace spherepair {

// The same cell as for Samples, from a record's entry.
std::string time_cell(const json& entry, double in_second = in_ms);

// A row for each sample of each entry, found in lists and objects at any depth; an object of lists adds a column with
// their names. The first columns have the configuration. Then:
//   contender, backend   of the sample
//   timer       host: a round's sample; device: the median of a kernel on the device's timer, taken in a run of its own
//   kernel, round, turn, batch   the kernel where the timer is the device's; else the sample's number, its place among
//               all turns, and K
//   seconds     the time of one step of the contender
std::string samples_csv(const json& records);

std::string csv_of(const Table& table);

// The tables as text, without those that only the CSV has, with blank lines between them.
std::string text_of(const std::vector<Table>& tables, size_t width);

// The text of tables and sentences, at most this wide.
using Page = std::function<std::string(size_t width)>;

// Writes NAME.txt from the page, and this text as NAME.csv.
void write_page(const std::filesystem::path& folder, const std::string& name, const Page& page, const std::string& csv);

// Prints the page of a study, and writes it and all samples to files.
void report_page(const std::filesystem::path& folder, const std::string& name, const Page& page, const json& records);
std::vector<std::string> files_of_study(const std::string& name);  // NAME.json and the page's files

}  // namespace spherepair
