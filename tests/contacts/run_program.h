// SPDX-License-Identifier: MIT
// Runs `spherepair run` on a small bed, for tests of its options and files.
#pragma once

#include <fmt/format.h>

#include <optional>

#include "bench/options/command.h"
#include "bench/spheres/sphere_file.h"
#include "tests/support/program.h"

namespace spherepair {

inline const std::string bed =
    "run --backend cpu --scene bed --n 60 --contact spring --restitution 0.4 --stiffness 1e6 --drag 2";

class RunProgram : public ProgramTest {
 protected:
  Outcome good(const std::string& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, kOk) << arguments << "\n" << outcome.errors;
    return outcome;
  }
  void refused(const std::string& arguments, const std::string& why) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, kUsage) << arguments;
    EXPECT_NE(outcome.errors.find(why), std::string::npos) << arguments << "\n" << outcome.errors;
  }
  std::vector<vec4> positions(const std::string& file, std::optional<uint64_t> frame = {}) const {
    return read_sphere_file(path(file), {.frame = frame}).scene.positions;
  }
  nlohmann::json end(const std::string& file) const { return read_json(file).at("end"); }
  std::string state(const std::string& file) const { return read_json(file).at("steps").back().at("state"); }
};

}  // namespace spherepair
