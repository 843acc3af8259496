// SPDX-License-Identifier: MIT
#include "video.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace spherepair {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

Video::Video(const fs::path& path, uint width, uint height, uint pictures_per_second)
    : path_(path), beside_(path.parent_path() / (path.stem().string() + ".new" + path.extension().string())) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0)
    throw std::invalid_argument("a video needs ffmpeg: install the package ffmpeg, or write pictures with --output");
  if (width % 2 || height % 2)
    throw std::invalid_argument(fmt::format("a video of {}x{} pixels: both must be even", width, height));
  std::signal(SIGPIPE, SIG_IGN);  // a failing ffmpeg is reported, not died of
  const std::string command = fmt::format(
      "ffmpeg -loglevel error -y -f rawvideo -pix_fmt rgba -s {}x{} -r {} -i - -c:v libx264 -crf 18 -pix_fmt yuv420p "
      "{}",
      width, height, pictures_per_second, quoted(beside_.string()));
  pipe_ = popen(command.c_str(), "w");
  if (!pipe_) fail("ffmpeg could not be started");
}

Video::~Video() {
  if (pipe_) pclose(pipe_);
  std::error_code ignored;
  fs::remove(beside_, ignored);
}

void Video::add(const std::vector<uint>& image) {
  if (std::fwrite(image.data(), sizeof(uint), image.size(), pipe_) != image.size()) fail("ffmpeg stopped early");
}

void Video::commit() {
  const int status = pclose(pipe_);
  pipe_ = nullptr;
  if (status != 0) fail("ffmpeg failed");
  fs::rename(beside_, path_);
}

void Video::fail(const char* what) const {
  throw std::runtime_error(fmt::format("{}: {}; its own message stands above", path_.string(), what));
}

}  // namespace spherepair
