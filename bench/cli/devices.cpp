// SPDX-License-Identifier: MIT
// spherepair devices
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/formats/files.h"
#include "bench/gpu/first_use.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/io/output_files.h"
#include "bench/measure/session.h"

namespace spherepair {
namespace {

// Kernel -> milliseconds; null if the kernels were compiled when the program was built.
json compile_all(Instruments& instruments, std::FILE* report) {
  json times;
  for (const StageTime& time : instruments.compile_kernels()) {
    times[time.stage] = 1e3 * time.seconds;
    fmt::print(report, "  compiling {:<24} {:.2f} ms\n", time.stage, 1e3 * time.seconds);
  }
  return times;
}

std::string megabytes(int64_t opened, int64_t searching) {
  return fmt::format("{:.0f} MB open, {:.0f} MB searching", 1e-6 * double(opened), 1e-6 * double(searching));
}

std::vector<std::pair<std::string, std::string>> lines_of(const FirstUse& use) {
  const auto ms = [](double seconds) { return fmt::format("{:.3g} ms", 1e3 * seconds); };
  return {{"opening takes", ms(use.open_s)},
          {"first search takes", fmt::format("{}, of {} spheres by the grid", ms(use.first_search_s), use.n)},
          {"later searches take", ms(use.later_search_s)},
          {"host memory", megabytes(use.opened_host, use.host)},
          {"GPU memory", use.gpu ? megabytes(*use.opened_gpu, *use.gpu) : "unknown: no NVML, or no GPU"}};
}

// Before all backends are open, since only then is their use a first one.
std::map<std::string, FirstUse> first_uses(const CommandLine& line, const DevicesOptions& options) {
  constexpr uint64_t spheres = 1'000'000;
  std::map<std::string, FirstUse> uses;
  for (const std::string& name : options.backends.empty() ? backend_names() : options.backends) try {
      uses[name] = first_use(name, spheres, line.open, line.opener);
    } catch (const BackendError&) {
      if (!options.backends.empty()) throw;  // else the list tells the reason
    }
  return uses;
}

}  // namespace

int devices_command(const CommandLine& line, const DevicesOptions& options) {
  OutputFiles files;
  files.write("--json", options.json_file);
  std::FILE* report = options.json_file == kStandardOutput ? stderr : stdout;
  const auto uses = options.first_use ? first_uses(line, options) : std::map<std::string, FirstUse>{};
  const Session session(options.backends, line.open, line.opener);
  json list = session.to_json();
  for (json& backend : list) {
    const std::string name = backend.at("name");
    if (!backend.at("open")) {
      fmt::print(report, "{}\n  missing: {}\n", name, backend.at("reason").get<std::string>());
      continue;
    }
    fmt::print(report, "{}\n", name);
    const auto show = [&](const std::string& what, const std::string& value) {
      fmt::print(report, "  {:<34} {}\n", what, value);
    };
    show("language", backend.at("language"));
    show("device", device_label(session.find(name)->info()));
    if (!backend.at("uuid").get<std::string>().empty()) show("uuid", backend.at("uuid"));
    show("device timers", backend.at("device_timers") ? "yes" : "no");
    for (const auto& [what, value] : session.find(name)->info().details) show(what, value);
    if (const auto use = uses.find(name); use != uses.end()) {
      for (const auto& [what, value] : lines_of(use->second)) show(what, value);
      backend["first_use"] = to_json(use->second);
    }
    if (options.compile) backend["compile_ms"] = compile_all(*session.find(name), report);
  }
  for (const std::string& warning : session.warnings()) fmt::print(stderr, "\n{}\n", warning);
  write_json(options.json_file, {{"context", capture_context(line.words)}, {"backends", list}});
  return kOk;
}

}  // namespace spherepair
