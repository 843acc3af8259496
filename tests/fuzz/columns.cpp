// SPDX-License-Identifier: MIT
// Text against a second reading that knows only the plainest files: numbers between single blanks, with or without a
// line of names. What it reads must be read to the same floats, and what it refuses must be refused.
#include <cstdlib>
#include <map>
#include <sstream>
#include <vector>

#include "bench/spheres/sphere_file.h"
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

namespace {

using Row = std::vector<std::string>;

std::vector<Row> rows_of(const std::string& text) {
  std::vector<Row> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    Row row;
    std::istringstream words(line);
    for (std::string word; words >> word;) row.push_back(word);
    if (!row.empty()) rows.push_back(row);
  }
  return rows;
}

bool is_plain_number(const std::string& word) {
  return word.find_first_not_of("0123456789.-") == word.npos && word.find_first_of("0123456789") != word.npos &&
         word.rfind('-') == (word[0] == '-' ? 0 : word.npos) && word.find('.') == word.rfind('.') && word.size() < 30;
}

bool all_numbers(const Row& row) {
  for (const std::string& word : row)
    if (!is_plain_number(word)) return false;
  return true;
}

// The columns of x, y, z and the radius, counted from 0; -1: none, -2: twice.
std::vector<int> places_of(const Row& names) {
  std::map<std::string, int> place;
  for (size_t k = 0; k < names.size(); ++k) place[names[k]] = place.count(names[k]) ? -2 : int(k);
  const auto of = [&](const char* name) { return place.count(name) ? place[name] : -1; };
  const bool colours = place.count("g") && place.count("b");
  int radius = of("radius");
  if (of("r") != -1 && !colours) radius = radius == -1 ? of("r") : -2;
  return {of("x"), of("y"), of("z"), radius};
}

bool only_known_words(const Row& names) {
  for (const std::string& name : names)
    if (std::string(" x y z r g b radius id ").find(" " + name + " ") == std::string::npos) return false;
  return true;
}

// Nothing where the second reading does not know; else whether the file is good, and its numbers.
struct Answer {
  bool good = false;
  std::vector<std::vector<float>> spheres = {};
};
std::optional<Answer> second_reading(const std::string& text) {
  if (text.find_first_not_of("0123456789.- \nxyzrgbadius") != text.npos) return std::nullopt;
  std::vector<Row> rows = rows_of(text);
  if (rows.empty()) return Answer{};
  std::vector<int> places = {0, 1, 2, rows[0].size() == 4 ? 3 : -1};
  size_t count = rows[0].size();
  if (!all_numbers(rows[0])) {
    if (!only_known_words(rows[0])) return std::nullopt;
    places = places_of(rows[0]);
    rows.erase(rows.begin());
  } else if (count != 3 && count != 4) {
    return std::nullopt;  // seven may be colours
  }
  Answer answer;
  for (const int place : places)
    if (place == -2) return answer;
  if (places[0] < 0 || places[1] < 0 || places[2] < 0 || rows.empty()) return answer;
  for (const Row& row : rows) {
    if (row.size() != count) return answer;
    std::vector<float> sphere;
    for (const int place : places) {
      if (place >= 0 && !is_plain_number(row[size_t(place)])) return std::nullopt;
      sphere.push_back(place < 0 ? 0.5f : std::strtof(row[size_t(place)].c_str(), nullptr));
    }
    if (sphere[3] < 0) return answer;
    answer.spheres.push_back(sphere);
  }
  answer.good = true;
  return answer;
}

}  // namespace

FUZZ(columns) {
  const std::string text(text_of(data, size)), file = input_file("columns.txt", text);
  const auto own = unless_refused([&] { return read_sphere_file(file, {.threads = 1}); });
  const auto given = unless_refused([&] { return read_sphere_file(file, {.radius = 0.5f, .threads = 1}); });
  require(!own || !given, "a file has radii and has none");
  const auto answer = second_reading(text);
  if (!answer) return;
  const auto& read = own ? own : given;
  require(answer->good == read.has_value(), "two readings of text differ in whether it is good");
  if (!read) return;
  require(read->scene.size() == answer->spheres.size(), "two readings of text differ in the number of spheres");
  for (size_t k = 0; k < answer->spheres.size(); ++k)
    for (size_t c = 0; c < 4; ++c)
      require((&read->scene.positions[k].x)[c] == answer->spheres[k][c], "two readings of text differ in a number");
}
