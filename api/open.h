// SPDX-License-Identifier: MIT
// Opens what this build and this machine have: the only place that asks what was built.
#pragma once

#include "common/backend/backend.h"
#include "common/device/device.h"

namespace spherepair {

std::vector<std::string> backend_names();  // cpu, glsl, cuda: those that are opened where none is named

// These and glsl-core: OpenGL in plain storage without vendors' extensions, to be compared with glsl.
std::vector<std::string> all_backend_names();

// Throws BackendError with the reason when this build or machine does not have it, std::invalid_argument for a name
// that does not exist.
std::unique_ptr<Backend> open_backend(const std::string& name, const OpenOptions& options = {});

// The device of a GPU's API alone (not of cpu), for components without a backend. Throws as open_backend.
std::unique_ptr<Device> open_device(const std::string& name, const OpenOptions& options = {});

// Throws BackendError when two backends sit on different GPUs.
void check_same_gpu(const Backend& left, const Backend& right);

}  // namespace spherepair
