// SPDX-License-Identifier: MIT
// Spheres of PLY files: the same in text and in both byte orders, whatever stands beside them.
#include "tests/bench/sphere_complaints.h"

namespace spherepair {
namespace {

// Numbers as the file's format writes them.
class PlyData {
 public:
  explicit PlyData(const std::string& format) : format_(format) {}

  template <typename Number>
  PlyData& add(Number number) {
    std::string bytes(sizeof number, 0);
    std::memcpy(bytes.data(), &number, sizeof number);
    if ((format_ == "binary_big_endian") != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
    data_ += format_ == "ascii" ? fmt::format("{} ", number) : bytes;
    return *this;
  }
  PlyData& end_row() {
    if (format_ == "ascii") data_.back() = '\n';
    return *this;
  }
  std::string file(const std::string& elements) const {
    return "ply\ncomment by hand\nformat " + format_ + " 1.0\n" + elements + "end_header\n" + data_;
  }

 private:
  std::string format_, data_;
};

const char* const ply_formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
const std::string xyz_floats = "property float x\nproperty float y\nproperty float z\n";

SphereFile read_ply_bytes(const std::string& bytes, const SphereFileOptions& options = {}) {
  const ScratchFolder folder;
  return read_sphere_file(folder.write("a.ply", bytes), options);
}

std::vector<std::array<float, 4>> numbers_of(const SphereFile& file) {
  std::vector<std::array<float, 4>> numbers;
  for (const vec4& p : file.scene.positions) numbers.push_back({p.x, p.y, p.z, p.w});
  return numbers;
}
using Numbers = std::vector<std::array<float, 4>>;

TEST(PlyFile, VertexPropertiesOfAnyTypeAreReadByTheirNames) {
  const std::string elements =
      "element vertex 2\nproperty uchar red\nproperty double z\nproperty float radius\nproperty short x\n"
      "property uint y\nproperty float32 vx\nproperty int8 vy\nproperty float64 vz\n";
  for (const char* format : ply_formats) {
    PlyData data(format);
    for (const int k : {0, 1})
      data.add(uint8_t(200 + k))
          .add(0.5 + k)
          .add(0.25f)
          .add(int16_t(-300 - k))
          .add(uint32_t(70000 + k))
          .add(1.5f)
          .add(int8_t(-2))
          .add(2.5)
          .end_row();
    const SphereFile file = read_ply_bytes(data.file(elements));
    EXPECT_EQ(numbers_of(file), (Numbers{{-300, 70000, 0.5, 0.25}, {-301, 70001, 1.5, 0.25}})) << format;
    ASSERT_EQ(file.scene.velocities.size(), 2u);
    const vec4& v = file.scene.velocities[1];
    EXPECT_EQ((std::array{v.x, v.y, v.z}), (std::array{1.5f, -2.0f, 2.5f})) << format;
    EXPECT_TRUE(file.own_radii);
    EXPECT_TRUE(file.format.starts_with(fmt::format("PLY {} (red z radius x y vx vy vz)", format))) << file.format;
  }
}

TEST(PlyFile, OtherElementsAndListsArePassedOver) {
  const std::string elements =
      "element camera 2\nproperty int id\nproperty list uint float path\nelement nothing 7\nelement vertex 2\n"
      "property float x\nproperty list ushort double neighbours\nproperty float y\nproperty list ushort int empty\n"
      "property float z\nelement face 1\nproperty list uint int vertex_indices\n";
  for (const char* format : ply_formats) {
    PlyData data(format);
    data.add(1).add(2u).add(0.5f).add(0.25f).end_row().add(2).add(0u).end_row();
    data.add(1.0f).add(uint16_t(3)).add(7.5).add(8.5).add(9.5).add(2.0f).add(uint16_t(0)).add(3.0f).end_row();
    data.add(4.0f).add(uint16_t(0)).add(5.0f).add(uint16_t(1)).add(-6).add(6.0f).end_row();
    data.add(3u).add(0).add(1).add(1).end_row();
    EXPECT_EQ(numbers_of(read_ply_bytes(data.file(elements), {.radius = 0.5})),
              (Numbers{{1, 2, 3, 0.5}, {4, 5, 6, 0.5}}))
        << format;
  }
}

TEST(PlyFile, ColumnsAndRadiusAreTheOptions) {
  const std::string elements =
      "element vertex 1\nproperty float px\nproperty float py\nproperty float pz\n"
      "property float size\n";
  for (const char* format : ply_formats) {
    const std::string bytes = PlyData(format).add(1.0f).add(2.0f).add(3.0f).add(4.0f).end_row().file(elements);
    const auto read = [&](const SphereFileOptions& options) { return numbers_of(read_ply_bytes(bytes, options)); };
    EXPECT_EQ(read({.columns = {"x", "y", "z", "diameter"}}), (Numbers{{1, 2, 3, 2}})) << format;
    EXPECT_EQ(read({.columns = {"x=py", "y=px", "z=pz", "radius=size"}}), (Numbers{{2, 1, 3, 4}})) << format;
    EXPECT_EQ(read({.radius = 5, .columns = {"x", "y", "z", "_"}}), (Numbers{{1, 2, 3, 5}})) << format;
    EXPECT_NE(complaint_of([&] { read({}); }).find("columns x, y and z must be among 'px py pz size'"),
              std::string::npos);
    EXPECT_NE(complaint_of([&] {
                read({.columns = {"x", "y", "z"}});
              }).find("a vertex of 3 numbers, by --columns"),
              std::string::npos);
    EXPECT_NE(complaint_of([&] {
                read({.columns = {"x=px", "y=py", "z=pz"}});
              }).find("has no radii"),
              std::string::npos);
  }
}

TEST(PlyFile, LinesMayEndAsInWindows) {
  EXPECT_EQ(numbers_of(read_ply_bytes("ply\r\nformat ascii 1.0\r\nelement vertex 1\r\nproperty float x\r\n"
                                      "property float y\r\nproperty float z\r\nend_header\r\n1 2 3\r\n\r\n",
                                      {.radius = 4})),
            (Numbers{{1, 2, 3, 4}}));
}

void expect_ply_complaint(const std::string& bytes, const std::string& place, const std::string& expected,
                          const std::string& found, const SphereFileOptions& options = {.radius = 1}) {
  expect_complaint("bad.ply", bytes, place, expected, found, options);
}

TEST(PlyFile, BadHeadersAreRefusedWhereTheyAre) {
  const std::string begin = "ply\nformat ascii 1.0\n", vertex = "element vertex 1\n" + xyz_floats;
  expect_ply_complaint("", "line 1", "ply, the first line", "''");
  expect_ply_complaint("PLY\n", "line 1", "ply, the first line", "'PLY'");
  expect_ply_complaint("\x93NUMPY", "line 1", "ply", "an NPY file");
  expect_ply_complaint(begin, "line 3", "end_header", "the end of the file");
  expect_ply_complaint("ply\nformat ascii 2.0\n", "line 2", "format ascii 1.0", "'format ascii 2.0'");
  expect_ply_complaint("ply\nformat binary 1.0\n", "line 2", "format binary_little_endian 1.0", "'format binary 1.0'");
  expect_ply_complaint("ply\nelement vertex 1\n", "line 2", "format before elements", "'element vertex 1'");
  expect_ply_complaint(begin + "element vertex -1\n", "line 3", "element NAME NUMBER", "'element vertex -1'");
  expect_ply_complaint(begin + "element vertex 3000000000\n" + xyz_floats + "end_header\n", "line 3",
                       "at most 2147483647 spheres", "3000000000");
  expect_ply_complaint(begin + "property float x\n", "line 3", "element before its properties", "'property float x'");
  expect_ply_complaint(begin + "element vertex 1\nproperty real x\n", "line 4", "a type: char", "'property real x'");
  expect_ply_complaint(begin + "element vertex 1\nproperty x\n", "line 4", "property TYPE NAME", "'property x'");
  expect_ply_complaint(begin + "element face 1\nproperty list float int i\n", "line 4", "whole numbers", "'property");
  expect_ply_complaint(begin + vertex + "\nend_header\n", "line 7", "format, comment, element", "''");
  expect_ply_complaint(begin + "element face 0\nend_header\n", "line 4", "one element vertex", "'face'");
  expect_ply_complaint(begin + "end_header\n", "line 3", "one element vertex", "no element");
  expect_ply_complaint(begin + vertex + vertex + "end_header\n", "line 11", "one element vertex", "'vertex', 'vertex'");
}

TEST(PlyFile, BadTextIsRefusedWhereItIs) {
  const auto file = [](const std::string& rows, const std::string& more = "") {
    return "ply\nformat ascii 1.0\nelement vertex 2\n" + xyz_floats + more + "end_header\n" + rows;
  };
  const std::string list = "property list uchar int i\n";
  expect_ply_complaint(file("1 2 3\n"), "line 9", "2 rows as line 3 (element vertex) says",
                       "the end of the file after 1");
  expect_ply_complaint(file("1 2 3\n1 2 3\n4 5 6\n"), "line 10", "the end of the file", "'4 5 6'");
  expect_ply_complaint(file("1 2 3\n1 2\n"), "line 9", "3 columns", "2: '1 2'");
  expect_ply_complaint(file("1 2 3\n1 2 3 4\n"), "line 9", "3 columns", "more than 3");
  expect_ply_complaint(file("1 2 3\n1 2 three\n"), "line 9", "a number for z", "'three'");
  expect_ply_complaint(file("1 2 3\n1 nan 3\n"), "line 9", "a finite number", "'nan'");
  expect_ply_complaint(file("1 2 3\n1 2 3\n", "element face 1\n" + list), "line 12", "1 row as line 7",
                       "the end of the file after 0");
  expect_ply_complaint(file("1 2 3 1 8\n1 2 3 2 8\n", list), "line 10", "a list after 3 numbers", "'2'");
  expect_ply_complaint(file("1 2 3\n1 2 3 0\n", list), "line 9", "a list after 3 numbers", "''");
  expect_ply_complaint(file("1 2 3 0\n1 2 3 -1\n", list), "line 10", "a list after 3 numbers", "'-1'");
  expect_ply_complaint(file("1 2 3 0\n1 2 3 1 8 9\n", list), "line 10", "3 columns", "more than 3");
}

TEST(PlyFile, BadBinaryNumbersAreRefusedWhereTheyAre) {
  const auto nan = std::numeric_limits<float>::quiet_NaN();
  const std::string list = "property list uchar int i\n", radius = "property float radius\n";
  for (const char* format : {"binary_little_endian", "binary_big_endian"}) {
    const std::string elements = "element vertex 2\n" + xyz_floats;
    const auto file = [&](const std::vector<float>& numbers, const std::string& header) {
      PlyData data(format);
      for (const float number : numbers) data.add(number);
      return data.file(header);
    };
    const size_t at = file({}, elements).size();
    const auto byte = [](size_t place) { return fmt::format("byte {}", place); };
    expect_ply_complaint(file({1, 2, 3, 4, 5}, elements), byte(at), "2 items of 12 bytes in element vertex (line 4)",
                         "the end of the file after 20 bytes");
    expect_ply_complaint(file({1, 2, 3, 4, 5, 6}, elements) + "x", byte(at + 24), "the end of the file",
                         "1 trailing byte");
    expect_ply_complaint(file({1, 2, 3, 4, nan, 6}, elements), byte(at + 16), "a finite number", "nan (y of sphere 1");
    expect_ply_complaint(file({1, 2, 3, -4, 1, 2, 3, 4}, elements + radius), byte(at + radius.size() + 12),
                         "a radius that is not negative", "-4 (radius of sphere 0", {});
    const size_t in_list = at + list.size();
    const std::string row(12, 0);
    expect_ply_complaint(file({}, elements + list) + row + '\1' + "1234" + row + '\2' + "1234", byte(in_list + 30),
                         "2 items of 4 bytes in element vertex", "the end of the file after 4 bytes");
    expect_ply_complaint(file({}, elements + list) + row + '\1' + "1234" + row, byte(in_list + 29),
                         "1 item of 1 byte in element vertex", "the end of the file after 0 bytes");
    // The second of the two rows has its y where the length of a list before it puts it.
    std::string late = file({}, elements + list) + row + '\1' + "1234" + row + '\0';
    late.replace(in_list + 21, 4, "\xff\xff\xff\xff");
    expect_ply_complaint(late, byte(in_list + 21), "a finite number", "-nan (y of sphere 1");
  }
  expect_ply_complaint("ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + xyz_floats +
                           "element face 4611686018427387904\nproperty int i\nend_header\n123456789012",
                       "byte 175", "4611686018427387904 items of 4 bytes", "the end of the file after 0 bytes");
}

}  // namespace
}  // namespace spherepair
