// SPDX-License-Identifier: MIT
#include "bench/cli/study_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/formats/files.h"
#include "bench/io/context.h"

namespace spherepair {

StudyRun::StudyRun(const CommandLine& line, const std::string& name, const std::string& results,
                   const std::vector<std::string>& backends)
    : name_(name),
      folder_(prepare_results(results, files_of_study(name))),
      load_(line.clocks),
      session_(backends, line.open, line.opener) {
  fmt::print("spherepair {} ({})\n{}\n", build_info.version, build_info.commit, session_.summary());
  std::fflush(stdout);
  for (const std::string& warning : load_.warnings(session_)) fmt::print(stderr, "{}\n", warning);
  record = {{"complete", false},
            {"context", capture_context(line.words)},
            {"backends", session_.to_json()},
            {"clocks", json::array({query_clocks()})}};
}

bool StudyRun::hardware() const {
  return std::ranges::any_of(session_.backends(), [](const auto& backend) { return on_hardware(*backend); });
}

void StudyRun::write() {
  record["warnings"] = load_.warnings(session_);
  write_file(folder_ / (name_ + ".json"), json_text(record));
}

int StudyRun::finish(const Page& tables, const json& samples) {
  record["complete"] = true;
  record["clocks"].push_back(query_clocks());
  write();
  report_page(
      folder_, name_, [&](size_t width) { return tables(width) + load_.text(session_); }, samples);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
  fmt::print("\nIn {:.0f} s. Results: {}\n", taken.count(), (folder_ / (name_ + ".json")).string());
  return kOk;
}

}  // namespace spherepair
