// SPDX-License-Identifier: MIT
// The backend and method used when the user names none.
#pragma once

#include "bench/measure/session.h"

namespace spherepair {

struct ChosenBackend {
  std::unique_ptr<Session> session;
  Backend* backend = nullptr;
  std::vector<std::string> passed_over;  // reasons why faster backends were not chosen
};

// The named backend, or without a name the fastest that opens: CUDA, OpenGL on a GPU, the CPU.
ChosenBackend choose_backend(const std::string& name, const OpenOptions& options);

// For the record: method, kind of cells, reason.
json to_json(const MethodChoice& choice);

// The named method, which the backend must have; Method::automatic without a name.
Method choose_method(const std::string& name, const Backend& backend);

}  // namespace spherepair
