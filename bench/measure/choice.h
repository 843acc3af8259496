// SPDX-License-Identifier: MIT
// The backend and method used when the user names none.
#pragma once

#include "bench/measure/session.h"

namespace spherepair {

inline constexpr const char* kAutomaticBackend = "auto";  // on the command line

struct ChosenBackend {
  std::unique_ptr<Session> session;
  Backend* backend = nullptr;
  std::vector<std::string> passed_over;  // reasons why faster backends were not chosen
};

// Opens the named backend. Without a name, opens the first of gpu_backend_names() that opens on a GPU, else the CPU. If
// the system shows no GPU and no option asks for one, opens the CPU at once.
ChosenBackend choose_backend(const std::string& name, const OpenOptions& options, const Opener& opener = open_backend);

// A line for each backend that was passed over.
std::string passed_over_text(const ChosenBackend& chosen);

// Method, kind of cells and reason, for the record.
json to_json(const MethodChoice& choice);

// The named method, which the backend must have; without a name Method::automatic.
Method choose_method(const std::string& name, const Search& search);

}  // namespace spherepair
