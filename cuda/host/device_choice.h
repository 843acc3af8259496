// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "common/backend/backend.h"
#include "common/backend/device_name.h"

namespace spherepair {

// Takes the device of this number or UUID, else the first, and returns its number. Throws BackendError that says why
// there is none to use.
int use_device(const DeviceName& wanted);

BackendInfo describe_device(int device);  // its name, versions and sizes

std::string version_text(int number);  // of a driver or runtime, as CUDA encodes it: 13000 is 13.0

// Groups of collide_tensor that run at once: one on each multiprocessor, none where the kernel cannot be loaded.
uint tensor_groups(int device);

// Groups of persistent_steps that run at once, none where the device launches no kernel of groups that wait for each
// other.
uint persistent_groups(int device);

}  // namespace spherepair
