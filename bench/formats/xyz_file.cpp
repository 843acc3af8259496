// SPDX-License-Identifier: MIT
// Reads spheres from XYZ and extended XYZ: a line with their number, a comment line, a line per sphere; then the next
// frame.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "bench/formats/sphere_file.h"
#include "bench/formats/xyz_columns.h"
#include "bench/io/file_lines.h"
#include "bench/io/numbers.h"
#include "common/backend/cpu_team.h"

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
      file.fail_at_line(cursor.line, fmt::format("{} spheres as line {} says", frame.spheres, count_line),
                        fmt::format("the end of the file after {}", sphere));
    cursor.next();
  }
  return frame;
}

class LineReader {
 public:
  LineReader(const FileBytes& file, const XyzColumns& columns) : file_(file), columns_(columns) {}

  void read(std::string_view text, uint64_t line, vec4& sphere, std::string_view* species) {
    split_fields(text, columns_.count + 1, fields_);
    if (fields_.size() != columns_.count)
      file_.fail_at_line(line, fmt::format("{} columns ({})", columns_.count, columns_.text),
                         fmt::format("{}{}: {}", fields_.size() > columns_.count ? "more than " : "",
                                     std::min(fields_.size(), columns_.count), in_quotes(text)));
    sphere.x = number(columns_.position, line, "x");
    sphere.y = number(columns_.position + 1, line, "y");
    sphere.z = number(columns_.position + 2, line, "z");
    if (columns_.radius) sphere.w = number(*columns_.radius, line, "radius");
    if (species) *species = fields_[*columns_.species];
  }
  uint64_t changed() const { return changed_; }

 private:
  float number(size_t column, uint64_t line, const char* what) {
    const Decimal decimal = read_number(file_, line, fields_, column, what, columns_.radius == column);
    changed_ += decimal.changed;
    return decimal.rounded;
  }

  const FileBytes& file_;
  const XyzColumns& columns_;
  std::vector<std::string_view> fields_;
  uint64_t changed_ = 0;
};

// Species are kept where there is room for them.
uint64_t read_chunk(const FileBytes& file, const XyzColumns& columns, Chunk chunk, std::vector<vec4>& spheres,
                    std::vector<std::string_view>& species) {
  LineReader reader(file, columns);
  for (uint64_t k = 0; k < chunk.spheres; ++k) {
    const uint64_t line = chunk.start.line;
    const uint64_t sphere = chunk.first_sphere + k;
    reader.read(chunk.start.next(), line, spheres[sphere], species.empty() ? nullptr : &species[sphere]);
  }
  return reader.changed();
}

// Throws the first error in the file, whichever thread finds one first.
uint64_t read_spheres(const FileBytes& file, const XyzColumns& columns, const Frame& frame, int threads,
                      std::vector<vec4>& spheres, std::vector<std::string_view>& species) {
  TeamErrors errors;
  uint64_t changed = 0;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1) reduction(+ : changed)
  for (size_t k = 0; k < frame.chunks.size(); ++k)
    errors.run(k, [&] { changed += read_chunk(file, columns, frame.chunks[k], spheres, species); });
  errors.rethrow();
  return changed;
}

XyzColumns columns_of(const FileBytes& file, const Frame& frame) {
  if (const auto named = named_columns(file, frame.comment_line, frame.comment)) return *named;
  if (frame.chunks.empty()) return {.text = "no spheres"};
  FileLines first = frame.chunks.front().start;
  const uint64_t line = first.line;
  return classic_columns(file, line, first.next());
}

// All of which must be complete.
std::vector<Frame> find_frames(const FileBytes& file) {
  std::vector<Frame> frames;
  FileLines cursor{file.bytes()};
  while (frames.empty() || !cursor.at_end()) {
    frames.push_back(read_frame(file, cursor, frames.empty()));
    cursor.skip_blank_lines();
  }
  return frames;
}

SphereFile read_one(const FileBytes& file, const Frame& frame, const SphereFileOptions& options,
                    std::vector<std::string_view>& species) {
  const XyzColumns columns = columns_of(file, frame);
  if (options.species && frame.spheres > 0 && !columns.species)
    file.fail_at_line(frame.comment_line,
                      "a column of species, by Properties= with species:S:1 or as the first of four", columns.text);
  SphereFile input;
  input.own_radii = columns.radius.has_value();
  if (frame.spheres > 0) check_radius(file, input.own_radii, options);
  input.scene.positions.resize(frame.spheres, vec4{0, 0, 0, options.radius.value_or(0)});
  if (options.species) species.resize(frame.spheres);
  input.values = frame.spheres * (input.own_radii ? 4 : 3);
  input.changed = read_spheres(file, columns, frame, reading_threads(options), input.scene.positions, species);
  input.format = fmt::format("{}XYZ ({})", columns.named ? "extended " : "", columns.text);
  return input;
}

// The same names for all frames.
void index_species(std::vector<SphereFile>& frames, const std::vector<std::vector<std::string_view>>& species) {
  std::map<std::string_view, uint> index;
  for (const auto& each : species)
    for (const std::string_view name : each) index.emplace(name, 0);
  std::vector<std::string> names;
  for (auto& [name, k] : index) k = uint(names.size()), names.emplace_back(name);
  for (size_t k = 0; k < frames.size(); ++k) {
    frames[k].species = names;
    for (const std::string_view name : species[k]) frames[k].species_index.push_back(index.at(name));
  }
}

std::vector<SphereFile> read_frames(const FileBytes& file, const std::vector<Frame>& frames, uint64_t first,
                                    uint64_t count, const SphereFileOptions& options) {
  std::vector<SphereFile> read;
  std::vector<std::vector<std::string_view>> species(count);
  for (uint64_t k = 0; k < count; ++k) {
    read.push_back(read_one(file, frames[first + k], options, species[k]));
    read.back().frame = first + k;
    read.back().frames = frames.size();
  }
  if (options.species) index_species(read, species);
  return read;
}

}  // namespace

SphereFile read_xyz(const FileBytes& file, const SphereFileOptions& options) {
  require_text(file);
  const uint64_t wanted = options.frame.value_or(0);
  const std::vector<Frame> frames = find_frames(file);
  if (wanted >= frames.size())
    throw std::invalid_argument(fmt::format("{} has {} frame{}, counted from 0, so --frame {} is not among them",
                                            file.name(), frames.size(), frames.size() == 1 ? "" : "s", wanted));
  return std::move(read_frames(file, frames, wanted, 1, options).front());
}

std::vector<SphereFile> read_xyz_frames(const FileBytes& file, const SphereFileOptions& options) {
  require_text(file);
  const std::vector<Frame> frames = find_frames(file);
  return read_frames(file, frames, 0, frames.size(), options);
}

}  // namespace spherepair
