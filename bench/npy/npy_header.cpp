// SPDX-License-Identifier: MIT
#include "bench/npy/npy_header.h"

#include <fmt/format.h>

#include <charconv>

namespace spherepair {
namespace {

constexpr std::string_view magic("\x93NUMPY", 6);

// The header is a Python literal: {'descr': '<f4', 'fortran_order': False, 'shape': (10, 3), }
class HeaderText {
 public:
  HeaderText(const FileBytes& file, uint64_t first, uint64_t last)
      : file_(file), text_(file.bytes().substr(0, last)), at_(first) {}

  NpyHeader parse();

 private:
  [[noreturn]] void fail(std::string_view expected) const {
    file_.fail_at_byte(at_, expected, at_ < text_.size() ? in_quotes(text_.substr(at_)) : "the end of the header");
  }
  void skip_space() {
    while (at_ < text_.size() && std::string_view(" \t\n\r").find(text_[at_]) != text_.npos) ++at_;
  }
  bool take(std::string_view word) {
    skip_space();
    if (!text_.substr(at_).starts_with(word)) return false;
    at_ += word.size();
    return true;
  }
  void require(std::string_view word, std::string_view expected) {
    if (!take(word)) fail(expected);
  }

  void entry();
  NpyField dtype();
  void fields();
  std::string string(std::string_view expected);
  bool boolean();
  std::vector<uint64_t> tuple();
  uint64_t number();

  const FileBytes& file_;
  std::string_view text_;  // begins at the file's first byte, so that offsets in it are offsets in the file
  uint64_t at_;
  NpyHeader header_;
  bool has_dtype_ = false, has_order_ = false, has_shape_ = false;
};

NpyHeader HeaderText::parse() {
  const uint64_t first = at_;
  require("{", "a header that begins with '{'");
  while (!take("}")) {
    entry();
    if (take("}")) break;
    require(",", "',' or '}' in the header");
  }
  skip_space();
  if (at_ < text_.size()) fail("nothing but spaces after the header's '}'");
  for (const auto& [found, key] :
       {std::pair(has_dtype_, "descr"), {has_order_, "fortran_order"}, {has_shape_, "shape"}})
    if (!found) file_.fail_at_byte(first, fmt::format("a header with the key '{}'", key), "none");
  header_.data_at = text_.size();
  return header_;
}

void HeaderText::entry() {
  skip_space();
  const uint64_t key_at = at_;
  const std::string key = string("a key of the header in quotes");
  require(":", "':' after the header's key");
  skip_space();
  if (key == "descr") {
    header_.structured = at_ < text_.size() && text_[at_] == '[';
    header_.structured ? fields() : header_.fields.push_back(dtype());
    has_dtype_ = true;
  } else if (key == "fortran_order") {
    header_.fortran_order = boolean();
    has_order_ = true;
  } else if (key == "shape") {
    header_.shape_at = at_;
    header_.shape = tuple();
    has_shape_ = true;
  } else {
    file_.fail_at_byte(key_at, "the key 'descr', 'fortran_order' or 'shape'", in_quotes(key));
  }
}

NpyField HeaderText::dtype() {
  skip_space();
  const uint64_t at = at_;
  return {.name = "", .dtype = string("a dtype in quotes such as '<f4'"), .dtype_at = at};
}

// [('x', '<f4'), ('velocity', '<f8', (3,))]
void HeaderText::fields() {
  require("[", "a list of fields");
  while (!take("]")) {
    require("(", "a field in parentheses such as ('x', '<f4')");
    skip_space();
    const std::string name = string("a field's name in quotes");
    require(",", "',' after the field's name");
    NpyField field = dtype();
    field.name = name;
    if (take(",") && !take(")")) {
      const uint64_t shape_at = at_;
      const std::vector<uint64_t> shape = tuple();
      if (shape.size() != 1 || shape[0] == 0 || shape[0] > 1000000)
        file_.fail_at_byte(shape_at, "a field of one axis such as (3,)", fmt::format("({})", fmt::join(shape, ", ")));
      field.count = shape[0];
      require(")", "')' after the field");
    } else if (text_[at_ - 1] != ')') {
      require(")", "')' after the field");
    }
    header_.fields.push_back(field);
    if (take("]")) break;
    require(",", "',' or ']' after the field");
  }
}

std::string HeaderText::string(std::string_view expected) {
  const char quote = at_ < text_.size() ? text_[at_] : ' ';
  if (quote != '\'' && quote != '"') fail(expected);
  const size_t end = text_.find(quote, at_ + 1);
  if (end == text_.npos) fail(expected);
  const std::string value(text_.substr(at_ + 1, end - at_ - 1));
  at_ = end + 1;
  return value;
}

bool HeaderText::boolean() {
  if (take("True")) return true;
  require("False", "True or False for 'fortran_order'");
  return false;
}

std::vector<uint64_t> HeaderText::tuple() {
  std::vector<uint64_t> values;
  require("(", "a shape in parentheses such as (10, 3)");
  while (!take(")")) {
    values.push_back(number());
    if (take(")")) break;
    require(",", "',' or ')' in the shape");
  }
  return values;
}

uint64_t HeaderText::number() {
  skip_space();
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
  if (error != std::errc()) fail("a whole number in the shape");
  at_ = uint64_t(end - text_.data());
  take("L");  // suffix of Python 2's long integers
  return value;
}

}  // namespace

uint64_t NpyField::item_bytes() const {
  if (dtype.size() < 3) return 0;
  uint64_t size = 0;
  const auto [end, error] = std::from_chars(dtype.data() + 2, dtype.data() + dtype.size(), size);
  if (error != std::errc() || end != dtype.data() + dtype.size() || size > 1000000) return 0;
  return dtype[1] == 'U' ? 4 * size : dtype[1] == 'O' ? 0 : size;
}

NpyHeader read_npy_header(const FileBytes& file) {
  const std::string_view bytes = file.bytes();
  if (!bytes.starts_with(magic))
    file.fail_at_byte(0, "the magic string '\\x93NUMPY' of an NPY file",
                      bytes.empty()            ? "an empty file"
                      : kind_of(bytes).empty() ? in_quotes(bytes.substr(0, magic.size()))
                                               : std::string(kind_of(bytes)));
  if (bytes.size() < 8) file.fail_at_byte(bytes.size(), "the version's two bytes", "the end of the file");
  const int major = static_cast<unsigned char>(bytes[6]), minor = static_cast<unsigned char>(bytes[7]);
  if (major < 1 || major > 3 || minor != 0)
    file.fail_at_byte(6, "NPY version 1.0, 2.0 or 3.0", fmt::format("version {}.{}", major, minor));
  const size_t width = major == 1 ? 2 : 4, first = 8 + width;
  if (bytes.size() < first) file.fail_at_byte(bytes.size(), "the header's length", "the end of the file");
  const uint64_t length = little_endian(bytes.substr(8, width));
  if (length > bytes.size() - first)
    file.fail_at_byte(8, "a header that ends within the file",
                      fmt::format("one of {} bytes in a file of {}", length, bytes.size()));
  return HeaderText(file, first, first + length).parse();
}

}  // namespace spherepair
