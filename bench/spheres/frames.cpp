// SPDX-License-Identifier: MIT
#include "bench/spheres/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/io/numbers.h"
#include "bench/text/fields.h"
#include "common/backend/cpu_team.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

constexpr uint64_t lines_per_chunk = 16384;

void take_lists_out(const FileBytes& file, uint64_t line, std::span<const size_t> lists,
                    std::vector<std::string_view>& fields) {
  for (const size_t at : lists) {
    const std::string_view length = at < fields.size() ? fields[at] : "";
    const auto count = whole_number_of(length, 0, fields.size() - std::min(at + 1, fields.size()));
    if (!count)
      file.fail_at_line(line, fmt::format("a list after {}, its length and so many numbers", counted(at, "number")),
                        in_quotes(length));
    fields.erase(fields.begin() + ptrdiff_t(at), fields.begin() + ptrdiff_t(at + 1 + *count));
  }
}

uint64_t read_chunk(const FileBytes& file, const Columns& columns, bool decimal_comma, const SphereLines& lines,
                    SphereLines::Chunk chunk, SphereRows& rows) {
  RowReader reader(file, columns, decimal_comma);
  std::vector<std::string_view> fields;
  for (uint64_t k = 0; k < chunk.spheres; ++k) {
    const uint64_t line = chunk.start.line;
    const std::string_view text = chunk.start.next();
    split_fields(lines.comments ? without_comment(text) : text, lines.lists.empty() ? columns.count + 1 : text.npos,
                 fields);
    take_lists_out(file, line, lines.lists, fields);
    reader.read(line, text, fields, chunk.first_sphere + k, rows);
  }
  return reader.changed();
}

// Throws the first error in the file, whichever thread finds one first.
uint64_t read_chunks(const FileBytes& file, const Columns& columns, const SphereLines& lines,
                     const SphereFileOptions& options, SphereRows& rows) {
  TeamErrors errors;
  uint64_t changed = 0;
#pragma omp parallel for num_threads(reading_threads(options)) schedule(dynamic, 1) reduction(+ : changed)
  for (size_t k = 0; k < lines.chunks.size(); ++k)
    errors.run(k, [&] { changed += read_chunk(file, columns, options.decimal_comma, lines, lines.chunks[k], rows); });
  errors.rethrow();
  return changed;
}

}  // namespace

uint64_t read_sphere_count(const FileBytes& file, FileLines& cursor, const std::string& expected) {
  const uint64_t line = cursor.line;
  if (cursor.at_end()) file.fail_at_line(line, expected, "the end of the file");
  const std::string_view text = cursor.next();
  std::vector<std::string_view> fields;
  split_fields(text, 2, fields);
  const auto count = whole_number_of(fields.size() == 1 ? fields[0] : "", 0, std::numeric_limits<uint64_t>::max());
  if (!count) file.fail_at_line(line, expected, in_quotes(text));
  if (*count > kMostSpheres)
    file.fail_at_line(line, fmt::format("at most {} spheres", kMostSpheres), fmt::to_string(*count));
  return *count;
}

std::vector<double> finite_numbers(const FileBytes& file, uint64_t line, std::span<const std::string> words,
                                   size_t count) {
  std::vector<double> numbers;
  for (const std::string& word : words)
    if (const auto number = parse_decimal(word); number && std::isfinite(number->value))
      numbers.push_back(number->value);
  if (numbers.size() != count || words.size() != count)
    file.fail_at_line(line, fmt::format("{} finite numbers of the box", count),
                      in_quotes(fmt::format("{}", fmt::join(words, " "))));
  return numbers;
}

SphereLines pass_over_spheres(const FileBytes& file, FileLines& cursor, uint64_t spheres, const std::string& said,
                              const char* what) {
  SphereLines lines{.spheres = spheres};
  for (uint64_t sphere = 0; sphere < spheres; ++sphere) {
    if (sphere % lines_per_chunk == 0)
      lines.chunks.push_back({cursor, sphere, std::min(lines_per_chunk, spheres - sphere)});
    if (cursor.at_end())
      file.fail_at_line(cursor.line, fmt::format("{} as {} says", counted(spheres, what), said),
                        fmt::format("the end of the file after {}", sphere));
    cursor.next();
  }
  return lines;
}

void read_sphere_lines(const FileBytes& file, uint64_t line, Columns columns, const SphereLines& lines,
                       const SphereFileOptions& options, SphereRows& rows, SphereFile& input) {
  if (options.species && lines.spheres > 0 && !columns.species)
    file.fail_at_line(line, "a column of species: species:S:1 in Properties=, the first of four, or type or element",
                      columns.text);
  input.unread_species = columns.species && !options.species;
  input.unread_momenta = columns.momenta && !columns.has(QUANTITY_VX);
  input.unused_radii = take_radii_away(columns, options);
  input.own_radii = columns.has(QUANTITY_RADIUS);
  if (lines.spheres > 0) check_radius(file, columns, options);
  rows.resize(lines.spheres, options.radius.value_or(0), columns.has(QUANTITY_VX), true);
  if (options.species) rows.species.resize(lines.spheres);
  input.values = lines.spheres * columns.quantities();
  input.changed = read_chunks(file, columns, lines, options, rows);
  input.units = columns.units;
  input.format = fmt::format("({}){}", columns.text, lines.spheres > 0 ? ": " + describe(columns) : "");
}

std::optional<WallBox> box_along_axes(const ListBox& box, const Point3& low) {
  WallBox along;
  for (size_t axis = 0; axis < 3; ++axis) {
    const double edge = box.rows[axis][axis];
    if (!(edge > 0) && (edge != 0 || box.periodic[axis] || box.is_open())) return std::nullopt;
    for (size_t other = 0; other < 3; ++other)
      if (axis != other && box.rows[axis][other] != 0) return std::nullopt;
    along.low[axis] = float(low[axis]);
    along.high[axis] = float(double(along.low[axis]) + edge);
    if (!std::isfinite(along.low[axis]) || !std::isfinite(along.high[axis])) return std::nullopt;
    along.periodic |= uint(box.periodic[axis]) << axis;
  }
  return along;
}

// A command that does not search across periodic boundaries would lose pairs of such a file silently.
void take_periodic_box(const std::string& where, const std::string& text, const std::optional<ListBox>& box,
                       const char* wanted, const SphereFileOptions& options, SphereFile& input, const Point3& low) {
  const auto fail = [&](std::string_view expected) {
    throw std::invalid_argument(fmt::format("{}: expected {}, found {}", where, expected, text));
  };
  if (text.empty() || options.ignore_periodic) {
    input.ignored = text;
    return;
  }
  if (!options.exact && !options.moves_in_box)
    fail(
        "spheres without a periodic box, since only `pairs` and runs with --contact find pairs across its boundary "
        "(take only those inside it with --ignore-periodic)");
  if (!box) fail(fmt::format("{} (or take only pairs inside it with --ignore-periodic)", wanted));
  if (options.moves_in_box) {
    input.box = box_along_axes(*box, low);
    if (!input.box) fail("a periodic box along the axes, since contacts move in no other (or give --ignore-periodic)");
    return;
  }
  input.given.boxes = {*box}, input.periodic = text;
}

}  // namespace spherepair
