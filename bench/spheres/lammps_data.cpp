// SPDX-License-Identifier: MIT
// Reads spheres from LAMMPS's data files (docs.lammps.org/read_data.html): a comment, a header of numbers and keywords,
// then sections, of which Atoms and Velocities are read.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <unordered_map>

#include "bench/io/numbers.h"
#include "bench/spheres/frames.h"
#include "bench/text/fields.h"

namespace spherepair {
namespace {

// The columns of an atom by the style in the comment after Atoms. Three image numbers may follow.
constexpr std::pair<std::string_view, std::string_view> styles[] = {
    {"angle", "id molecule type x y z"},     {"atomic", "id type x y z"},
    {"bond", "id molecule type x y z"},      {"bpm/sphere", "id molecule type diameter density x y z"},
    {"charge", "id type q x y z"},           {"full", "id molecule type q x y z"},
    {"molecular", "id molecule type x y z"}, {"sphere", "id type diameter density x y z"}};

struct DataHeader {
  std::string units;
  uint64_t atoms = 0, atoms_line = 0;
  uint64_t box_line = 0;  // the last of the box
  ListBox box = {};
  Point3 low = {};
  std::array<bool, 3> has_edge = {};
};

struct Section {
  uint64_t line = 0;       // of its name; 0: there is no such section
  std::string text = {};   // of that line
  std::string style = {};  // in its comment
};

std::vector<std::string> uncommented_words(std::string_view text) { return words_in(without_comment(text)); }

// 0 4 xlo xhi; 1 0 0 xy xz yz; 4 0 0 avec.
void read_box_line(const FileBytes& file, uint64_t line, std::span<const std::string> given, const std::string& keyword,
                   DataHeader& header) {
  constexpr std::string_view bounds[] = {"xlo xhi", "ylo yhi", "zlo zhi"}, vectors[] = {"avec", "bvec", "cvec"};
  const auto numbers = [&](size_t count) { return finite_numbers(file, line, given, count); };
  auto& rows = header.box.rows;
  for (size_t axis = 0; axis < 3; ++axis) {
    if (keyword == bounds[axis]) {
      const auto ends = numbers(2);
      if (!(ends[0] < ends[1]))
        file.fail_at_line(line, "an upper bound above the lower one", fmt::format("{} {}", ends[0], ends[1]));
      rows[axis][axis] = ends[1] - ends[0];
      header.low[axis] = ends[0];
    } else if (keyword == vectors[axis]) {
      std::ranges::copy(numbers(3), rows[axis].begin());
    } else {
      continue;
    }
    header.has_edge[axis] = true;
    header.box_line = line;
  }
  if (keyword == "abc origin") std::ranges::copy(numbers(3), header.low.begin());
  if (keyword != "xy xz yz") return;
  const auto tilts = numbers(3);
  rows[1][0] = tilts[0], rows[2][0] = tilts[1], rows[2][1] = tilts[2];
}

// Reads up to the first section, whose name does not begin with a number.
DataHeader read_header(const FileBytes& file, FileLines& cursor) {
  DataHeader header;
  header.box.periodic = {true, true, true};
  const std::string_view comment = cursor.next();
  if (const size_t at = comment.find("units = "); at != comment.npos)
    header.units = trimmed(comment.substr(at + 8, comment.find(',', at) - at - 8));
  while (!cursor.at_end()) {
    const FileLines before = cursor;
    const std::vector<std::string> words = uncommented_words(cursor.next());
    if (words.empty()) continue;
    const auto name = std::ranges::find_if(words, [](const std::string& word) { return !parse_decimal(word); });
    if (name == words.begin()) {
      cursor = before;
      break;
    }
    const std::string keyword = fmt::format("{}", fmt::join(name, words.end(), " "));
    if (keyword == "atoms") {
      const auto count = whole_number_of(name - words.begin() == 1 ? words[0] : "", 0, kMostSpheres);
      if (!count)
        file.fail_at_line(before.line, fmt::format("the number of atoms, at most {}", kMostSpheres),
                          in_quotes(words[0]));
      header.atoms = *count;
      header.atoms_line = before.line;
    }
    read_box_line(file, before.line, {words.begin(), name}, keyword, header);
  }
  const uint64_t end = cursor.line;
  if (header.atoms_line == 0 || std::ranges::count(header.has_edge, false))
    file.fail_at_line(end, "a header with the lines `N atoms`, `LOW HIGH xlo xhi`, ylo yhi and zlo zhi",
                      cursor.at_end() ? "the end of the file" : in_quotes(cursor.next()));
  return header;
}

// Skips other sections, the name of this one and the blank line below it.
Section find_section(const FileBytes& file, FileLines& cursor, std::string_view name) {
  while (!cursor.at_end()) {
    const uint64_t line = cursor.line;
    const std::string_view text = cursor.next();
    const size_t mark = std::min(text.find('#'), text.size());
    if (trimmed(text.substr(0, mark)) != name) continue;
    const uint64_t blank = cursor.line;
    if (!cursor.at_end())
      if (const std::string_view below = cursor.next(); !trimmed(below).empty())
        file.fail_at_line(blank, fmt::format("a blank line below {}", name), in_quotes(below));
    return {line, std::string(text), std::string(trimmed(text.substr(std::min(mark + 1, text.size()))))};
  }
  return {};
}

SphereLines lines_of_section(const FileBytes& file, FileLines& cursor, const DataHeader& header) {
  SphereLines lines = pass_over_spheres(file, cursor, header.atoms, fmt::format("line {}", header.atoms_line), "line");
  lines.comments = true;
  cursor.skip_blank_lines();
  FileLines ahead = cursor;
  if (const auto words = uncommented_words(ahead.next()); !words.empty() && parse_decimal(words[0]))
    file.fail_at_line(
        cursor.line,
        fmt::format("the end of the section after {} lines, as line {} says", header.atoms, header.atoms_line),
        in_quotes(cursor.rest.substr(0, cursor.rest.find('\n'))));
  return lines;
}

Columns columns_of(const FileBytes& file, const Section& section, const SphereLines& lines,
                   const SphereFileOptions& options) {
  const auto style = std::ranges::find(styles, section.style, [](const auto& each) { return each.first; });
  std::vector<NamedColumn> names;
  std::vector<std::string> words;
  if (style != std::end(styles)) words = words_in(style->second);
  if (style != std::end(styles) && lines.spheres > 0) {
    FileLines first = lines.chunks.front().start;
    if (uncommented_words(first.next()).size() == words.size() + 3) words.insert(words.end(), {"ix", "iy", "iz"});
  }
  for (const std::string& word : words) names.push_back({word == "type" ? "species" : word});
  if (!options.columns.empty()) return columns_of_option(options.columns, names, file.name());
  if (style == std::end(styles)) {
    std::vector<std::string_view> known;
    for (const auto& [name, columns] : styles) known.push_back(name);
    file.fail_at_line(section.line,
                      fmt::format("Atoms # STYLE, one of {}: add the style, or name the columns, such as --columns "
                                  "_,species,x,y,z",
                                  fmt::join(known, ", ")),
                      in_quotes(section.text));
  }
  Columns columns = columns_of_names(fmt::format("{}, line {}", file.name(), section.line), names);
  columns.text = fmt::format("{}", fmt::join(words, " "));
  columns.by = fmt::format("by the style {} in line {}", section.style, section.line);
  return columns;
}

// Reads lines of id vx vy vz, and more in some styles, in any order of the atoms.
void read_velocities(const FileBytes& file, const SphereLines& atoms, const SphereLines& lines, SphereRows& rows,
                     SphereFile& input) {
  if (atoms.spheres == 0) return;
  std::unordered_map<std::string_view, uint64_t> atom_of_id;
  std::vector<std::string_view> fields;
  FileLines cursor = atoms.chunks.front().start;
  for (uint64_t k = 0; k < atoms.spheres; ++k) {
    split_fields(cursor.next(), 1, fields);
    atom_of_id.emplace(fields.at(0), k);
  }
  cursor = lines.chunks.front().start;
  FileLines first = cursor;
  Columns columns{.count = uncommented_words(first.next()).size(), .text = "id vx vy vz ..."};
  columns.by = "by the section Velocities";
  for (size_t k = 0; k < 3; ++k) columns.columns[QUANTITY_VX + k] = k + 1;
  if (columns.count < 4) file.fail_at_line(cursor.line, "id vx vy vz", fmt::format("{} numbers", columns.count));
  rows.velocities.assign(atoms.spheres, vec4{0, 0, 0, 0});
  RowReader reader(file, columns, false);
  for (uint64_t k = 0; k < lines.spheres; ++k) {
    const uint64_t line = cursor.line;
    const std::string_view text = cursor.next();
    split_fields(without_comment(text), columns.count + 1, fields);
    const auto atom = atom_of_id.find(fields.empty() ? "" : fields[0]);
    if (atom == atom_of_id.end()) file.fail_at_line(line, "the id of an atom in Atoms, once", in_quotes(text));
    reader.read(line, text, fields, atom->second, rows);
    atom_of_id.erase(atom);
  }
  input.values += 3 * lines.spheres;
  input.changed += reader.changed();
}

std::string words_of_box(const DataHeader& header) {
  const auto& rows = header.box.rows;
  return fmt::format("boundary p p p (LAMMPS's default), box ({}), ({}), ({})", fmt::join(rows[0], " "),
                     fmt::join(rows[1], " "), fmt::join(rows[2], " "));
}

}  // namespace

SphereFile read_lammps_data(const FileBytes& file, const SphereFileOptions& options, SphereRows& rows) {
  require_text(file);
  FileLines cursor = lines_of(file);
  const DataHeader header = read_header(file, cursor);
  const Section section = find_section(file, cursor, "Atoms");
  if (section.line == 0) file.fail_at_line(cursor.line, "a section Atoms", "the end of the file");
  const SphereLines atoms = lines_of_section(file, cursor, header);
  Columns columns = columns_of(file, section, atoms, options);
  if (!header.units.empty()) columns.units = fmt::format("LAMMPS's units {}", header.units);
  SphereFile input;
  take_periodic_box(fmt::format("{}, line {}", file.name(), header.box_line), words_of_box(header), header.box, "",
                    options, input, header.low);
  read_sphere_lines(file, section.line, columns, atoms, options, rows, input);
  if (find_section(file, cursor, "Velocities").line > 0)
    read_velocities(file, atoms, lines_of_section(file, cursor, header), rows, input);
  input.format = "LAMMPS data " + input.format;
  return input;
}

}  // namespace spherepair
