// SPDX-License-Identifier: MIT
// Writes images, and records that tell how to make them again, while the next images are drawn.
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

// image.png, or image-007.png if there are several images.
std::filesystem::path numbered(const std::string& file, uint64_t k, uint64_t images);
std::filesystem::path record_of(std::filesystem::path image);  // image.json

// Declares an image and its record as outputs. The user did not name the record, so it must not replace any other kind
// of file.
void add_image(OutputFiles& files, const std::string& option, const std::filesystem::path& image);

// Encodes and writes images while the next ones are drawn; if no thread can start, finish() writes them. finish()
// waits, and throws the writers' exceptions.
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
