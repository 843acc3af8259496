// SPDX-License-Identifier: MIT
#include "bench/io/context.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>

extern char** environ;

namespace spherepair {
namespace {

// The text after `separator` on the first line of a file that starts with `key`.
std::string value_in_file(const char* path, const std::string& key, char separator) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(key)) continue;
    std::string value = line.substr(line.find(separator) + 1);
    value.erase(0, value.find_first_not_of(" \t\""));
    value.erase(value.find_last_not_of(" \t\"") + 1);
    return value;
  }
  return "unknown";
}

std::string first_line(const char* path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

std::string output_of(const char* command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command, "r"), pclose);
  std::string text;
  std::array<char, 512> chunk;
  while (pipe && std::fgets(chunk.data(), int(chunk.size()), pipe.get())) text += chunk.data();
  return text;
}

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, separator);) {
    field.erase(0, field.find_first_not_of(' '));
    fields.push_back(field);
  }
  return fields;
}

json machine() {
  utsname kernel{};
  uname(&kernel);
  return {{"cpu", value_in_file("/proc/cpuinfo", "model name", ':')},
          {"hardware_threads", std::thread::hardware_concurrency()},
          {"memory", value_in_file("/proc/meminfo", "MemTotal", ':')},
          {"cpu_governor", first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor")},
          {"load_average", first_line("/proc/loadavg")},
          {"system", value_in_file("/etc/os-release", "PRETTY_NAME", '=')},
          {"kernel", fmt::format("{} {} {}", kernel.sysname, kernel.release, kernel.machine)}};
}

// Variables that choose a device, a driver, a thread count or a debugging mode.
json environment() {
  json found = json::object();
  for (char** entry = environ; *entry; ++entry) {
    const std::string text = *entry, name = text.substr(0, text.find('='));
    for (const char* prefix : {"OMP_", "GOMP_", "CUDA_", "NVIDIA_", "LIBGL_", "GALLIUM_", "LP_", "MESA_", "__GL_",
                               "__EGL_", "EGL_", "LD_PRELOAD"})
      if (name.starts_with(prefix)) found[name] = text.substr(name.size() + 1);
  }
  return found;
}

std::string date(const char* format) {
  const std::time_t now = std::time(nullptr);
  return fmt::format(fmt::runtime(fmt::format("{{:{}}}", format)), fmt::gmtime(now));
}

}  // namespace

json capture_context(const std::vector<std::string>& command_line) {
  return {{"date", utc_date()},
          {"command_line", command_line},
          {"build",
           {{"version", build_info.version},
            {"commit", build_info.commit},
            {"compiler", build_info.compiler},
            {"flags", build_info.flags},
            {"cuda_compiler", build_info.cuda_compiler}}},
          {"sources", json::parse(build_info.sources)},
          {"machine", machine()},
          {"environment", environment()},
          {"gpu_seems_present", gpu_seems_present()}};
}

json query_clocks() {
  static const std::string fields =
      "name,driver_version,clocks.sm,clocks.max.sm,clocks.mem,clocks_throttle_reasons.active,temperature.gpu,"
      "power.draw,pstate";
  const std::string command = "nvidia-smi --query-gpu=" + fields + " --format=csv,noheader 2>/dev/null";
  std::istringstream lines(output_of(command.c_str()));
  json gpus;
  for (std::string line; std::getline(lines, line);) {
    const auto names = split(fields, ','), values = split(line, ',');
    if (names.size() != values.size()) continue;
    json gpu = {{"date", utc_date()}};
    for (size_t k = 0; k < names.size(); ++k) gpu[names[k]] = values[k];
    gpus.push_back(gpu);
  }
  return gpus;
}

bool gpu_seems_present() { return std::filesystem::exists("/dev/nvidiactl"); }

bool gpu_nodes_present(const std::filesystem::path& devices) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(devices, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("nvidia") || name == "dxg" || name == "nvmap") return true;
    if (name == "dri" && !std::filesystem::is_empty(entry.path(), error)) return true;
  }
  return bool(error);  // an unreadable folder may hold one
}

std::string utc_date() { return date("%Y-%m-%dT%H:%M:%SZ"); }

std::string default_results() {
  std::array<char, 256> host{};
  if (gethostname(host.data(), host.size() - 1) != 0) return "results/" + date("%Y%m%d-%H%M%S");
  return fmt::format("results/{}-{}", host.data(), date("%Y%m%d-%H%M%S"));
}

}  // namespace spherepair
