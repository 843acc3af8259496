// SPDX-License-Identifier: MIT
// The context that every record has: machine, versions, build, environment, clocks.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/io/report.h"

namespace spherepair {

struct BuildInfo {
  const char *version, *commit, *compiler, *flags, *cuda_compiler;
  const char* sources;  // JSON: glsl/collide_grid, cuda/collide_grid, host/glsl ... and their digests
};
extern const BuildInfo build_info;  // written at build time

// Machine, build, digests of the timed sources, environment and command line. Session::to_json adds the backends.
json capture_context(const std::vector<std::string>& command_line);

// Clocks, throttle reasons, temperature and power of every GPU from nvidia-smi; null without nvidia-smi.
json query_clocks();

bool gpu_seems_present();  // the kernel driver's control node exists

// Whether a GPU's driver has a device file: NVIDIA's, DRM's, WSL's (dxg) or a Jetson's (nvmap).
bool gpu_nodes_present(const std::filesystem::path& devices = "/dev");

std::string utc_date();         // 2025-11-21T04:08:00Z
std::string default_results();  // results/<host>-<date>

}  // namespace spherepair
