// SPDX-License-Identifier: MIT
// What is taken where the user names no backend or no method.
#pragma once

#include "session.h"

namespace spherepair {

struct ChosenBackend {
  std::unique_ptr<Session> session;
  Backend* backend = nullptr;
  std::vector<std::string> passed_over;  // why the faster ones were not taken
};

// The named one, or without a name the fastest that opens: a GPU through CUDA, one through OpenGL, the CPU.
ChosenBackend choose_backend(const std::string& name, const OpenOptions& options);

// The named method, which the backend must have, or without a name its fastest for n spheres that finds all pairs.
Method choose_method(const std::string& name, const Backend& backend, uint64_t n);

}  // namespace spherepair
