// SPDX-License-Identifier: MIT
#include "bench/formats/video.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace spherepair {

Video::Video(const std::filesystem::path& path, uint width, uint height, uint images_per_second)
    : path_(path), file_(path) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0)
    throw std::invalid_argument("a video needs ffmpeg: install the package ffmpeg, or write images with --output");
  if (width % 2 || height % 2)
    throw std::invalid_argument(
        fmt::format("a video of {}x{} pixels: both must be even; give another --size", width, height));
  std::signal(SIGPIPE, SIG_IGN);  // a failing ffmpeg is reported instead of ending this process
  const std::string command = fmt::format(
      "ffmpeg -loglevel error -y -f rawvideo -pix_fmt rgba -s {}x{} -r {} -i - -c:v libx264 -crf 18 -pix_fmt yuv420p "
      "-f mp4 {}",
      width, height, images_per_second, file_.name_for_children());
  pipe_ = popen(command.c_str(), "w");
  if (!pipe_) fail("ffmpeg could not be started");
}

Video::~Video() {
  if (pipe_) pclose(pipe_);
}

void Video::add(const std::vector<uint>& image) {
  if (std::fwrite(image.data(), sizeof(uint), image.size(), pipe_) != image.size()) fail("ffmpeg stopped early");
}

void Video::commit() {
  const int status = pclose(pipe_);
  pipe_ = nullptr;
  if (status != 0) fail("ffmpeg failed");
  file_.commit();
}

void Video::fail(const char* what) const {
  throw std::runtime_error(fmt::format("{}: {}; see its message above", path_.string(), what));
}

}  // namespace spherepair
