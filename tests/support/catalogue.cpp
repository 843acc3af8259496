// SPDX-License-Identifier: MIT
#include "tests/support/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <regex>

#include "bench/formats/files.h"
#include "bench/io/context.h"
#include "bench/io/report.h"

namespace spherepair {
namespace {

// What each row sets up and must show, from row 1; a test may note its own bound.
struct Entry {
  const char *scene, *bound;
};
constexpr std::array<Entry, 33> entries = {
    {{"random bit patterns, all exponents", "0 wrong against an exact oracle"},
     {"pairs within 8 ulp of touching, in boxes of 8 to 1e6 m", "0 wrong"},
     {"Pythagorean quadruples, 2^-149 to 2^100", "every one a tie, 0 collisions"},
     {"the same, one input 1 ulp off", "0 wrong"},
     {"all numbers denormal", "0 wrong"},
     {"squares around the largest float and underflow", "0 wrong, no NaN"},
     {"tangent along an axis, offsets of 2^-140", "0 wrong, many-word stage on 25 %"},
     {"not finite in any of the 8 inputs", "0 collisions, all counted"},
     {"cubic lattice, spacing 2r", "exact count, 0 collisions at offset 0"},
     {"cubic lattice, spacing 2r(1 - 2^-24)", "0 missed"},
     {"all centres at one point", "n(n-1)/2 collisions"},
     {"all spheres in one cell", "right set"},
     {"one sphere a cell, none touching", "0 collisions"},
     {"radii 1e-3 to 1e2 in one scene", "exact set"},
     {"packing fractions 0.3, 0.5, 0.64", "equal sets; filter decides 99.9999 %"},
     {"a lattice of eighths moved by integers", "identical set"},
     {"a float scene moved by 1e3 to 1e6", "exact set of the moved floats"},
     {"shuffled input", "identical set and state per id"},
     {"groups of 32 to 1024, any number of threads", "identical bits"},
     {"axes permuted and mirrored", "identical set"},
     {"free fall of 10 s", ""},
     {"bouncing 10 s, dt 2^-4 to 2^-14 s", ""},
     {"bouncing 10^6 steps, e = 1", ""},
     {"1000 s at e = 0, 0.5, 0.9", ""},
     {"dt = 0.1, 1 and 10 s", ""},
     {"fast spheres", ""},
     {"1e5 to 1e7 m from the origin", ""},
     {"velocities decaying through denormals", "equal bits, no slow-down > 2"},
     {"long runs", "equal hashes"},
     {"saved at step 500 of 1000, resumed", "same bits as uninterrupted"},
     {"one sphere 1e9 m from a cluster", "right set"},
     {"centres on the borders of cells", "set equals all pairs"},
     {"n = 0, 1, 2, group size +- 1, 65535 * 64 + 1", "right, no access out of range"}}};

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

std::string figure_of(const testing::TestResult& result) {
  std::string figure = property(result, "figure");
  for (const char* what : {"answers", "states"})
    if (const std::string count = property(result, what); !count.empty())
      figure += fmt::format("{}{} {} compared", figure.empty() ? "" : "; ", count, what);
  return figure;
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
  if (!bound.empty()) joined("bound", bound);
}

void count_figure(const std::string& what) {
  const testing::TestResult& so_far = *testing::UnitTest::GetInstance()->current_test_info()->result();
  const std::string before = property(so_far, what);
  testing::Test::RecordProperty(what, before.empty() ? 1 : std::stoi(before) + 1);
}

void CatalogueListener::OnTestEnd(const testing::TestInfo& info) {
  static const std::regex pattern("Row(\\d+)_(\\w+?)(/(\\w+))?");
  std::smatch match;
  const std::string name = info.name();
  if (!std::regex_match(name, match, pattern)) return;
  const testing::TestResult& result = *info.result();
  const std::string verdict = result.Skipped() ? "skipped" : result.Passed() ? "pass" : "FAIL";
  const int number = std::stoi(match[1]);
  const Entry& entry = entries.at(size_t(number) - 1);
  const std::string bound = property(result, "bound");
  const std::string backend = match[4].matched ? match[4].str() : "all";
  rows_.push_back({number, words_of(match[2]), entry.scene, backend, figure_of(result),
                   bound.empty() ? entry.bound : bound, verdict, double(result.elapsed_time()) * 1e-3});
}

void CatalogueListener::OnTestProgramEnd(const testing::UnitTest&) {
  const char* folder = std::getenv("SPHEREPAIR_RECORD");
  if (!folder || rows_.empty()) return;
  std::ranges::stable_sort(rows_, {}, &Row::number);
  Table table{"The stress catalogue",
              {{"", "row", ""},
               {"", "scene", "", true},
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
    table.rows.push_back({std::to_string(row.number), row.scene, row.name, row.backend, figures.front(), row.bound,
                          row.verdict, fmt::format("{:.1f}", row.seconds)});
    for (size_t k = 1; k < figures.size(); ++k) table.rows.push_back({"", "", "", "", figures[k], "", "", ""});
    list.push_back({{"row", row.number},
                    {"scene", row.scene},
                    {"what", row.name},
                    {"backend", row.backend},
                    {"figure", row.figure},
                    {"bound", row.bound},
                    {"verdict", row.verdict},
                    {"seconds", row.seconds}});
  }
  std::filesystem::create_directories(folder);
  write_file(std::filesystem::path(folder) / "stress.txt", table.text());
  write_file(
      std::filesystem::path(folder) / "stress.json",
      json_text({{"format", "spherepair stress 1"}, {"context", capture_context(command_line_)}, {"rows", list}}));
}

}  // namespace spherepair
