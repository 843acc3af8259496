// SPDX-License-Identifier: MIT
#include "bench/image/image_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "bench/formats/files.h"
#include "bench/formats/png_file.h"
#include "common/files/file_bytes.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

// Whether the file is an image's record, also one of an earlier version, which has no format.
bool is_record(const fs::path& path) {
  const json found = json::parse(FileBytes(path).bytes(), nullptr, false);
  if (!found.is_object()) return false;
  if (found.contains("format")) return found["format"] == record_format;
  return found.contains("context") && found.contains("camera") && found.contains("samples");
}

}  // namespace

fs::path numbered(const std::string& file, uint64_t k, uint64_t images) {
  fs::path path = file;
  if (images == 1) return path;
  const size_t digits = std::to_string(images - 1).size();
  return path.replace_filename(fmt::format("{}-{:0{}}.png", path.stem().string(), k, digits));
}

fs::path record_of(fs::path image) { return image.replace_extension(".json"); }

void add_image(OutputFiles& files, const std::string& option, const fs::path& image) {
  const fs::path path = record_of(image);
  files.write(option, image);
  files.write("the record of " + option, path);
  if (fs::is_regular_file(path) && !is_record(path))
    throw std::invalid_argument(
        fmt::format("{}, where the record of {} goes, was not written by render: choose another {}", path.string(),
                    option, option));
}

ImageWriters::~ImageWriters() {
  while (!jobs_.empty()) try {
      finish_one();
    } catch (...) {  // an earlier error ended the work
    }
}

void ImageWriters::write(const fs::path& path, std::vector<uint> pixels, uint width, const json& record) {
  if (jobs_.size() >= std::max(1u, std::thread::hardware_concurrency())) finish_one();
  jobs_.push_back(std::async([=, pixels = std::move(pixels)] {
    write_png(path, pixels, width, uint(pixels.size() / width));
    write_file(record_of(path), json_text(record));
  }));
}

void ImageWriters::finish() {
  while (!jobs_.empty()) finish_one();
}

void ImageWriters::finish_one() {
  std::future<void> job = std::move(jobs_.front());
  jobs_.pop_front();
  job.get();
}

}  // namespace spherepair
