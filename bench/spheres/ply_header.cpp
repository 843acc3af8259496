// SPDX-License-Identifier: MIT
#include "bench/spheres/ply_header.h"

#include <fmt/format.h>

#include <array>

#include "bench/io/numbers.h"
#include "bench/text/fields.h"

namespace spherepair {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 18> types = {{{"char", "i1"},
                                                                                  {"uchar", "u1"},
                                                                                  {"short", "i2"},
                                                                                  {"ushort", "u2"},
                                                                                  {"int", "i4"},
                                                                                  {"uint", "u4"},
                                                                                  {"float", "f4"},
                                                                                  {"double", "f8"},
                                                                                  {"int8", "i1"},
                                                                                  {"uint8", "u1"},
                                                                                  {"int16", "i2"},
                                                                                  {"uint16", "u2"},
                                                                                  {"int32", "i4"},
                                                                                  {"uint32", "u4"},
                                                                                  {"int64", "i8"},
                                                                                  {"uint64", "u8"},
                                                                                  {"float32", "f4"},
                                                                                  {"float64", "f8"}}};

// A line of the header and its words.
struct HeaderLine {
  const FileBytes& file;
  uint64_t line;
  std::string_view text;
  std::vector<std::string> words = words_in(text);

  [[noreturn]] void fail(std::string_view expected) const { file.fail_at_line(line, expected, in_quotes(text)); }
};

std::string dtype_of(const HeaderLine& line, const std::string& type, const PlyHeader& header) {
  const auto known = std::ranges::find(types, type, [](const auto& pair) { return pair.first; });
  if (known == types.end()) line.fail("a type: char, uchar, short, ushort, int, uint, float, double or float32 ...");
  return fmt::format("{}{}", header.format == "binary_big_endian" ? '>' : '<', known->second);
}

std::string format_in(const HeaderLine& line) {
  const auto& words = line.words;
  const bool known = words.size() == 3 && words[2] == "1.0" &&
                     (words[1] == "ascii" || words[1] == "binary_little_endian" || words[1] == "binary_big_endian");
  if (!known) line.fail("format ascii 1.0, format binary_little_endian 1.0 or format binary_big_endian 1.0");
  return words[1];
}

PlyElement element_in(const HeaderLine& line) {
  const auto count = whole_number_of(line.words.size() == 3 ? line.words[2] : "", 0, UINT64_MAX);
  if (!count) line.fail("element NAME NUMBER");
  return {.name = line.words[1], .count = *count, .line = line.line};
}

void add_property(const HeaderLine& line, PlyHeader& header) {
  const auto& words = line.words;
  const bool is_list = words.size() == 5 && words[1] == "list";
  if (header.elements.empty()) line.fail("element before its properties");
  if (words.size() != 3 && !is_list) line.fail("property TYPE NAME or property list TYPE TYPE NAME");
  PlyProperty property{.name = words.back(), .dtype = dtype_of(line, words[words.size() - 2], header)};
  if (is_list) property.length_dtype = dtype_of(line, words[2], header);
  if (is_list && property.length_dtype[1] == 'f') line.fail("a list whose length has a type of whole numbers");
  header.elements.back().properties.push_back(property);
}

size_t find_vertex(const FileBytes& file, const PlyHeader& header, uint64_t line) {
  std::string names;
  for (const PlyElement& element : header.elements) names += (names.empty() ? "" : ", ") + in_quotes(element.name);
  const auto vertex = std::ranges::find(header.elements, "vertex", &PlyElement::name);
  if (std::ranges::count(header.elements, "vertex", &PlyElement::name) != 1)
    file.fail_at_line(line, "one element vertex before end_header", names.empty() ? "no element" : names);
  if (vertex->count > kMostSpheres)
    file.fail_at_line(vertex->line, fmt::format("at most {} spheres", kMostSpheres), fmt::to_string(vertex->count));
  return size_t(vertex - header.elements.begin());
}

}  // namespace

PlyHeader read_ply_header(const FileBytes& file) {
  PlyHeader header;
  FileLines cursor{file.bytes()};
  if (const std::string_view first = cursor.next(); first != "ply")
    file.fail_at_line(1, "ply, the first line of a PLY file",
                      kind_of(first).empty() ? in_quotes(first) : std::string(kind_of(first)));
  while (true) {
    const uint64_t number = cursor.line;
    if (cursor.at_end()) file.fail_at_line(number, "end_header", "the end of the file");
    const HeaderLine line{file, number, cursor.next()};
    const std::string keyword = line.words.empty() ? "" : line.words[0];
    if (keyword == "comment" || keyword == "obj_info") continue;
    if (keyword != "format" && header.format.empty()) line.fail("format before elements");
    if (keyword == "format")
      header.format = format_in(line);
    else if (keyword == "element")
      header.elements.push_back(element_in(line));
    else if (keyword == "property")
      add_property(line, header);
    else if (keyword != "end_header")
      line.fail("format, comment, element, property or end_header");
    if (keyword != "end_header") continue;
    header.vertex = find_vertex(file, header, number);
    header.data = cursor;
    return header;
  }
}

}  // namespace spherepair
