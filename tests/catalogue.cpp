// SPDX-License-Identifier: MIT
#include "catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <regex>

#include "files.h"
#include "report.h"

namespace spherepair {
namespace {

// What each row must show, by number; a test may note its own bound.
constexpr std::array<const char*, 34> bounds = {"",
                                                "0 wrong against an exact oracle",
                                                "0 wrong",
                                                "every one a tie, 0 collisions",
                                                "0 wrong",
                                                "0 wrong",
                                                "0 wrong, no NaN",
                                                "0 wrong, many-word stage on 25 %",
                                                "0 collisions, all counted",
                                                "exact count, 0 collisions at offset 0",
                                                "0 missed",
                                                "n(n-1)/2 collisions",
                                                "right set",
                                                "0 collisions",
                                                "exact set",
                                                "equal sets; filter decides 99.9999 %",
                                                "identical set",
                                                "exact set of the moved floats",
                                                "identical set and state per id",
                                                "identical bits",
                                                "identical set",
                                                "",
                                                "",
                                                "",
                                                "",
                                                "",
                                                "",
                                                "",
                                                "equal bits, no slow-down > 2",
                                                "equal hashes",
                                                "same bits as uninterrupted",
                                                "right set",
                                                "set equals all pairs",
                                                "right, no access out of range"};

std::string property(const testing::TestResult& result, const std::string& key) {
  for (int k = 0; k < result.test_property_count(); ++k)
    if (result.GetTestProperty(k).key() == key) return result.GetTestProperty(k).value();
  return {};
}

// SweptFindsWhat -> Swept finds what
std::string words_of(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (std::isupper(c) && !text.empty())
      text += ' ', text += char(std::tolower(c));
    else
      text += c;
  }
  return text;
}

std::vector<std::string> parts_of(std::string figures) {
  std::vector<std::string> parts;
  for (size_t end; (end = figures.find("; ")) != std::string::npos; figures.erase(0, end + 2))
    parts.push_back(figures.substr(0, end));
  parts.push_back(figures);
  return parts;
}

}  // namespace

void note_figure(const std::string& figure, const std::string& bound) {
  const testing::TestResult& so_far = *testing::UnitTest::GetInstance()->current_test_info()->result();
  const auto joined = [&](const char* key, const std::string& value) {
    const std::string before = property(so_far, key);
    testing::Test::RecordProperty(key, before.empty() || before == value ? value : before + "; " + value);
  };
  joined("figure", figure);
  joined("bound", bound);
}

void CatalogueListener::OnTestEnd(const testing::TestInfo& info) {
  static const std::regex pattern("Row(\\d+)_(\\w+?)(/(\\w+))?");
  std::smatch match;
  const std::string name = info.name();
  if (!std::regex_match(name, match, pattern)) return;
  const testing::TestResult& result = *info.result();
  const std::string verdict = result.Skipped() ? "skipped" : result.Passed() ? "pass" : "FAIL";
  const int number = std::stoi(match[1]);
  std::string bound = property(result, "bound");
  if (bound.empty() && number < int(bounds.size())) bound = bounds[size_t(number)];
  const std::string backend = match[4].matched ? match[4].str() : "all";
  rows_.push_back({number, words_of(match[2]), backend, property(result, "figure"), bound, verdict,
                   double(result.elapsed_time()) * 1e-3});
}

void CatalogueListener::OnTestProgramEnd(const testing::UnitTest&) {
  const char* folder = std::getenv("SPHEREPAIR_RECORD");
  if (!folder || rows_.empty()) return;
  std::ranges::stable_sort(rows_, {}, &Row::number);
  Table table{"The stress catalogue",
              {{"", "row", ""},
               {"", "what", "", true},
               {"", "backend", "", true},
               {"", "figure", "", true},
               {"", "bound", "", true},
               {"", "", "", true},
               {"", "time", "s"}},
              {},
              {}};
  json list = json::array();
  for (const Row& row : rows_) {
    const std::vector<std::string> figures = parts_of(row.figure);
    table.rows.push_back({std::to_string(row.number), row.name, row.backend, figures.front(), row.bound, row.verdict,
                          fmt::format("{:.1f}", row.seconds)});
    for (size_t k = 1; k < figures.size(); ++k) table.rows.push_back({"", "", "", figures[k], "", "", ""});
    list.push_back({{"row", row.number},
                    {"what", row.name},
                    {"backend", row.backend},
                    {"figure", row.figure},
                    {"bound", row.bound},
                    {"verdict", row.verdict},
                    {"seconds", row.seconds}});
  }
  std::filesystem::create_directories(folder);
  write_file(std::filesystem::path(folder) / "stress.txt", table.text());
  write_file(std::filesystem::path(folder) / "stress.json",
             json_text({{"format", "spherepair stress 1"}, {"rows", list}}));
}

}  // namespace spherepair
