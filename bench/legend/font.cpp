// SPDX-License-Identifier: MIT
#include "bench/legend/font.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace spherepair {

extern const unsigned char font_png[];
extern const size_t font_png_size;

namespace {

// The letters beyond ASCII, in font.py's order.
constexpr std::u32string_view others = U"·×–≥²³µÅ";
constexpr int em = 48, ascent = 47;

struct Font {
  int width = 0, height = 0;
  std::vector<unsigned char> pixels;  // coverage
  std::vector<int> begins;            // left edges of the letters' boxes, then the end of the last box
};

Font decode() {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  Font font;
  bool read = png_image_begin_read_from_memory(&image, font_png, font_png_size) != 0;
  if (read) {
    image.format = PNG_FORMAT_GRAY;
    font.pixels.resize(PNG_IMAGE_SIZE(image));
    read = png_image_finish_read(&image, nullptr, font.pixels.data(), 0, nullptr) != 0;
  }
  if (!read) throw std::logic_error(std::string("the embedded font cannot be read: ") + image.message);
  font.width = int(image.width), font.height = int(image.height) - 1;
  for (int x = 0; x < font.width; ++x)
    if (font.pixels[size_t(x)] != 0) font.begins.push_back(x);
  font.begins.push_back(font.width);
  font.pixels.erase(font.pixels.begin(), font.pixels.begin() + font.width);
  return font;
}

const Font& font() {
  static const Font decoded = decode();
  return decoded;
}

size_t index_of(char32_t letter) {
  if (letter >= 32 && letter < 127) return letter - 32;
  const size_t at = others.find(letter);
  return at == others.npos ? size_t('?' - 32) : 127 - 32 + at;
}

// Indices of a text's letters. Bytes that are not UTF-8 become letters that the font lacks.
std::vector<size_t> letters_of(std::string_view text) {
  std::vector<size_t> letters;
  for (size_t k = 0; k < text.size();) {
    const auto byte = [&](size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0u; };
    const unsigned first = byte(k);
    const size_t more = first < 0xC0 ? 0 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
    char32_t letter = more == 0 ? first : first & (0x3Fu >> more);
    for (size_t each = 1; each <= more; ++each) letter = letter << 6 | (byte(k + each) & 0x3F);
    letters.push_back(index_of(letter));
    k += 1 + more;
  }
  return letters;
}

// The mean coverage of a rectangle of the font's pixels, limited to the columns from first to before last.
double coverage(const Font& f, double x0, double x1, double y0, double y1, int first, int last) {
  double sum = 0;
  for (int y = std::max(int(std::floor(y0)), 0); y < std::min(int(std::ceil(y1)), f.height); ++y)
    for (int x = std::max(int(std::floor(x0)), first); x < std::min(int(std::ceil(x1)), last); ++x) {
      const double wide = std::min(x1, x + 1.0) - std::max(x0, double(x));
      const double tall = std::min(y1, y + 1.0) - std::max(y0, double(y));
      sum += wide * tall * f.pixels[size_t(y) * size_t(f.width) + size_t(x)];
    }
  return sum / 255 / ((x1 - x0) * (y1 - y0));
}

}  // namespace

double text_width(const std::string& utf8, double size) {
  double width = 0;
  for (const size_t letter : letters_of(utf8)) width += font().begins[letter + 1] - font().begins[letter];
  return width * size / em;
}

void draw_text(Canvas& canvas, const std::string& utf8, Point baseline, double size, uint colour) {
  const Font& f = font();
  const double step = em / size;  // font pixels in an image pixel
  const double top = std::round(baseline.y) - ascent / step;
  for (const size_t letter : letters_of(utf8)) {
    const int first = f.begins[letter], last = f.begins[letter + 1];
    const double right = baseline.x + (last - first) / step;
    for (int y = int(std::floor(top)); y < top + f.height / step; ++y)
      for (int x = int(std::floor(baseline.x)); x < right; ++x) {
        const double at_x = first + (x - baseline.x) * step, at_y = (y - top) * step;
        const double share = coverage(f, at_x, at_x + step, at_y, at_y + step, first, last);
        if (share > 0) canvas.blend(x, y, colour, share);
      }
    baseline.x = right;
  }
}

}  // namespace spherepair
