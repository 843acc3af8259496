// SPDX-License-Identifier: MIT
// What is taken where the user names no backend or no method.
#pragma once

#include "bench/measure/session.h"

namespace spherepair {

struct ChosenBackend {
  std::unique_ptr<Session> session;
  Backend* backend = nullptr;
  std::vector<std::string> passed_over;  // why the faster ones were not taken
};

// The named one, or without a name the fastest that opens: a GPU through CUDA, one through OpenGL, the CPU.
ChosenBackend choose_backend(const std::string& name, const OpenOptions& options);

// What was taken, for the record: the method, the kind of cells, the reason.
json to_json(const MethodChoice& choice);

// The named method, which the backend must have; without a name Method::automatic.
Method choose_method(const std::string& name, const Backend& backend);

}  // namespace spherepair
