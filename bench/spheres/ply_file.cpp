// SPDX-License-Identifier: MIT
// Reads spheres from PLY (paulbourke.net/dataformats/ply): one sphere for each vertex, text or binary.
// Skips other elements and lists.
#include <fmt/format.h>

#include <array>

#include "bench/npy/number_table.h"
#include "bench/spheres/frames.h"
#include "bench/spheres/ply_header.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

// The properties of the spheres without lists.
struct Scalars {
  std::vector<NamedColumn> names = {};
  std::vector<size_t> property = {};  // of each
  std::vector<size_t> lists = {};     // for each list the number of scalars before it
};

Scalars scalars_of(const PlyElement& element) {
  Scalars scalars;
  for (size_t k = 0; k < element.properties.size(); ++k) {
    if (element.properties[k].is_list()) {
      scalars.lists.push_back(scalars.names.size());
    } else {
      scalars.names.push_back({element.properties[k].name});
      scalars.property.push_back(k);
    }
  }
  return scalars;
}

Columns columns_of(const FileBytes& file, const PlyElement& vertex, const Scalars& scalars,
                   const SphereFileOptions& options) {
  if (options.columns.empty()) {
    Columns columns = columns_of_names(fmt::format("{}, line {}", file.name(), vertex.line), scalars.names);
    columns.by = fmt::format("by the properties from line {} on", vertex.line + 1);
    return columns;
  }
  const Columns columns = columns_of_option(options.columns, scalars.names, file.name());
  if (columns.count != scalars.names.size())
    file.fail_at_line(vertex.line, fmt::format("a vertex of {}, by --columns", counted(columns.count, "number")),
                      fmt::to_string(scalars.names.size()));
  return columns;
}

SphereFile read_lines(const FileBytes& file, const PlyHeader& header, const SphereFileOptions& options,
                      SphereRows& rows) {
  const PlyElement& vertex = header.elements[header.vertex];
  const Scalars scalars = scalars_of(vertex);
  SphereLines lines;
  FileLines cursor = header.data;
  for (const PlyElement& element : header.elements) {
    const SphereLines passed =
        pass_over_spheres(file, cursor, element.properties.empty() ? 0 : element.count,
                          fmt::format("line {} (element {})", element.line, element.name), "row");
    if (&element == &vertex) lines = passed;
  }
  cursor.skip_blank_lines();
  const uint64_t last = cursor.line;
  if (!cursor.at_end())
    file.fail_at_line(last, "the end of the file after the elements of the header", in_quotes(cursor.next()));
  lines.lists = scalars.lists;
  SphereFile input;
  read_sphere_lines(file, vertex.line, columns_of(file, vertex, scalars, options), lines, options, rows, input);
  return input;
}

uint64_t whole_number_at(const FileBytes& file, uint64_t at, std::string_view dtype) {
  std::string bytes(file.bytes().substr(at, bytes_of_dtype(dtype)));
  if (dtype[0] == '>') std::ranges::reverse(bytes);
  return little_endian(bytes);
}

// The offset after `count` items from `at` on, which must be in the file.
uint64_t behind(const FileBytes& file, const PlyElement& element, uint64_t at, uint64_t count, uint64_t item_bytes) {
  const uint64_t left = file.bytes().size() - at;
  if (item_bytes > 0 && count > left / item_bytes)
    file.fail_at_byte(at,
                      fmt::format("{} of {} in element {} (line {})", counted(count, "item"),
                                  counted(item_bytes, "byte"), element.name, element.line),
                      fmt::format("the end of the file after {}", counted(left, "byte")));
  return at + count * item_bytes;
}

// Returns the offset after an element, and tells the column of each property where its numbers lie; null: not read.
uint64_t pass_over(const FileBytes& file, const PlyElement& element, uint64_t at,
                   std::span<NumberColumn* const> columns) {
  uint64_t row_bytes = 0;
  for (size_t k = 0; k < columns.size(); ++k) {
    if (columns[k]) columns[k]->first = at + row_bytes;
    row_bytes += bytes_of_dtype(element.properties[k].dtype);
  }
  for (NumberColumn* column : columns)
    if (column) column->stride = row_bytes;
  if (!element.has_lists()) return behind(file, element, at, element.count, row_bytes);
  for (uint64_t row = 0; row < element.count; ++row)
    for (size_t k = 0; k < columns.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      if (columns[k]) columns[k]->places.push_back(at);
      uint64_t count = 1;
      if (property.is_list()) {
        const uint64_t first = behind(file, element, at, 1, bytes_of_dtype(property.length_dtype));
        count = whole_number_at(file, at, property.length_dtype);
        at = first;
      }
      at = behind(file, element, at, count, bytes_of_dtype(property.dtype));
    }
  return at;
}

SphereFile read_binary(const FileBytes& file, const PlyHeader& header, const SphereFileOptions& options,
                       SphereRows& rows) {
  const PlyElement& vertex = header.elements[header.vertex];
  const Scalars scalars = scalars_of(vertex);
  NumberTable table{.file = file, .rows = vertex.count, .meaning = columns_of(file, vertex, scalars, options)};
  std::array<size_t, quantity_names.size()> property{};
  for (size_t q = 0; q < quantity_names.size(); ++q)
    if (const auto& at = table.meaning.columns[q])
      property[table.columns.size()] = scalars.property[*at],
      table.columns.push_back({&file, Quantity(q), vertex.properties[scalars.property[*at]].dtype, 0, 0});
  uint64_t at = file.bytes().size() - header.data.rest.size();
  for (const PlyElement& element : header.elements) {
    std::vector<NumberColumn*> columns(element.properties.size(), nullptr);
    for (size_t k = 0; &element == &vertex && k < table.columns.size(); ++k) columns[property[k]] = &table.columns[k];
    at = pass_over(file, element, at, columns);
  }
  if (at < file.bytes().size())
    file.fail_at_byte(at, "the end of the file after the elements of the header",
                      counted(file.bytes().size() - at, "trailing byte"));
  SphereFile input;
  read_numbers(table, options, rows, input);
  input.format = fmt::format("({}): {}", table.meaning.text, describe(table.meaning));
  return input;
}

}  // namespace

SphereFile read_ply(const FileBytes& file, const SphereFileOptions& options, SphereRows& rows) {
  const PlyHeader header = read_ply_header(file);
  SphereFile input = (header.format == "ascii" ? read_lines : read_binary)(file, header, options, rows);
  input.format = fmt::format("PLY {} {}", header.format, input.format);
  return input;
}

}  // namespace spherepair
