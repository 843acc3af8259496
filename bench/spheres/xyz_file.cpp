// SPDX-License-Identifier: MIT
// Reads spheres from XYZ and extended XYZ: a line with their number, a comment line, a line per sphere; then the next
// frame.
#include <fmt/format.h>

#include <limits>

#include "bench/io/numbers.h"
#include "bench/spheres/frames.h"
#include "bench/spheres/xyz_columns.h"
#include "bench/text/fields.h"

namespace spherepair {
namespace {

struct Frame {
  uint64_t comment_line = 0;
  std::string_view comment;
  SphereLines lines;
};

// Finds the lines of a frame; parses only the first two.
Frame read_frame(const FileBytes& file, FileLines& cursor, bool first) {
  Frame frame;
  const uint64_t count_line = cursor.line;
  const uint64_t spheres = read_sphere_count(
      file, cursor, first ? "the number of spheres" : "the number of spheres of another frame, or the end");
  frame.comment_line = cursor.line;
  if (cursor.at_end()) file.fail_at_line(cursor.line, "the comment line", "the end of the file");
  frame.comment = cursor.next();
  frame.lines = pass_over_spheres(file, cursor, spheres, fmt::format("line {}", count_line));
  return frame;
}

// Whether all lines have four numbers, the first whole and positive: LAMMPS writes types instead of names.
bool may_have_types(const Frame& frame) {
  std::vector<std::string_view> fields;
  FileLines lines = frame.lines.chunks.front().start;
  for (uint64_t k = 0; k < frame.lines.spheres; ++k) {
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
  if (frame.lines.chunks.empty()) return {.text = "no spheres"};
  FileLines first = frame.lines.chunks.front().start;
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

void read_box(const Comment& comment, const SphereFileOptions& options, SphereFile& input) {
  const PeriodicBox box = periodic_box(comment);
  const auto origin = origin_of(comment);
  if (options.moves_in_box && !options.ignore_periodic && !box.text.empty() && !origin)
    comment.file.fail_at_line(comment.line, "Origin of three numbers", in_quotes(comment.text));
  take_periodic_box(fmt::format("{}, line {}", comment.file.name(), comment.line), box.text, box.box,
                    "a periodic box as Lattice=\"...\" of nine numbers, its three vectors, with pbc=\"T T F\"", options,
                    input, origin.value_or(Point3{}));
  if (!input.periodic.empty() || input.box) return;
  input.box = closed_box(comment);
  if (box.text.empty() && options.ignore_periodic && !box.mention.empty()) input.ignored = in_quotes(box.mention);
  input.unread_box = options.ignore_periodic ? "" : box.mention;
}

class XyzFrames final : public Frames {
 public:
  XyzFrames(const FileBytes& file, const SphereFileOptions& options) : file_(file), options_(options) {
    for_frames(file, [&](FileLines& cursor) { frames_.push_back(read_frame(file, cursor, frames_.empty())); });
  }
  size_t count() const override { return frames_.size(); }

  SphereFile read(size_t k, SphereRows& rows) const override {
    const Frame& frame = frames_[k];
    SphereFile input;
    const Comment comment{file_, frame.comment_line, frame.comment};
    read_box(comment, options_, input);
    read_sphere_lines(file_, frame.comment_line, columns_of(file_, frame, comment, options_), frame.lines, options_,
                      rows, input);
    input.format = "XYZ " + input.format;
    return input;
  }

 private:
  const FileBytes& file_;
  const SphereFileOptions& options_;
  std::vector<Frame> frames_;
};

}  // namespace

std::unique_ptr<Frames> xyz_frames(const FileBytes& file, const SphereFileOptions& options) {
  return std::make_unique<XyzFrames>(file, options);
}

}  // namespace spherepair
