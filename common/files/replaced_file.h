// SPDX-License-Identifier: MIT
// Atomic replacement of files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace spherepair {

// What a program is told about files: by default nothing.
struct FileNews {
  void (*temporary)(const std::string& file);          // made, to be removed if the program ends early
  void (*forgotten)(const std::string& file);          // that temporary file is removed or has its name
  void (*written)(const std::filesystem::path& file);  // a whole file
};
void tell_of_files(const FileNews& news);

// Writes an unnamed file; commit() syncs it and gives it its name. Until then an existing file of that name is
// unchanged, and without commit() nothing remains, even if the program is killed. (On file systems without unnamed
// files it is a temporary file in the same folder. In the program signals remove it (bench/io/interruption.h), except
// SIGKILL.) Pipes and devices are written directly. Throws std::invalid_argument.
class ReplacedFile {
 public:
  explicit ReplacedFile(const std::filesystem::path& path);
  ~ReplacedFile();
  ReplacedFile(const ReplacedFile&) = delete;
  ReplacedFile& operator=(const ReplacedFile&) = delete;

  void write(std::string_view bytes);
  std::string name_for_children();  // for child processes started from now on, which may write before commit()
  void commit();

 private:
  [[noreturn]] void fail(int error) const;
  bool take_temporary_name(const std::function<bool(const std::string&)>& take);
  bool open_temporary();

  std::filesystem::path path_, target_, temporary_;  // as given; links followed; empty without such a file
  bool nameless_ = false;
  int descriptor_ = -1;
};

// The file that a write replaces: the end of a chain of links, even if that file does not exist yet.
std::filesystem::path follow_links(const std::filesystem::path& path);

// Whether the file is replaced. Pipes and devices are not: output to them cannot be taken back.
bool is_replaced(const std::filesystem::path& path);

// Throws if a file of that name cannot be written. Creates nothing and does not open pipes or devices.
void check_writable(const std::filesystem::path& path);

}  // namespace spherepair
