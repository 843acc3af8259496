// SPDX-License-Identifier: MIT
// Runs the command `pairs` on a file of spheres whose pairs are known.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "bench/cli/commands.h"
#include "bench/output/pair_file.h"
#include "tests/oracle/oracle.h"
#include "tests/support/backends.h"
#include "tests/support/program.h"
#include "tests/support/sphere_files.h"

namespace spherepair {

namespace fs = std::filesystem;

inline const std::vector<vec4>& spheres() {
  static const std::vector<vec4> all = make_scene({.name = "clustered", .n = 1500, .radius_ratio = 8}).positions;
  return all;
}

inline std::string xyz_of(const std::vector<vec4>& all) {
  std::string text = fmt::format("{}\nProperties=species:S:1:pos:R:3:radius:R:1\n", all.size());
  for (const vec4& s : all)  // all digits: decimals are read as float64
    text += fmt::format("Ar {} {} {} {}\n", double(s.x), double(s.y), double(s.z), double(s.w));
  return text;
}

inline std::string text_of(const std::vector<Pair>& pairs) {
  std::string text = "# i j\n";
  for (const Pair& pair : pairs) text += fmt::format("{} {}\n", pair.first, pair.second);
  return text;
}

class PairsCommand : public testing::Test {
 protected:
  PairsOptions options(const std::string& output) const {
    return {.backend = "cpu",
            .method = "",
            .input_file = input_,
            .output_file = output == "-" ? output : folder_.path(output),
            .json_file = "",
            .contacts_file = "",
            .radius = {},
            .frame = {},
            .columns = {}};
  }

  std::string run(const PairsOptions& options) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const std::string complaint = complaint_of([&] { EXPECT_EQ(pairs_command({{"test"}, {}}, options), kOk); });
    output_ = testing::internal::GetCapturedStdout();
    errors_ = testing::internal::GetCapturedStderr();
    return complaint;
  }

  // Runs the program and returns its exit code; its output goes to output_ and errors_.
  int run_program(const std::string& arguments, const std::string& before = "") {
    const std::string command = fmt::format("{} '{}' {} >'{}' 2>'{}'", before, SPHEREPAIR_PROGRAM, arguments,
                                            folder_.path("out"), folder_.path("err"));
    const int status = std::system(command.c_str());
    output_ = read_bytes(folder_.path("out"));
    errors_ = read_bytes(folder_.path("err"));
    fs::remove(folder_.path("out"));
    fs::remove(folder_.path("err"));
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  const ScratchFolder folder_;
  const std::string input_ = folder_.write("spheres.xyz", xyz_of(spheres()));
  const std::vector<Pair> expected_ = brute_force_pairs(spheres());
  std::string output_, errors_;
};

}  // namespace spherepair
