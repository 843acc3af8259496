// SPDX-License-Identifier: MIT
// CSV as pandas reads it: the first line names the columns.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace spherepair {

using CsvRow = std::map<std::string, std::string>;

inline std::vector<std::string> csv_fields(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (size_t k = 0; k < line.size(); ++k) {
    if (line[k] == '"' && quoted && line[k + 1] == '"')
      fields.back() += line[++k];
    else if (line[k] == '"')
      quoted = !quoted;
    else if (line[k] == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += line[k];
  }
  EXPECT_FALSE(quoted) << line;
  return fields;
}

inline std::vector<CsvRow> read_csv(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = csv_fields(line);
  EXPECT_EQ(names.size(), (std::set<std::string>(names.begin(), names.end()).size())) << line;
  std::vector<CsvRow> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> fields = csv_fields(line);
    EXPECT_EQ(fields.size(), names.size()) << line;
    CsvRow& row = rows.emplace_back();
    for (size_t k = 0; k < std::min(names.size(), fields.size()); ++k) row[names[k]] = fields[k];
  }
  return rows;
}

// The key of a sample: its row without the time and these columns.
inline std::string csv_key(CsvRow row, const std::vector<std::string>& besides = {}) {
  row.erase("seconds");
  for (const std::string& name : besides) row.erase(name);
  std::string key;
  for (const auto& [name, field] : row) key += name + "=" + field + " ";
  return key;
}

// Expects that no two samples have the same round of the same configuration.
inline void expect_all_told_apart(const std::vector<CsvRow>& rows) {
  std::set<std::string> keys;
  for (const CsvRow& row : rows) EXPECT_TRUE(keys.insert(csv_key(row, {"turn", "batch"})).second) << csv_key(row);
}

}  // namespace spherepair
