// SPDX-License-Identifier: MIT
// The original paper's Table 1 as printed.
#pragma once

#include <algorithm>
#include <cstdint>

namespace spherepair {

// Milliseconds on a GeForce GTX 590 and its host, from the paper's Table 1 and section 6. It prints 0 below the
// resolution of its clock and has no sequential row for 32,768 spheres.
struct PaperRow {
  uint64_t n;
  const char *fps, *sequential_drawing, *parallel_drawing, *plane, *sequential_pairs, *parallel_pairs;
};
constexpr PaperRow paper_rows[] = {
    {64, "60", "0", "0", "0", "0", "16"},         {128, "60", "1", "0", "0", "0", "16"},
    {256, "61", "2", "0", "0", "0", "16"},        {512, "62", "3", "0", "0.5", "5", "16"},
    {1024, "36", "8", "0", "1", "23", "16"},      {2048, "12", "15", "0", "2", "87", "16"},
    {4096, "4", "32", "0", "3", "340", "16"},     {8192, "4", "60", "0", "7", "1390", "16"},
    {16384, "4", "120", "0", "13", "5560", "16"}, {32768, "-", "-", "-", "-", "-", "47"}};

inline PaperRow paper_row(uint64_t n) {
  const auto* found = std::ranges::find(paper_rows, n, &PaperRow::n);
  return found == std::end(paper_rows) ? PaperRow{n, "-", "-", "-", "-", "-", "-"} : *found;
}

}  // namespace spherepair
