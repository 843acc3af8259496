// SPDX-License-Identifier: MIT
// A film, encoded by ffmpeg in a process of its own.
#pragma once

#include <cstdio>
#include <filesystem>
#include <vector>

#include "bench/io/replaced_file.h"
#include "common/shared/layout.h"

namespace spherepair {

// Appears under its name with commit(); without a commit nothing is left.
class Video {
 public:
  // Throws std::invalid_argument when ffmpeg is not there. width and height must be even.
  Video(const std::filesystem::path& path, uint width, uint height, uint pictures_per_second);
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  void add(const std::vector<uint>& image);  // as Backend::image() gives it
  void commit();

 private:
  [[noreturn]] void fail(const char* what) const;

  std::filesystem::path path_;
  ReplacedFile file_;
  FILE* pipe_ = nullptr;
};

}  // namespace spherepair
