// SPDX-License-Identifier: MIT
// Reads spheres from the arrays of an NPZ file: `spheres`, or a single array, as an NPY file has them; else positions,
// radii and velocities, an array each. The arrays box and pbc are a periodic box.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "bench/npy/npy_array.h"
#include "bench/npy/zip_archive.h"
#include "bench/spheres/frames.h"
#include "bench/text/known_columns.h"

namespace spherepair {
namespace {

constexpr std::string_view extension = ".npy";

// An array of numbers: a table of 1 row (), n rows (n,) or n rows and c columns (n, c); 0 columns: none of these
// shapes.
struct Array {
  std::string name;
  FileBytes file;
  NpyHeader header = read_npy_header(file);

  uint64_t columns() const { return header.structured || header.shape.size() > 2 ? 0 : header.shape[1]; }
};

Array array_in(const FileBytes& file, const ZipMember& member, const std::string& name) {
  Array array{name, unpacked(file, member)};
  std::vector<uint64_t>& shape = array.header.shape;
  while (!array.header.structured && shape.size() < 2) shape.push_back(1);
  return array;
}

class Archive {
 public:
  explicit Archive(const FileBytes& file) : file_(file), members_(zip_members(file)) {}

  // The names of all arrays but the box, in the file's order.
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const ZipMember& member : members_)
      if (const std::string name = name_of(member); !name.empty() && name != "box" && name != "pbc")
        names.push_back(name);
    return names;
  }
  std::optional<Array> array(std::string_view name) const {
    const auto member = std::ranges::find(members_, name, name_of);
    return member == members_.end() ? std::nullopt : std::optional(array_in(file_, *member, std::string(name)));
  }

 private:
  static std::string name_of(const ZipMember& member) {
    return member.name.ends_with(extension) ? member.name.substr(0, member.name.size() - extension.size()) : "";
  }

  const FileBytes& file_;
  std::vector<ZipMember> members_;
};

// Whether the array is read: it has a known name or, with --columns, a name in it.
bool is_wanted(const std::string& name, const SphereFileOptions& options) {
  if (options.columns.empty()) return known_name(name) != nullptr;
  return std::ranges::any_of(options.columns, [&](const std::string& word) {
    return plain_name(word.substr(word.find('=') + 1)).name == plain_name(name).name;
  });
}

[[noreturn]] void refuse_shape(const Array& array, std::string_view expected) {
  array.file.fail_at_byte(array.header.shape_at, expected, fmt::format("({})", fmt::join(array.header.shape, ", ")));
}

// Reads several arrays side by side, which must have equally many rows.
SphereFile read_arrays(const FileBytes& file, const Archive& archive, const SphereFileOptions& options,
                       SphereRows& rows) {
  std::vector<Array> arrays;
  std::vector<NamedColumn> names;
  for (const std::string& name : archive.names()) {
    const bool wanted = is_wanted(name, options);
    if (wanted) arrays.push_back(*archive.array(name));
    names.push_back({name, wanted ? arrays.back().columns() : 0});
    if (wanted && options.columns.empty() && names.back().count != known_name(name)->count)
      refuse_shape(arrays.back(), known_name(name)->count == 3 ? "shape (n, 3)" : "shape (n,)");
  }
  if (!options.columns.empty() && options.columns[0].find('=') == std::string::npos)
    throw std::invalid_argument(
        fmt::format("--columns: name the arrays of {}, such as --columns pos=NAME,radius=NAME; it has '{}'",
                    file.name(), all_names(names)));
  Columns columns = options.columns.empty() ? columns_of_names(file.name(), names)
                                            : columns_of_option(options.columns, names, file.name());
  if (options.columns.empty()) columns.by = "by the names of the arrays";
  NumberTable table{.file = file, .meaning = columns};
  const Array* first = nullptr;
  size_t at = 0;
  for (const Array& array : arrays) {
    Columns own{.count = array.columns()};
    for (size_t q = 0; q < quantity_names.size(); ++q)
      if (const auto& column = columns.columns[q]; column && *column >= at && *column < at + own.count)
        own.columns[q] = *column - at;
    at += own.count;
    if (own.quantities() == 0) continue;
    const NumberTable part = plain_table(array.file, array.header, own);
    if (!first) first = &array, table.rows = part.rows;
    if (part.rows != table.rows)
      array.file.fail_at_byte(array.header.shape_at,
                              fmt::format("{} rows, as in {}", table.rows, in_quotes(first->name)),
                              fmt::to_string(part.rows));
    table.columns.insert(table.columns.end(), part.columns.begin(), part.columns.end());
  }
  SphereFile input;
  read_numbers(table, options, rows, input);
  input.format = fmt::format("({}): {}", columns.text, describe(columns));
  return input;
}

