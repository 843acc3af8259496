// SPDX-License-Identifier: MIT
// Opens what this build and this machine have: the only place that asks what was built.
#pragma once

#include "common/backend/backend.h"
#include "common/device/device.h"

namespace spherepair {

std::vector<std::string> backend_names();  // cpu, opengl, cuda, vulkan: those that are opened where none is named

// cuda, vulkan, opengl: those of a GPU, in the order in which they are tried where the fastest is wanted.
std::vector<std::string> gpu_backend_names();

// Those of backend_names() and opengl-core: OpenGL in plain storage without vendors' extensions, to be compared with
// opengl.
std::vector<std::string> all_backend_names();

// The backend of this name: glsl is an older name of opengl, glsl-core of opengl-core. Throws std::invalid_argument for
// a name that is none.
std::string backend_id(const std::string& name);

// Throws BackendError with the reason when this build or machine does not have it, and as backend_id.
std::unique_ptr<Backend> open_backend(const std::string& name, const OpenOptions& options = {});

// The device of a GPU's API alone (not of cpu), for components without a backend. Throws as open_backend.
std::unique_ptr<Device> open_device(const std::string& name, const OpenOptions& options = {});

// Throws BackendError when two backends sit on different GPUs.
void check_same_gpu(const Backend& left, const Backend& right);

}  // namespace spherepair
