// SPDX-License-Identifier: MIT
// What is printed for people: tables and sentences within a terminal's 80 columns, and counts with their noun.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "bench/io/report.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Groups of `columns` columns of 10 digits, after a name.
Table wide(size_t groups, size_t columns) {
  Table table{"Title", {{"", "name", "", true}}, {{"row"}}, {}};
  for (size_t g = 0; g < groups; ++g)
    for (size_t c = 0; c < columns; ++c) {
      table.columns.push_back({"group " + std::to_string(g), "c" + std::to_string(c), "ms"});
      table.rows.front().push_back(std::to_string(1'000'000'000 + 10 * g + c));
    }
  return table;
}

TEST(Report, WideTablesAreSplitBetweenGroups) {
  const std::string text = wide(4, 3).text();
  size_t heads = 0, rows = 0;
  for (const std::string& line : lines_of(text)) {
    EXPECT_LE(line.size(), kTextWidth) << line;
    heads += line.starts_with("name");
    rows += line.starts_with("row");
  }
  EXPECT_EQ(heads, 2u) << text;
  EXPECT_EQ(rows, 2u) << text;
  for (const char* cell : {"1000000000", "1000000012", "1000000020", "1000000032"})
    EXPECT_EQ(text.find(cell), text.rfind(cell)) << cell << " stands once\n" << text;
  EXPECT_NE(text.find("1000000032"), std::string::npos);
}

TEST(Report, AGroupThatIsTooWideAloneIsSplitToo) {
  const std::string text = wide(1, 9).text();
  for (const std::string& line : lines_of(text)) EXPECT_LE(line.size(), kTextWidth) << line;
  EXPECT_NE(text.find("1000000008"), std::string::npos) << text;
}

TEST(Report, NarrowTablesStayWhole) {
  EXPECT_EQ(wide(2, 1).text(),
            "Title\n"
            "      -group 0--  -group 1--\n"
            "name          c0          c0\n"
            "              ms          ms\n"
            "----------------------------\n"
            "row   1000000000  1000000010\n");
}

TEST(Report, AFileHasInOneWhatATerminalHasInParts) {
  const auto heads = [](size_t width) {
    return std::ranges::count_if(lines_of(wide(3, 3).text(width)),
                                 [](const auto& line) { return line.starts_with("name"); });
  };
  EXPECT_EQ(heads(kTextWidth), 2);
  EXPECT_EQ(heads(kFileWidth), 1);
}

TEST(Report, ColumnsWithoutAValueAreLeftOut) {
  Table table = wide(3, 1);
  table.rows = {{"a", "-", "1", "-"}, {"b", "", "2", "3"}};
  EXPECT_EQ(table.text(),
            "Title\n"
            "      group 1  group 2\n"
            "name       c0       c0\n"
            "           ms       ms\n"
            "----------------------\n"
            "a           1        -\n"
            "b           2        3\n");
  EXPECT_EQ(table.to_json().at("columns").size(), 4u) << "the record keeps them";
  table.rows = {};
  EXPECT_NE(table.text().find("group 0"), std::string::npos) << "without rows no column has a value";
}

TEST(Report, APartHasTheRowsThatHaveAValueInIt) {
  Table table = wide(3, 3);
  std::vector<std::string> row = table.rows.front();
  row.front() = "later";
  for (size_t c = 1; c <= 6; ++c) row[c] = "-";
  table.rows.push_back(row);
  const auto count = [](const std::string& text) {
    return std::ranges::count_if(lines_of(text), [](const auto& line) { return line.starts_with("later"); });
  };
  EXPECT_EQ(count(table.text(kTextWidth)), 1);
  EXPECT_NE(table.text(kTextWidth).find("later  1000000020"), std::string::npos) << table.text(kTextWidth);
  EXPECT_EQ(count(table.text(kFileWidth)), 1);
}

TEST(Report, IntervalsAreExplained) {
  Table table = wide(1, 1);
  EXPECT_EQ(table.text().find("95 %"), std::string::npos);
  table.rows = {{"a", "1.2 [1.1, 1.3]"}};
  EXPECT_NE(table.text().find("* [low, high]: the 95 % interval of the median.\n"), std::string::npos);
}

TEST(Report, NotesAreWrapped) {
  Table table = wide(1, 1);
  std::string note;
  for (int k = 0; k < 60; ++k) note += "word ";
  table.notes = {note};
  for (const std::string& line : lines_of(table.text())) EXPECT_LE(line.size(), kTextWidth) << line;
  EXPECT_EQ(wrapped("a b c", "* ", "  ", 5), "* a b\n  c");
}

TEST(Report, CountsHaveTheirNoun) {
  EXPECT_EQ(counted(0, "sphere"), "0 spheres");
  EXPECT_EQ(counted(1, "sphere"), "1 sphere");
  EXPECT_EQ(counted(2, "sphere"), "2 spheres");
  EXPECT_EQ(counted(1, "search", "searches"), "1 search");
  EXPECT_EQ(counted(2, "search", "searches"), "2 searches");
}

}  // namespace
}  // namespace spherepair