// All numbers of an array, row by row.
std::vector<double> numbers_of(Array& array) {
  if (array.columns() < 1 || array.columns() > 3) return {};
  if (array.header.fields[0].dtype == "|b1") array.header.fields[0].dtype = "|u1";
  Columns columns{.count = array.columns()};
  for (size_t k = 0; k < columns.count; ++k) columns.columns[k] = k;
  const NumberTable table = plain_table(array.file, array.header, columns);
  std::vector<double> numbers;
  for (uint64_t row = 0; row < std::min<uint64_t>(table.rows, 4); ++row)
    for (const NumberColumn& column : table.columns) {
      numbers.push_back(number_at(column, row));
      if (!std::isfinite(numbers.back()))
        array.file.fail_at_byte(column.byte_of(row), "a finite number", fmt::to_string(numbers.back()));
    }
  return numbers;
}

// Reads box, three rows or three lengths, and pbc, one flag or three. Without pbc the box is periodic along all axes.
void read_box(const Archive& archive, const SphereFileOptions& options, SphereFile& input) {
  std::optional<Array> box = archive.array("box"), pbc = archive.array("pbc");
  if (!box && !pbc) return;
  ListBox taken;
  std::string text;
  if (box) {
    const std::vector<double> numbers = numbers_of(*box);
    if (numbers.size() != 9 && (numbers.size() != 3 || box->columns() != 1))
      refuse_shape(*box, "a box of shape (3, 3), a vector a row, or (3,), three lengths");
    for (size_t k = 0; k < numbers.size(); ++k)
      numbers.size() == 9 ? taken.rows[k / 3][k % 3] = numbers[k] : taken.rows[k][k] = numbers[k];
    text = fmt::format("box ({}), ({}), ({})", fmt::join(taken.rows[0], " "), fmt::join(taken.rows[1], " "),
                       fmt::join(taken.rows[2], " "));
  }
  const std::vector<double> flags = pbc ? numbers_of(*pbc) : std::vector<double>{1};
  if (flags.size() != 3 && flags.size() != 1) refuse_shape(*pbc, "pbc of shape (3,), a flag an axis");
  for (size_t k = 0; k < 3; ++k) taken.periodic[k] = flags[flags.size() == 3 ? k : 0] != 0;
  if (pbc) text += fmt::format("{}pbc ({})", box ? ", " : "", fmt::join(flags, " "));
  take_periodic_box(box ? box->file.name() : pbc->file.name(), taken.is_open() ? "" : text,
                    box ? std::optional(taken) : std::nullopt, "an array box beside pbc", options, input, {});
}

}  // namespace

SphereFile read_npz(const FileBytes& file, const SphereFileOptions& options, SphereRows& rows) {
  const Archive archive(file);
  const std::vector<std::string> names = archive.names();
  std::optional<Array> all = archive.array("spheres");
  if (!all && names.size() == 1 && !known_name(names[0])) all = archive.array(names[0]);
  SphereFile boxed;
  read_box(archive, options, boxed);
  SphereFile input = all ? read_npy(all->file, options, rows) : read_arrays(file, archive, options, rows);
  input.given.boxes = boxed.given.boxes, input.periodic = boxed.periodic, input.ignored = boxed.ignored;
  input.box = boxed.box;
  input.format = fmt::format("NPZ {}", all ? in_quotes(all->name) + ": " + input.format : input.format);
  return input;
}

}  // namespace spherepair
