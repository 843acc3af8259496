// SPDX-License-Identifier: MIT
// For tests of the code that compares backends: opens the CPU beside a faulty backend, and returns what was reported.
#pragma once

#include <gtest/gtest.h>

#include "bench/check/step_result.h"
#include "tests/faults/faulty_backend.h"

namespace spherepair {

inline Session session_with(Fault fault, uint64_t from_step = 0) {
  return Session({"cpu", "opengl"}, {.threads = 1}, faulty_opener(fault, from_step));
}

// The message of the difference that `work` finds; empty when it finds none.
template <typename Work>
std::string difference_of(Work work) {
  try {
    work();
  } catch (const DifferenceFound& difference) {
    return difference.what();
  }
  return {};
}

template <typename Work>
std::string error_of(Work work) {
  try {
    work();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

inline void expect_named(const std::string& message, const NamedFault& fault, const std::string& where) {
  EXPECT_NE(message.find(fault.found_as), std::string::npos) << where << ", " << fault.name << ": '" << message << "'";
  EXPECT_NE(message.find("opengl"), std::string::npos) << message;
}

}  // namespace spherepair
