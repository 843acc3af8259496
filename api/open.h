// SPDX-License-Identifier: MIT
// Opens the backends of this build and machine. No other code asks which backends were built.
#pragma once

#include "common/backend/backend.h"
#include "common/device/device.h"
#include "common/device/device_copy.h"

namespace spherepair {

std::vector<std::string> backend_names();  // cpu, opengl, cuda, vulkan: the default of --backends

// cuda, vulkan, opengl: the backends on a GPU, in the order in which `auto` tries them.
std::vector<std::string> gpu_backend_names();

// backend_names() and two forms of OpenGL to compare with it. Both use plain storage and no vendor's extensions. The
// driver compiles the kernels of opengl-core from their text, those of opengl-spirv from SPIR-V.
std::vector<std::string> all_backend_names();

// The current name of a backend: glsl is an older name of opengl, glsl-core of opengl-core. Throws
// std::invalid_argument for an unknown name.
std::string backend_id(const std::string& name);

// Throws BackendError with the reason if this build or machine does not have the backend; also throws as backend_id.
std::unique_ptr<Backend> open_backend(const std::string& name, const OpenOptions& options = {});

// Opens only the device of a GPU's API (not of cpu), for components without a backend. Throws as open_backend.
std::unique_ptr<Device> open_device(const std::string& name, const OpenOptions& options = {});

// Copies `bytes` between devices of Vulkan and CUDA on one GPU, without the host. Both must outlive the copy. Throws
// BackendError that says what is missing.
DeviceCopy open_device_copy(Device& from, Device& to, uint64_t bytes);

// Throws BackendError when two backends sit on different GPUs.
void check_same_gpu(const Backend& left, const Backend& right);

}  // namespace spherepair
