// SPDX-License-Identifier: MIT
// What every study command does around its measurements: folder, session, warnings, record, files and the last lines.
#pragma once

#include <chrono>
#include <filesystem>

#include "bench/options/command.h"
#include "bench/studies/study_report.h"

namespace spherepair {

class StudyRun {
 public:
  // Creates the folder and opens the backends (empty: all that open); prints them, and warnings on standard error. The
  // files are NAME.json, NAME.txt and NAME.csv.
  StudyRun(const CommandLine& line, const std::string& name, const std::string& results,
           const std::vector<std::string>& backends);

  Session& session() { return session_; }
  bool hardware() const;  // whether a GPU is among the backends

  json record;   // `complete`, context, backends and clocks; the study adds its measurements
  void write();  // the record with the warnings so far, so that an interrupted study keeps what it has measured

  // Writes the finished record, the tables, and the samples in these entries as CSV. Prints the tables and the folder.
  int finish(const Page& tables, const json& samples);

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::string name_;
  std::filesystem::path folder_;
  StudyLoad load_;  // constructed before the session
  Session session_;
};

}  // namespace spherepair
