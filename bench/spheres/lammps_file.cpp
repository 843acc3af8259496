// SPDX-License-Identifier: MIT
// Reads spheres from LAMMPS's text dumps (docs.lammps.org/dump.html): sections that begin with ITEM: NAME, of which
// ITEM: ATOMS ends a frame and names its columns.
#include <fmt/format.h>

#include <algorithm>

#include "bench/spheres/frames.h"
#include "bench/text/fields.h"

namespace spherepair {
namespace {

constexpr std::string_view item = "ITEM: ";

struct DumpBox {
  uint64_t line = 0;       // of ITEM: BOX BOUNDS
  std::string text = {};   // the rest of that line
  std::string flags = {};  // two letters an axis: pp is periodic, f, s and m are not
  ListBox box = {};
  std::array<double, 3> low = {};  // the lower corner
  bool along_axes = false;
};

struct DumpFrame {
  uint64_t names_line = 0;
  std::vector<std::string> names;
  std::string units;
  DumpBox box;
  SphereLines lines;
};

std::vector<double> numbers_in(const FileBytes& file, FileLines& cursor, size_t count) {
  const uint64_t line = cursor.line;
  if (cursor.at_end()) file.fail_at_line(line, fmt::format("{} numbers of the box", count), "the end of the file");
  return finite_numbers(file, line, words_in(cursor.next()), count);
}

// Sets the edges. The bounds of a tilted box enclose it, so its edges are shorter by the tilts.
void set_edges(DumpBox& box, const std::array<std::vector<double>, 3>& bounds, bool tilted) {
  const double xy = tilted ? bounds[0][2] : 0, xz = tilted ? bounds[1][2] : 0, yz = tilted ? bounds[2][2] : 0;
  const double below[3] = {std::min({0.0, xy, xz, xy + xz}), std::min(0.0, yz), 0};
  const double above[3] = {std::max({0.0, xy, xz, xy + xz}), std::max(0.0, yz), 0};
  for (size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = bounds[axis][0] - below[axis];
    box.box.rows[axis][axis] = bounds[axis][1] - above[axis] - box.low[axis];
  }
  box.box.rows[1][0] = xy, box.box.rows[2][0] = xz, box.box.rows[2][1] = yz;
  box.along_axes = xy == 0 && xz == 0 && yz == 0;
}

// Reads BOX BOUNDS pp pp ff, BOX BOUNDS xy xz yz pp pp pp, or BOX BOUNDS abc origin pp pp pp.
DumpBox read_bounds(const FileBytes& file, FileLines& cursor, std::string_view head) {
  DumpBox box{.line = cursor.line - 1, .text = std::string(trimmed(head))};
  std::vector<std::string> words = words_in(head);
  const bool tilted = words.size() > 2 && words[0] == "xy", general = words.size() > 1 && words[0] == "abc";
  words.erase(words.begin(), words.begin() + (tilted ? 3 : general ? 2 : 0));
  for (size_t axis = 0; axis < words.size(); ++axis) {
    const bool is_open = words[axis].size() == 2 && words[axis].find_first_not_of("fsm") == std::string::npos;
    if (!is_open && words[axis] != "pp")
      words.clear();
    else
      box.flags += words[axis];
  }
  if (words.size() != 3)
    file.fail_at_line(box.line,
                      "BOX BOUNDS and for each axis whether it is periodic: pp, ff, ss or the like, such as pp pp ff",
                      in_quotes(head));
  std::array<std::vector<double>, 3> bounds;
  for (size_t axis = 0; axis < 3; ++axis) {
    box.box.periodic[axis] = words[axis] == "pp";
    bounds[axis] = numbers_in(file, cursor, general ? 4 : tilted ? 3 : 2);
    if (general) std::copy_n(bounds[axis].begin(), 3, box.box.rows[axis].begin()), box.low[axis] = bounds[axis][3];
  }
  if (!general) set_edges(box, bounds, tilted);
  for (size_t axis = 0; axis < 3 && !general; ++axis)
    if (const double edge = box.box.rows[axis][axis]; edge < 0 || (edge == 0 && box.box.periodic[axis]))
      file.fail_at_line(box.line + 1 + axis,
                        "an upper bound above the lower one (of a tilted box the bounds include the tilt)",
                        fmt::format("{} {}", bounds[axis][0], bounds[axis][1]));
  return box;
}

DumpFrame read_dump_frame(const FileBytes& file, FileLines& cursor) {
  DumpFrame frame;
  uint64_t count_line = 0, spheres = 0;
  while (true) {
    const uint64_t line = cursor.line;
    const char* expected =
        "ITEM: NUMBER OF ATOMS and ITEM: BOX BOUNDS (BOX BOUNDS ff ff ff for an open one) before ITEM: ATOMS";
    if (cursor.at_end()) file.fail_at_line(line, expected, "the end of the file");
    const std::string_view text = cursor.next();
    const auto begins = [&](std::string_view name) {
      return text.substr(std::min(item.size(), text.size())).starts_with(name);
    };
    if (!text.starts_with(item)) file.fail_at_line(line, "ITEM: and the name of a section", in_quotes(text));
    if (begins("NUMBER OF ATOMS")) {
      count_line = cursor.line;
      spheres = read_sphere_count(file, cursor, "the number of atoms");
    } else if (begins("BOX BOUNDS")) {
      frame.box = read_bounds(file, cursor, text.substr(item.size() + 10));
    } else if (begins("UNITS")) {
      frame.units = trimmed(cursor.next());
    } else if (begins("TIMESTEP") || begins("TIME")) {
      cursor.next();
    } else if (!begins("ATOMS") || count_line == 0 || frame.box.line == 0) {
      file.fail_at_line(line, expected, in_quotes(text));
    } else {
      frame.names_line = line;
      frame.names = words_in(text.substr(item.size() + 5));
      frame.lines = pass_over_spheres(file, cursor, spheres, fmt::format("line {}", count_line));
      return frame;
    }
  }
}

// Names of columns. Takes unwrapped coordinates if there are no others; element or type is the species.
std::vector<NamedColumn> named_columns(const FileBytes& file, const DumpFrame& frame) {
  const auto has = [&](const char* name) { return std::ranges::count(frame.names, name) > 0; };
  const bool wrapped = has("x") || has("y") || has("z");
  if (!wrapped && !has("xu") && (has("xs") || has("xsu")))
    file.fail_at_line(frame.names_line, "coordinates x y z, or xu yu zu; write them by `dump ... custom ... id x y z`",
                      "coordinates scaled by the box");
  std::vector<NamedColumn> columns;
  for (const std::string& name : frame.names) {
    const bool unwrapped = name == "xu" || name == "yu" || name == "zu";
    const bool species = name == "element" || (name == "type" && !has("element"));
    columns.push_back({species ? "species" : unwrapped && !wrapped ? name.substr(0, 1) : name});
  }
  return columns;
}

Columns columns_of_dump(const FileBytes& file, const DumpFrame& frame, const SphereFileOptions& options) {
  std::vector<NamedColumn> as_written;
  for (const std::string& name : frame.names) as_written.push_back({name});
  if (!options.columns.empty()) return columns_of_option(options.columns, as_written, file.name());
  Columns columns =
      columns_of_names(fmt::format("{}, line {}", file.name(), frame.names_line), named_columns(file, frame));
  columns.text = all_names(as_written);
  columns.by = fmt::format("by the names in line {}", frame.names_line);
  if (!frame.units.empty()) columns.units = fmt::format("LAMMPS's units {}", frame.units);
  return columns;
}

class LammpsFrames final : public Frames {
 public:
  LammpsFrames(const FileBytes& file, const SphereFileOptions& options) : file_(file), options_(options) {
    for_frames(file, [&](FileLines& cursor) { frames_.push_back(read_dump_frame(file, cursor)); });
  }
  size_t count() const override { return frames_.size(); }

  SphereFile read(size_t k, SphereRows& rows) const override {
    const DumpFrame& frame = frames_[k];
    const DumpBox& box = frame.box;
    SphereFile input;
    take_periodic_box(fmt::format("{}, line {}", file_.name(), box.line),
                      box.box.is_open() ? "" : fmt::format("BOX BOUNDS {}", box.text), box.box, "", options_, input,
                      box.low);
    if (box.flags == "ffffff" && box.along_axes) input.box = box_along_axes(box.box, box.low);
    read_sphere_lines(file_, frame.names_line, columns_of_dump(file_, frame, options_), frame.lines, options_, rows,
                      input);
    input.format = "LAMMPS dump " + input.format;
    return input;
  }

 private:
  const FileBytes& file_;
  const SphereFileOptions& options_;
  std::vector<DumpFrame> frames_;
};

}  // namespace

std::unique_ptr<Frames> lammps_frames(const FileBytes& file, const SphereFileOptions& options) {
  return std::make_unique<LammpsFrames>(file, options);
}

}  // namespace spherepair
