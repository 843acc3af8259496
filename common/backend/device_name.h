// SPDX-License-Identifier: MIT
// The name of a GPU, to choose one of several.
#pragma once

#include <optional>
#include <string>

#include "common/shared/layout.h"

namespace spherepair {

// A GPU's number, counted from 0, or its UUID as nvidia-smi -L prints it. An empty text gives neither.
struct DeviceName {
  std::optional<uint> number;
  std::string uuid;  // 32 hex digits, as in BackendInfo

  // Throws std::invalid_argument that says which form was expected.
  explicit DeviceName(const std::string& text);
  bool empty() const { return !number && uuid.empty(); }
};

}  // namespace spherepair
