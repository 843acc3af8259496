// SPDX-License-Identifier: MIT
// Checks the columns that a text file is read as, or the reason why it is refused.
#pragma once

#include "tests/bench/sphere_readings.h"

namespace spherepair {

inline const SphereFileOptions sized = {.radius = 0.5f};

inline SphereFileOptions columns(std::vector<std::string> names, std::optional<double> radius = {}) {
  return {.radius = radius, .columns = std::move(names)};
}

// `name` gives the format. Without spheres the file must be refused, with these words and without `unwanted`.
struct FileCase {
  std::string name, text;
  SphereFileOptions options = {};
  std::vector<vec4> spheres = {};
  std::vector<std::string> words = {};
  std::string unwanted = "leave --radius out";
};

inline void expect_case(const FileCase& each) {
  SCOPED_TRACE(each.name + ":\n" + each.text);
  const std::string file = scratch().write(each.name, each.text);
  SphereFile input;
  const std::string complaint = complaint_of([&] { input = read_sphere_file(file, each.options); });
  if (!each.spheres.empty()) {
    EXPECT_EQ(complaint, "");
    expect_spheres(input, each.spheres);
    const std::string said = describe(input);
    for (const std::string& word : each.words) EXPECT_NE(said.find(word), said.npos) << said << "\nhas no " << word;
    return;
  }
  EXPECT_NE(complaint, "") << "is read as " << describe(input);
  for (const std::string& word : each.words)
    EXPECT_NE(complaint.find(word), complaint.npos) << complaint << "\nhas no " << word;
  EXPECT_EQ(complaint.find(each.unwanted), complaint.npos) << complaint;
}

inline void expect_cases(const std::vector<FileCase>& cases) {
  for (const FileCase& each : cases) expect_case(each);
}

}  // namespace spherepair
