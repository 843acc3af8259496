// SPDX-License-Identifier: MIT
// Images and the records of how to reproduce them, written while the next ones are drawn.
#pragma once

#include <deque>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include "bench/io/output_files.h"
#include "bench/io/report.h"

namespace spherepair {

constexpr const char* record_format = "spherepair render 1";

// image.png, or image-007.png of several.
std::filesystem::path numbered(const std::string& file, uint64_t k, uint64_t images);
std::filesystem::path record_of(std::filesystem::path image);  // image.json

// Declares an image and its record as outputs. The user named the image but not its record, so the record must not
// replace a file that is no record.
void add_image(OutputFiles& files, const std::string& option, const std::filesystem::path& image);

// Encodes and writes images while the next ones are drawn; without threads, when finish() waits for them. That is
// also when their exceptions are thrown.
class ImageWriters {
 public:
  ImageWriters() = default;
  ~ImageWriters();  // waits
  void write(const std::filesystem::path& path, std::vector<uint> pixels, uint width, const json& record);
  void finish();

 private:
  void finish_one();
  std::deque<std::future<void>> jobs_;
};

}  // namespace spherepair
