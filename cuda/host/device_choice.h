// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "common/backend/backend.h"
#include "common/backend/device_name.h"

namespace spherepair {

// Selects the device with this number or UUID, else the first, and returns its number. Throws BackendError with the
// reason if there is none to use.
int use_device(const DeviceName& wanted);

BackendInfo describe_device(int device);  // its name, versions and sizes

std::string version_text(int number);  // of a driver or runtime, as CUDA encodes it: 13000 is 13.0

// Returns the groups of collide_tensor that run at once: one a multiprocessor, or 0 if the kernel cannot be loaded.
uint tensor_groups(int device);

// Returns the groups of persistent_steps that run at once, or 0 if the device has no cooperative launches, whose groups
// wait for each other.
uint persistent_groups(int device);

}  // namespace spherepair
