// SPDX-License-Identifier: MIT
#include "bench/formats/png_file.h"

#include <fmt/format.h>
#include <png.h>

#include <stdexcept>
#include <string>

#include "common/files/replaced_file.h"

namespace spherepair {

void write_png(const std::filesystem::path& path, std::span<const uint> pixels, uint width, uint height) {
  std::string rgb;
  rgb.reserve(pixels.size() * 3);
  for (const uint pixel : pixels)
    for (int shift = 0; shift < 24; shift += 8) rgb.push_back(char(pixel >> shift & 255));
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string file(bytes, '\0');
  if (!png_image_write_to_memory(&image, file.data(), &bytes, 0, rgb.data(), 0, nullptr))
    throw std::runtime_error(fmt::format("libpng could not encode {}: {}", path.string(), image.message));
  file.resize(bytes);
  ReplacedFile out(path);
  out.write(file);
  out.commit();
}

}  // namespace spherepair
