// SPDX-License-Identifier: MIT
#include "bench/io/output_files.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <stdexcept>

#include "common/files/replaced_file.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

// A key that is equal for two names of the same file, which is regular or does not exist yet; empty for anything else.
std::string identity(const fs::path& path) {
  struct stat status {};
  std::error_code error;
  if (::stat(path.c_str(), &status) != 0) return fs::weakly_canonical(fs::absolute(path, error), error).string();
  return S_ISREG(status.st_mode) ? fmt::format("{}:{}", status.st_dev, status.st_ino) : "";
}

}  // namespace

void OutputFiles::read(const std::string& option, const fs::path& path) {
  if (path.empty() || path == "-") return;
  const std::string file = identity(path);
  if (!file.empty()) uses_[file] = {option, path, false};
}

void OutputFiles::write(const std::string& option, const fs::path& path, const std::string& in_place) {
  if (path.empty()) return;
  const bool standard_output = path == kStandardOutput;
  const std::string file = standard_output ? kStandardOutput : identity(follow_links(path));
  const auto other = uses_.find(file);
  if (other != uses_.end() && (other->second.output || other->second.option != in_place))
    throw std::invalid_argument(fmt::format("{} {} is the {} {} of {}: choose another name", option, path.string(),
                                            other->second.output ? "output" : "input", other->second.path.string(),
                                            other->second.option));
  if (!standard_output) check_writable(path);
  if (!file.empty()) uses_[file] = {option, path, true};
}

}  // namespace spherepair
