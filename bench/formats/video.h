// SPDX-License-Identifier: MIT
// Writes a video through an ffmpeg process.
#pragma once

#include <cstdio>
#include <filesystem>
#include <vector>

#include "common/files/replaced_file.h"
#include "common/shared/layout.h"

namespace spherepair {

// commit() gives the file its name; without it nothing remains.
class Video {
 public:
  // Throws std::invalid_argument without ffmpeg. width and height must be even.
  Video(const std::filesystem::path& path, uint width, uint height, uint images_per_second);
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  void add(const std::vector<uint>& image);  // in the format of Drawing::image()
  void commit();

 private:
  [[noreturn]] void fail(const char* what) const;

  std::filesystem::path path_;
  ReplacedFile file_;
  FILE* pipe_ = nullptr;
};

}  // namespace spherepair
