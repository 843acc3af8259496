// SPDX-License-Identifier: MIT
// Writing a file so that a failure loses nothing.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace spherepair {

// Written without a name and given its name by commit(), once it is on the disk; until then whatever has the name stays
// as it is, and without a commit nothing is left, even when the program is killed (where the file system knows no files
// without a name, that is one beside it, which a kill leaves). What is no regular file (a pipe, a device) is written
// directly. Throws std::invalid_argument.
class ReplacedFile {
 public:
  explicit ReplacedFile(const std::filesystem::path& path);
  ~ReplacedFile();
  ReplacedFile(const ReplacedFile&) = delete;
  ReplacedFile& operator=(const ReplacedFile&) = delete;

  void write(std::string_view bytes);
  std::string name_for_children();  // under which programs that are started from now on can write before the commit
  void commit();

 private:
  [[noreturn]] void fail(int error) const;
  bool take_name_beside(const std::function<bool(const std::string&)>& take);
  bool open_beside();

  std::filesystem::path path_, target_, beside_;  // as given; with links followed; empty while there is no such file
  bool nameless_ = false;
  int descriptor_ = -1;
};

// Throws when a file of that name could not be written; leaves nothing and touches no pipe or device.
void check_writable(const std::filesystem::path& path);

}  // namespace spherepair
