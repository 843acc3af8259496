// SPDX-License-Identifier: MIT
// spherepair devices
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/formats/files.h"
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

}  // namespace

int devices_command(const CommandLine& line, const DevicesOptions& options) {
  OutputFiles files;
  files.write("--json", options.json_file);
  std::FILE* report = options.json_file == kStandardOutput ? stderr : stdout;
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
    if (options.compile) backend["compile_ms"] = compile_all(*session.find(name), report);
  }
  for (const std::string& warning : session.warnings()) fmt::print(stderr, "\n{}\n", warning);
  write_json(options.json_file, {{"context", capture_context(line.words)}, {"backends", list}});
  return kOk;
}

}  // namespace spherepair
