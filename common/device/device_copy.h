// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "common/device/memory.h"

namespace spherepair {

// Copies one device's buffer to another's, as often as it is called. Both devices must be idle, and are on return.
using DeviceCopy = std::function<void(const Memory& from, const Memory& to)>;

}  // namespace spherepair
