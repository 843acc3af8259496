// SPDX-License-Identifier: MIT
// What all interfaces of a backend share: the scene, the device that holds it, and the errors.
#pragma once

#include <map>
#include <stdexcept>
#include <string>

#include "common/scene/scene.h"

namespace spherepair {

// The device failed: out of memory, a driver error or a limit. The message says what failed, where, and what to do.
class BackendError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct BackendInfo {
  std::string name, language;  // API: cpu, opengl, cuda, vulkan; kernels: C++, GLSL, CUDA C++
  std::string device;          // as the driver names it
  std::string uuid;            // of the GPU, 32 hex digits; empty for software
  bool on_host = false;        // runs loops of host threads: has no kernels to launch in groups
  bool software = false;       // GL or Vulkan on the CPU
  bool device_timers = false;
  std::map<std::string, std::string> details;  // versions, extensions, limits
};

class Device;

class SceneHolder {
 public:
  virtual ~SceneHolder() = default;
  virtual const BackendInfo& info() const = 0;
  virtual Device* device() { return nullptr; }  // of a GPU API: for work besides the scene; else null

  // Checks the scene (check_scene), allocates every buffer and copies the scene. Throws BackendError when it does not
  // fit.
  virtual void upload(const Scene& scene) = 0;
  virtual void finish() = 0;  // waits for all that was enqueued
};

}  // namespace spherepair
