// SPDX-License-Identifier: MIT
// Shared by the fuzz targets. All are in one program; the environment variable FUZZ_TARGET says which one runs. Bad
// bytes may only end in std::invalid_argument: any other exception, a crash, a sanitizer's report or a wait of 10 s
// is a finding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "common/backend/backend.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

// Begins the definition of a target.
#define FUZZ(name)                                                       \
  static void fuzz_##name(const uint8_t* data, size_t size);             \
  static const spherepair::FuzzTarget target_##name(#name, fuzz_##name); \
  static void fuzz_##name(const uint8_t* data, size_t size)

namespace spherepair {

struct FuzzTarget {
  FuzzTarget(const char* name, void (*fuzzed)(const uint8_t* data, size_t size));
};

// Writes the bytes to a file of this name, in memory where the system has such a folder, and returns its path.
std::string input_file(const std::string& name, std::string_view bytes);
inline std::string_view text_of(const uint8_t* data, size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// Ends the process if the condition is false, which libFuzzer counts as a finding.
void require(bool holds, const char* what);

// The result of the action; none if it refuses the input.
template <typename Action>
auto unless_refused(Action action) -> std::optional<decltype(action())> {
  try {
    return action();
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

// Takes values from the front of the input, one after the other; zeros after its end.
class Values {
 public:
  Values(const uint8_t* data, size_t size) : rest_(text_of(data, size)) {}
  template <typename T>
  T next() {
    T value{};
    const size_t taken = std::min(sizeof value, rest_.size());
    if (taken) std::memcpy(&value, rest_.data(), taken);
    rest_.remove_prefix(taken);
    return value;
  }
  template <typename T>
  const T& among(const std::vector<T>& all) {
    return all[next<uint8_t>() % all.size()];
  }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

Backend& fuzzed_backend();  // the CPU's, with one thread

// Requires that all pairs, one by one and in vectors, and the grid find one set of the CPU backend's current spheres.
void require_one_set();

}  // namespace spherepair
