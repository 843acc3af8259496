// SPDX-License-Identifier: MIT
#include "bench/measure/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "api/open.h"
#include "bench/io/context.h"
#include "bench/io/numbers.h"
#include "bench/measure/statistics.h"

namespace spherepair {
namespace {

// Identifies a kernel: its variants share the time of its first use.
std::string first_key(const Search& search, const CollideOptions& options) {
  return fmt::format("{} {} {}", search.info().name, method_name(options.method), options.block);
}

}  // namespace

bool on_hardware(const Backend& backend) { return !backend.info().on_host && !backend.info().software; }

std::string transfer_in_words(const Drawing& drawing) {
  const auto taken = drawing.transfer_taken();
  if (!taken) return {};
  if (*taken == Transfer::imported) return ", its spheres copied into memory that OpenGL shares";
  if (*taken == Transfer::registered) return ", its spheres copied into OpenGL's buffers, which CUDA maps";
  return ", its spheres transferred through the host";
}

std::string device_label(const BackendInfo& info) {
  return info.device +
         (info.software ? fmt::format(" (SOFTWARE: {} on the CPU)", info.name == "vulkan" ? "Vulkan" : "OpenGL") : "");
}

Session::Session(const std::vector<std::string>& names, const OpenOptions& options, const Opener& opener)
    : options_(options) {
  for (const std::string& name : names.empty() ? backend_names() : names) {
    if (find(name)) continue;
    try {
      backends_.push_back(opener(name, options));
    } catch (const BackendError& error) {
      if (!names.empty()) throw;
      const std::string reason = error.what();  // begins with the backend's name, which is already before it
      missing_.push_back({name, reason.starts_with(name + ": ") ? reason.substr(name.size() + 2) : reason});
    }
  }
  if (backends_.empty()) throw BackendError("no backend could be opened:\n" + summary());
  std::stable_partition(backends_.begin(), backends_.end(), [](const auto& b) { return b->info().on_host; });
  for (Backend* left : devices())
    for (Backend* right : devices())
      if (left < right && on_hardware(*left) && on_hardware(*right)) check_same_gpu(*left, *right);
}

std::vector<Backend*> Session::devices() const {
  std::vector<Backend*> found;
  for (const auto& backend : backends_)
    if (!backend->info().on_host) found.push_back(backend.get());
  return found;
}

std::vector<Session::Versus> Session::contests() const {
  std::vector<Versus> found;
  const std::vector<Backend*> all = devices();
  if (all.empty()) return found;
  Backend* const cuda = find("cuda");
  Backend* const baseline = cuda ? cuda : all.front();
  for (Backend* device : all)
    if (device != baseline) found.push_back({device, baseline});
  return found;
}

Backend* Session::find(const std::string& name) const {
  for (const auto& backend : backends_)
    if (backend->info().name == name) return backend.get();
  return nullptr;
}

void Session::collide(Search& search, const CollideOptions& options) {
  const std::string key = first_key(search, options);
  if (first_.contains(key)) return search.collide(options);
  search.finish();
  const auto start = std::chrono::steady_clock::now();
  search.collide(options);
  search.finish();
  first_[key] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double Session::first_seconds(const Search& search, const CollideOptions& options) const {
  const auto found = first_.find(first_key(search, options));
  return found == first_.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

std::optional<double> Session::timer_floor(Backend& backend) {
  constexpr int launches = 100;
  if (!backend.info().device_timers) return {};
  const auto [found, is_new] = timer_floors_.try_emplace(backend.info().name, 0);
  if (!is_new) return found->second;
  backend.finish();
  backend.time_stages(true);
  for (int k = 0; k < launches; ++k) backend.launch_empty(1);
  std::vector<double> readings;
  for (const StageTime& one : backend.stage_times()) readings.push_back(one.seconds);
  backend.time_stages(false);
  return found->second = median(readings);
}

std::optional<uint64_t> Session::l2_bytes(const Backend& backend) const {
  const Backend* cuda = find("cuda");
  if (!cuda || backend.info().uuid.empty() || cuda->info().uuid != backend.info().uuid) return {};
  const auto told = cuda->info().details.find("L2 bytes");
  if (told == cuda->info().details.end()) return {};
  return whole_number_of(told->second, 0, std::numeric_limits<uint64_t>::max());
}

std::string Session::summary() const {
  std::string text;
  for (const auto& backend : backends_)
    text += fmt::format("  {:<6} {}\n", backend->info().name, device_label(backend->info()));
  for (const Missing& missing : missing_) text += fmt::format("  {:<6} missing: {}\n", missing.name, missing.reason);
  return text;
}

std::vector<std::string> Session::warnings() const {
  std::vector<std::string> found;
  const Backend *opengl = find("opengl"), *cuda = find("cuda"), *vulkan = find("vulkan");
  const bool gpu = gpu_seems_present() || cuda;
  if (gpu && opengl && opengl->info().software)
    found.push_back("WARNING: this machine seems to have a GPU, but OpenGL runs in SOFTWARE (" + opengl->info().device +
                    "). Times of opengl say nothing about the GPU. Install the driver's EGL files (for NVIDIA: "
                    "libnvidia-gl and /usr/share/glvnd/egl_vendor.d/10_nvidia.json, in a container "
                    "NVIDIA_DRIVER_CAPABILITIES=all), or pass --require-hardware to fail instead.");
  if (gpu && vulkan && vulkan->info().software)
    found.push_back("WARNING: this machine seems to have a GPU, but Vulkan runs in SOFTWARE (" + vulkan->info().device +
                    "). Times of vulkan say nothing about the GPU. Install the driver's Vulkan file (for NVIDIA: "
                    "/usr/share/vulkan/icd.d/nvidia_icd.json, in a container NVIDIA_DRIVER_CAPABILITIES=all), or pass "
                    "--require-hardware to fail instead.");
  const bool missed = std::ranges::any_of(missing_, [](const Missing& each) { return each.name == "cuda"; });
  if (gpu_seems_present() && missed)  // not if the user requested other backends
    found.emplace_back("WARNING: this machine seems to have an NVIDIA GPU, but the backend cuda is not open.");
  return found;
}

namespace {

// Limits and counts as numbers; versions and names as text.
json details_json(const std::map<std::string, std::string>& details) {
  json out = json::object();
  for (const auto& [what, value] : details) {
    const auto number = whole_number_of(value, 0, std::numeric_limits<uint64_t>::max());
    out[what] = number ? json(*number) : json(value);
  }
  return out;
}

}  // namespace

json Session::to_json() const {
  json list = json::array();
  for (const auto& backend : backends_) {
    const BackendInfo& info = backend->info();
    list.push_back({{"name", info.name},
                    {"language", info.language},
                    {"open", true},
                    {"device", info.device},
                    {"uuid", info.uuid},
                    {"software", info.software},
                    {"device_timers", info.device_timers},
                    {"details", details_json(info.details)}});
  }
  for (const Missing& missing : missing_)
    list.push_back({{"name", missing.name}, {"open", false}, {"reason", missing.reason}});
  return list;
}

}  // namespace spherepair
