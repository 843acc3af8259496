// SPDX-License-Identifier: MIT
// Which of several GPUs is meant.
#pragma once

#include <optional>
#include <string>

#include "common/shared/layout.h"

namespace spherepair {

// A number counted from 0, or a UUID as nvidia-smi -L prints it; neither for an empty text.
struct DeviceName {
  std::optional<uint> number;
  std::string uuid;  // 32 hex digits, as in BackendInfo

  // Throws std::invalid_argument that says what was expected.
  explicit DeviceName(const std::string& text);
  bool empty() const { return !number && uuid.empty(); }
};

}  // namespace spherepair
