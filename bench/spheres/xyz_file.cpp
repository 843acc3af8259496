// SPDX-License-Identifier: MIT
// Reads spheres from XYZ and extended XYZ: a line with their number, a comment line, a line per sphere; then the next
// frame.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "bench/io/file_lines.h"
#include "bench/io/numbers.h"
#include "bench/spheres/columns.h"
#include "bench/spheres/sphere_file.h"
#include "bench/spheres/xyz_columns.h"
#include "bench/text/fields.h"
#include "common/backend/cpu_team.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

// A chunk of sphere lines, read by one thread.
constexpr uint64_t lines_per_chunk = 16384;
struct Chunk {
  FileLines start;
  uint64_t first_sphere, spheres;
};

struct Frame {
  uint64_t spheres = 0, comment_line = 0;
  std::string_view comment;
  std::vector<Chunk> chunks;
};

uint64_t read_count(const FileBytes& file, FileLines& cursor, bool first) {
  const char* expected = first ? "the number of spheres" : "the number of spheres of another frame, or the end";
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

// Finds the lines of a frame; parses only the first two.
Frame read_frame(const FileBytes& file, FileLines& cursor, bool first) {
  Frame frame;
  const uint64_t count_line = cursor.line;
  frame.spheres = read_count(file, cursor, first);
  frame.comment_line = cursor.line;
  if (cursor.at_end()) file.fail_at_line(cursor.line, "the comment line", "the end of the file");
  frame.comment = cursor.next();
  for (uint64_t sphere = 0; sphere < frame.spheres; ++sphere) {
    if (sphere % lines_per_chunk == 0)
      frame.chunks.push_back({cursor, sphere, std::min(lines_per_chunk, frame.spheres - sphere)});
    if (cursor.at_end())
      file.fail_at_line(cursor.line, fmt::format("{} as line {} says", counted(frame.spheres, "sphere"), count_line),
                        fmt::format("the end of the file after {}", sphere));
    cursor.next();
  }
  return frame;
}

uint64_t read_chunk(const FileBytes& file, const Columns& columns, bool decimal_comma, Chunk chunk, SphereRows& rows) {
  RowReader reader(file, columns, decimal_comma);
  std::vector<std::string_view> fields;
  for (uint64_t k = 0; k < chunk.spheres; ++k) {
    const uint64_t line = chunk.start.line;
    const std::string_view text = chunk.start.next();
    split_fields(text, columns.count + 1, fields);
    reader.read(line, text, fields, chunk.first_sphere + k, rows);
  }
  return reader.changed();
}

// Throws the first error in the file, whichever thread finds one first.
uint64_t read_spheres(const FileBytes& file, const Columns& columns, const Frame& frame,
                      const SphereFileOptions& options, SphereRows& rows) {
  TeamErrors errors;
  uint64_t changed = 0;
#pragma omp parallel for num_threads(reading_threads(options)) schedule(dynamic, 1) reduction(+ : changed)
  for (size_t k = 0; k < frame.chunks.size(); ++k)
    errors.run(k, [&] { changed += read_chunk(file, columns, options.decimal_comma, frame.chunks[k], rows); });
  errors.rethrow();
  return changed;
}

// Whether all lines are of four numbers, the first of them whole and positive: LAMMPS writes types in place of names.
bool may_have_types(const Frame& frame) {
  std::vector<std::string_view> fields;
  FileLines lines = frame.chunks.front().start;
  for (uint64_t k = 0; k < frame.spheres; ++k) {
    split_fields(lines.next(), 5, fields);
    if (fields.size() != 4 || !whole_number_of(fields[0], 1, std::numeric_limits<uint64_t>::max())) return false;
  }
  return true;
}

Columns columns_of(const FileBytes& file, const Frame& frame, const Comment& comment,
                   const SphereFileOptions& options) {
  const auto properties = properties_of(comment, options.columns.empty());
  if (!options.columns.empty())
    return columns_of_option(options.columns, properties.value_or(std::vector<NamedColumn>()), file.name());
  if (properties) return columns_of_properties(comment, *properties);
  if (frame.chunks.empty()) return {.text = "no spheres"};
  FileLines first = frame.chunks.front().start;
  const uint64_t line = first.line;
  const bool types = may_have_types(frame);
  const std::string_view text = first.next();
  if (types && (!options.radius || options.ignore_radii))
    file.fail_at_line(line,
                      options.ignore_radii
                          ? "--columns: the first of four numbers may be a type; give --columns x,y,z,_ or "
                            "--columns species,x,y,z"
                          : "--columns: the first of four numbers may be a type; give --columns x,y,z,radius, or "
                            "--radius and --columns species,x,y,z",
                      in_quotes(text));
  return classic_columns(file, line, text, types);
}

// Where pairs across a periodic boundary are not found, such a file would lose them in silence.
void read_box(const Comment& comment, const SphereFileOptions& options, SphereFile& input) {
  const PeriodicBox box = periodic_box(comment);
  if (!box.text.empty() && !options.ignore_periodic) {
    if (!options.take_periodic)
      comment.file.fail_at_line(comment.line,
                                "spheres without a periodic box, since only `pairs` finds pairs across its boundary "
                                "(take only those inside it with --ignore-periodic)",
                                box.text);
    if (!box.box)
      comment.file.fail_at_line(comment.line,
                                "a periodic box as Lattice=\"...\" of nine numbers, its three vectors, with "
                                "pbc=\"T T F\" (or take only pairs inside it with --ignore-periodic)",
                                box.text);
    input.periodic = PeriodicSpheres{.box = *box.box, .set = {}, .text = box.text};
    return;
  }
  input.ignored = box.text;
  input.box = closed_box(comment);
  if (box.text.empty() && options.ignore_periodic && !box.mention.empty()) input.ignored = in_quotes(box.mention);
  input.unread_box = options.ignore_periodic ? "" : box.mention;
}

// All of which must be complete.
std::vector<Frame> find_frames(const FileBytes& file) {
  std::vector<Frame> frames;
  FileLines cursor = lines_of(file);
  while (frames.empty() || !cursor.at_end()) {
    frames.push_back(read_frame(file, cursor, frames.empty()));
    cursor.skip_blank_lines();
  }
  return frames;
}

SphereFile read_one(const FileBytes& file, std::span<const Frame> frames, uint64_t k, const SphereFileOptions& options,
                    SphereRows& rows) {
  const Frame& frame = frames[k];
  SphereFile input;
  input.frame = k;
  input.frames = frames.size();
  const Comment comment{file, frame.comment_line, frame.comment};
  read_box(comment, options, input);
  Columns columns = columns_of(file, frame, comment, options);
  if (options.species && frame.spheres > 0 && !columns.species)
    file.fail_at_line(frame.comment_line,
                      "a column of species, by Properties= with species:S:1 or as the first of four", columns.text);
  input.unread_species = columns.species && !options.species;
  input.unread_momenta = columns.momenta && !columns.has(QUANTITY_VX);
  input.unused_radii = take_radii_away(columns, options);
  input.own_radii = columns.has(QUANTITY_RADIUS);
  if (frame.spheres > 0) check_radius(file, columns, options);
  rows.resize(frame.spheres, options.radius.value_or(0), columns.has(QUANTITY_VX), true);
  if (options.species) rows.species.resize(frame.spheres);
  input.values = frame.spheres * columns.quantities();
  input.changed = read_spheres(file, columns, frame, options, rows);
  input.units = columns.units;
  input.format = fmt::format("XYZ ({}){}", columns.text, frame.spheres > 0 ? ": " + describe(columns) : "");
  return input;
}

}  // namespace

SphereFile read_xyz(const FileBytes& file, const SphereFileOptions& options, SphereRows& rows) {
  require_text(file);
  const uint64_t wanted = options.frame.value_or(0);
  const std::vector<Frame> frames = find_frames(file);
  if (wanted >= frames.size())
    throw std::invalid_argument(fmt::format("{} has {}, counted from 0, so --frame {} is not among them", file.name(),
                                            counted(frames.size(), "frame"), wanted));
  SphereFile input = read_one(file, frames, wanted, options, rows);
  if (options.ignore_periodic && input.ignored.empty())
    throw std::invalid_argument(fmt::format("{} has no periodic box: omit --ignore-periodic", file.name()));
  return input;
}

std::vector<SphereFile> read_xyz_frames(const FileBytes& file, const SphereFileOptions& options,
                                        std::vector<SphereRows>& rows) {
  require_text(file);
  const std::vector<Frame> frames = find_frames(file);
  rows.resize(frames.size());
  std::vector<SphereFile> read;
  for (uint64_t k = 0; k < frames.size(); ++k) read.push_back(read_one(file, frames, k, options, rows[k]));
  return read;
}

}  // namespace spherepair
