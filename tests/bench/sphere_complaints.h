// SPDX-License-Identifier: MIT
// Checks the messages of sphere readers about bad files.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/sphere_files.h"

namespace spherepair {

// Expects a message that begins with the file and the place.
inline void expect_complaint(const std::string& name, const std::string& bytes, const std::string& place,
                             const std::string& expected, const std::string& found, const SphereFileOptions& options) {
  const ScratchFolder folder;
  const std::string file = folder.write(name, bytes);
  const std::string complaint = complaint_of([&] { read_sphere_file(file, options); });
  EXPECT_TRUE(complaint.starts_with(file + ", " + place + ": expected ")) << complaint << "\nis not about " << place;
  EXPECT_NE(complaint.find(expected), std::string::npos) << complaint << "\ndoes not expect " << expected;
  EXPECT_NE(complaint.find("found " + found), std::string::npos) << complaint << "\nhas not found " << found;
}
inline void expect_npy_complaint(const std::string& bytes, uint64_t byte, const std::string& expected,
                                 const std::string& found, const SphereFileOptions& options = {.radius = 1}) {
  expect_complaint("bad.npy", bytes, fmt::format("byte {}", byte), expected, found, options);
}
inline void expect_xyz_complaint(const std::string& text, uint64_t line, const std::string& expected,
                                 const std::string& found, const SphereFileOptions& options = {.radius = 1}) {
  expect_complaint("bad.xyz", text, fmt::format("line {}", line), expected, found, options);
}

}  // namespace spherepair
