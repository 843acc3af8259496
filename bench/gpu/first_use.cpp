// SPDX-License-Identifier: MIT
#include "bench/gpu/first_use.h"

#include <unistd.h>

#include <chrono>
#include <fstream>

#include "bench/gpu/gpu_meter.h"
#include "bench/gpu/launch_paths.h"
#include "common/scene/scene.h"

namespace spherepair {
namespace {

int64_t host_bytes() {
  int64_t total = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

std::map<std::string, uint64_t> gpu_bytes() {
  try {
    return used_gpu_memory();
  } catch (const BackendError&) {  // no NVIDIA GPU, or no driver
    return {};
  }
}

double seconds_taken(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

json milliseconds(double seconds) { return 1e3 * seconds; }
json bytes_or_null(const std::optional<int64_t>& bytes) { return bytes ? json(*bytes) : json(); }

}  // namespace

FirstUse first_use(const std::string& name, uint64_t n, const OpenOptions& options, const Opener& opener) {
  const Scene scene = make_scene(launch_scene(LaunchWork::grid, n));
  constexpr int searches = 8;  // the first few prepare what later ones keep
  const CollideOptions search{.method = Method::collide_grid};
  FirstUse use{.n = n};
  const int64_t host = host_bytes();
  const std::map<std::string, uint64_t> gpu = gpu_bytes();
  std::unique_ptr<Backend> backend;
  const auto grown = [&]() -> std::optional<int64_t> {
    const auto before = gpu.find(backend->info().uuid);
    if (before == gpu.end()) return {};
    return int64_t(gpu_bytes().at(before->first)) - int64_t(before->second);
  };
  use.open_s = seconds_taken([&] { backend = opener(name, options); });
  use.opened_host = host_bytes() - host, use.opened_gpu = grown();
  backend->upload(scene);
  backend->finish();
  const auto searched = [&] { return seconds_taken([&] { backend->collide(search), backend->finish(); }); };
  use.first_search_s = searched();
  for (int k = 0; k < searches; ++k) use.later_search_s = searched();
  use.host = host_bytes() - host, use.gpu = grown();
  return use;
}

json to_json(const FirstUse& use) {
  return {{"n", use.n},
          {"open_ms", milliseconds(use.open_s)},
          {"first_search_ms", milliseconds(use.first_search_s)},
          {"later_search_ms", milliseconds(use.later_search_s)},
          {"opened_host_bytes", use.opened_host},
          {"host_bytes", use.host},
          {"opened_gpu_bytes", bytes_or_null(use.opened_gpu)},
          {"gpu_bytes", bytes_or_null(use.gpu)}};
}

}  // namespace spherepair
