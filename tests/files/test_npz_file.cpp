// SPDX-License-Identifier: MIT
// Spheres of NPZ files: arrays by their names, stored or deflated, and a periodic box.
#include <zlib.h>

#include "tests/bench/sphere_complaints.h"
#include "tests/support/pairs_command.h"

namespace spherepair {
namespace {

struct ZipOptions {
  bool deflate = false;
  bool zip64 = false;  // sizes and offsets of 64 bits
  int method = -1;     // another than that of the data
  uint32_t flags = 0;
  std::string comment = "";
};

std::string little_bytes(uint64_t number, size_t bytes) {
  std::string text;
  for (size_t k = 0; k < bytes; ++k) text += k < 8 ? char(number >> 8 * k & 255) : char(0);
  return text;
}

std::string deflated(const std::string& bytes) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string packed(bytes.size() + 1000, 0);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_in = uInt(bytes.size()), stream.avail_out = uInt(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

using Members = std::vector<std::pair<std::string, std::string>>;

std::string zip_of(const Members& members, const ZipOptions& options = {}) {
  std::string file, directory;
  for (const auto& [name, bytes] : members) {
    const std::string packed = options.deflate ? deflated(bytes) : bytes;
    const uint64_t crc = crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), uInt(bytes.size()));
    const int method = options.method >= 0 ? options.method : options.deflate ? 8 : 0;
    const uint64_t at = file.size();
    const std::string sizes =
        options.zip64 ? std::string(8, '\xff') : little_bytes(packed.size(), 4) + little_bytes(bytes.size(), 4);
    const std::string both = little_bytes(bytes.size(), 8) + little_bytes(packed.size(), 8);
    const std::string extra = options.zip64 ? "xy" + little_bytes(3, 2) + "abc" + little_bytes(1, 2) +
                                                  little_bytes(24, 2) + both + little_bytes(at, 8)
                                            : "";
    const std::string common = little_bytes(options.flags, 2) + little_bytes(uint64_t(method), 2) + little_bytes(0, 4) +
                               little_bytes(crc, 4) + sizes + little_bytes(name.size(), 2);
    directory += "PK\1\2" + little_bytes(0x2d002d, 4) + common + little_bytes(extra.size(), 2) + little_bytes(0, 10) +
                 (options.zip64 ? std::string(4, '\xff') : little_bytes(at, 4)) + name + extra;
    file += "PK\3\4" + little_bytes(0x2d, 2) + common + little_bytes(4, 2) + name + "more" + packed;
  }
  const uint64_t at = file.size(), count = members.size();
  file += directory;
  const uint64_t end = file.size();
  if (options.zip64)
    file += "PK\6\6" + little_bytes(44, 8) + little_bytes(0x2d002d, 4) + little_bytes(0, 8) + little_bytes(count, 8) +
            little_bytes(count, 8) + little_bytes(directory.size(), 8) + little_bytes(at, 8) + "PK\6\7" +
            little_bytes(0, 4) + little_bytes(end, 8) + little_bytes(1, 4);
  const std::string counts = options.zip64 ? std::string(4, '\xff') : little_bytes(count, 2) + little_bytes(count, 2);
  return file + "PK\5\6" + little_bytes(0, 4) + counts + little_bytes(directory.size(), 4) +
         (options.zip64 ? std::string(4, '\xff') : little_bytes(at, 4)) + little_bytes(options.comment.size(), 2) +
         options.comment;
}

template <typename Real>
std::string npy_array(const std::string& shape, const std::vector<Real>& numbers, const std::string& kind = "f") {
  return npy_file(npy_header(fmt::format("<{}{}", kind, sizeof(Real)), shape), npy_data(numbers, 1));
}

const std::string two_centres = npy_array<float>("(2, 3)", {0.5, 1, 2, 3.5, 4, 5}),
                  two_radii = npy_array<double>("(2,)", {0.75, 1});
const std::string box_array = npy_array<double>("(3, 3)", {4, 0, 0, 0, 5, 0, 0, 0, 6});

class NpzFile : public PairsCommand {
 protected:
  SphereFile read(const Members& members, const SphereFileOptions& asked = {}, const ZipOptions& zip = {}) {
    return read_sphere_file(folder_.write("a.npz", zip_of(members, zip)), asked);
  }
  std::string listed(const std::string& name, const std::string& bytes) {
    PairsOptions asked = options("pairs.txt");
    asked.input_file = folder_.write(name, bytes);
    EXPECT_EQ(run(asked), "") << name;
    return read_bytes(asked.output_file);
  }
};

void expect_two(const SphereFile& file) {
  ASSERT_EQ(file.scene.size(), 2u);
  const vec4 &p = file.scene.positions[0], &q = file.scene.positions[1];
  EXPECT_EQ((std::array{p.x, p.y, p.z, p.w}), (std::array{0.5f, 1.0f, 2.0f, 0.75f}));
  EXPECT_EQ((std::array{q.x, q.y, q.z, q.w}), (std::array{3.5f, 4.0f, 5.0f, 1.0f}));
}

TEST_F(NpzFile, ArraysAreReadByTheirNamesHoweverTheyArePacked) {
  for (const char* name : {"positions.npy", "centers.npy", "centres.npy"})
    for (const ZipOptions& zip : {ZipOptions{}, {.deflate = true}, {.zip64 = true}, {.comment = "PK or so"}}) {
      const SphereFile file = read({{"notes.txt", "PK\1\2"}, {"radii.npy", two_radii}, {name, two_centres}}, {}, zip);
      expect_two(file);
      EXPECT_TRUE(file.own_radii);
      EXPECT_TRUE(file.at_rest);
    }
}

TEST_F(NpzFile, OneArrayMayHaveAllNumbers) {
  const std::string rows = npy_array<float>("(2, 4)", {0.5, 1, 2, 0.75, 3.5, 4, 5, 1});
  expect_two(read({{"spheres.npy", rows}, {"positions.npy", "not read"}}));
  expect_two(read({{"arr_0.npy", rows}}));
  EXPECT_TRUE(read({{"a\x98.npy", rows}}).format.starts_with("NPZ 'a\\x98': NPY (x y z radius)"));  // JSON is UTF-8
  expect_two(read({{"arr_0.npy", rows}}, {.columns = {"x", "y", "z", "radius"}}));
}

TEST_F(NpzFile, VelocitiesRadiusAndNamesAreTaken) {
  const std::string v = npy_array<int32_t>("(2, 3)", {1, 2, 3, 4, 5, 6}, "i");
  const SphereFile moving = read({{"positions.npy", two_centres}, {"velocities.npy", v}}, {.radius = 2});
  EXPECT_EQ(moving.scene.velocities.at(1).y, 5);
  EXPECT_EQ(moving.scene.positions.at(1).w, 2);
  const Members other = {{"a.npy", two_centres}, {"b.npy", npy_array<double>("(2,)", {1.5, 2})}, {"positions.npy", v}};
  expect_two(read(other, {.columns = {"pos=a", "diameter=b"}}));
  EXPECT_NE(complaint_of([&] {
              read(other, {.columns = {"x", "y", "z"}});
            }).find("such as --columns pos=NAME"),
            std::string::npos);
}

// The same spheres and box as extended XYZ, in float32 and float64.
TEST_F(NpzFile, PairsInItsBoxAreThoseOfTheSameLattice) {
  const std::string flags = npy_array<uint8_t>("(3,)", {1, 0, 1}, "u");
  std::string bools = flags;
  bools.replace(bools.find("<u1"), 3, "|b1");
  const std::string wide = npy_array<double>("(2, 3)", {0.5, 1, 2, 3.5, 4, 5});
  const auto of_xyz = [&](const std::string& lattice) {
    return listed("a.xyz", "2\n" + lattice + " Properties=pos:R:3:radius:R:1\n0.5 1 2 0.75\n3.5 4 5 1\n");
  };
  const auto of_npz = [&](const std::string& centres, const Members& box) {
    Members members = {{"positions.npy", centres}, {"radii.npy", npy_array<float>("(2,)", {0.75, 1})}};
    members.insert(members.end(), box.begin(), box.end());
    return listed("a.npz", zip_of(members));
  };
  const std::string all = of_xyz("Lattice=\"3 0 0 0 3 0 0 0 3\""),
                    some = of_xyz("Lattice=\"3 0 0 0 3 0 0 0 3\" pbc=\"T F T\"");
  const std::string box = npy_array<double>("(3, 3)", {3, 0, 0, 0, 3, 0, 0, 0, 3}),
                    lengths = npy_array<float>("(3,)", {3, 3, 3});
  EXPECT_NE(all, some);
  for (const std::string& centres : {two_centres, wide}) {
    EXPECT_EQ(of_npz(centres, {{"box.npy", box}}), all);
    EXPECT_EQ(of_npz(centres, {{"box.npy", lengths}}), all);
    EXPECT_EQ(of_npz(centres, {{"pbc.npy", bools}, {"box.npy", box}}), some);
    EXPECT_EQ(of_npz(centres, {{"pbc.npy", npy_array<uint8_t>("()", {1}, "u")}, {"box.npy", box}}), all);
  }
  EXPECT_EQ(of_xyz("Lattice=\"4 0 0 1 5 0 2 -1 4.5\""),
            of_npz(two_centres, {{"box.npy", npy_array<double>("(3, 3)", {4, 0, 0, 1, 5, 0, 2, -1, 4.5})}}));
  const Members open = {{"spheres.npy", npy_array<float>("(1, 4)", {0, 0, 0, 1})},
                        {"box.npy", box_array},
                        {"pbc.npy", npy_array<uint8_t>("(1,)", {0}, "u")}};
  EXPECT_EQ(read(open, {.exact = true}).periodic, "");
}

TEST_F(NpzFile, BadArchivesAreRefusedWhereTheyAre) {
  const Members one = {{"spheres.npy", npy_array<float>("(1, 4)", {0, 0, 0, 1})}};
  const std::string good = zip_of(one), packed = zip_of(one, {.deflate = true});
  const auto expect = [](const std::string& bytes, size_t byte, const std::string& expected, const std::string& found) {
    expect_complaint("bad.npz", bytes, fmt::format("byte {}", byte), expected, found, {});
  };
  const size_t directory = good.find("PK\1\2"), end = good.find("PK\5\6");
  expect("", 0, "the directory at the end of a zip archive", "the end of the file");
  expect(good.substr(0, end), end, "the directory at the end of a zip archive", "the end of the file: it is truncated");
  expect(good.substr(0, good.size() - 1), end, "the 22 bytes that end a zip archive", "'PK\\x05\\x06'");
  std::string damaged = good;
  damaged[directory] = 'Q';
  expect(damaged, directory, "entry 1 of 1 in the zip directory", "'QK\\x01\\x02'");
  damaged = good;
  damaged[directory + 28] = '\xff';
  expect(damaged, directory + 46, "255 bytes of a member's name", "the end of the file after");
  damaged = good;
  damaged[directory - 1] ^= 1;
  expect(damaged, 0, "the checksum", "");
  damaged = packed;
  damaged[packed.find("more") + 8] ^= 255;
  expect(damaged, 0, "", "");
  damaged = packed;
  damaged[packed.find("PK\1\2") + 24] ^= 1;  // the size
  expect(damaged, 0, "deflated data of", "damaged data");
  damaged = packed;
  damaged.replace(packed.find("PK\1\2") + 24, 4, "\xff\xff\xff\x7f");
  expect(damaged, 0, "a size that its data may have for 'spheres.npy'", "2147483647 bytes in");
  expect(zip_of(one, {.method = 12}), 0, "method 0 (stored) or 8 (deflated)", "method 12");
  expect(zip_of(one, {.flags = 1}), 0, "no encryption", "an encrypted member");
  damaged = good;
  damaged[directory + 42] = 1;
  expect(damaged, 1, "the header of a zip member", "'K\\x03\\x04-'");
}

TEST_F(NpzFile, BadArraysAreRefusedWhereTheyAre) {
  const auto expect = [&](const Members& members, const std::string& place, const std::string& expected,
                          const std::string& found, const SphereFileOptions& asked = {.radius = 1, .exact = true}) {
    expect_complaint("bad.npz", zip_of(members), place, expected, found, asked);
  };
  const std::pair<std::string, std::string> centres = {"positions.npy", two_centres};
  expect({{"positions.npy", npy_array<float>("(3, 2)", {1, 2, 3, 4, 5, 6})}}, "'positions.npy', byte 60",
         "shape (n, 3)", "(3, 2)");
  expect({centres, {"radii.npy", npy_array<float>("(1, 2)", {1, 2})}}, "'radii.npy', byte 60", "shape (n,)", "(1, 2)",
         {});
  expect({centres, {"radii.npy", npy_array<float>("(3,)", {1, 2, 3})}}, "'radii.npy', byte 60",
         "2 rows, as in 'positions'", "3", {});
  expect({centres, {"radii.npy", npy_array<float>("(2,)", {1, -2})}}, "'radii.npy', byte 132",
         "a radius that is not negative", "-2 (radius of sphere 1", {});
  expect({{"positions.npy", npy_array<float>("(1, 3)", {1, 2, std::nanf("")})}}, "'positions.npy', byte 136",
         "a finite number", "nan (z of sphere 0");
  expect({{"positions.npy", two_centres.substr(0, 140)}}, "'positions.npy', byte 140", "24 bytes of data",
         "the end of the file after 12");
  expect({{"positions.npy", "no array"}}, "'positions.npy', byte 0", "the magic string", "'no arr'");
  expect({centres, {"box.npy", npy_array<double>("(2, 3)", {4, 0, 0, 0, 5, 0})}}, "'box.npy', byte 60",
         "a box of shape (3, 3)", "(2, 3)");
  expect({centres, {"box.npy", npy_array<double>("(3,)", {4, std::nan(""), 5})}}, "'box.npy', byte 136",
         "a finite number", "nan");
  expect({centres, {"box.npy", box_array}, {"pbc.npy", npy_array<uint8_t>("(2,)", {1, 1}, "u")}}, "'pbc.npy', byte 60",
         "pbc of shape (3,)", "(2, 1)");
  const auto refusal = [&](const Members& members, const SphereFileOptions& asked) {
    return complaint_of([&] { read(members, asked); });
  };
  const auto has = [](const std::string& text, const char* words) { EXPECT_NE(text.find(words), text.npos) << text; };
  has(refusal({centres}, {}), "has no radii");
  has(refusal({{"mass.npy", two_radii}, {"radii.npy", two_radii}}, {}),
      "columns x, y and z must be among 'mass radii'");
  has(refusal({centres, {"centers.npy", two_centres}, {"positions.npy", two_centres}}, {.radius = 1}), "stands twice");
  has(refusal({centres, {"box.npy", box_array}}, {.radius = 1}),
      "expected spheres without a periodic box, since only `pairs`");
  has(refusal({centres}, {.radius = 1, .ignore_periodic = true}), "has no periodic box: omit --ignore-periodic");
  has(refusal({centres, {"pbc.npy", npy_array<uint8_t>("(1,)", {1}, "u")}}, {.radius = 1, .exact = true}),
      "an array box beside pbc");
  EXPECT_EQ(read({centres, {"box.npy", box_array}}, {.radius = 1, .ignore_periodic = true}).ignored,
            "box (4 0 0), (0 5 0), (0 0 6)");
}

}  // namespace
}  // namespace spherepair
