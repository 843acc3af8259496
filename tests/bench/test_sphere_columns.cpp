// SPDX-License-Identifier: MIT
// Spheres of every type of number, and by the names of columns and fields.
#include <cstdint>

#include "tests/bench/sphere_readings.h"

namespace spherepair {
namespace {

template <typename Number>
void expect_numbers(const char* dtype, const std::vector<Number>& numbers, const std::vector<vec4>& expected,
                    uint64_t changed = 0) {
  const std::string bytes = npy_file(npy_header(dtype, fmt::format("({}, 3)", expected.size())), npy_data(numbers, 3));
  const SphereFile input = read_from(bytes, {.radius = 1}, "npy");
  expect_spheres(input, expected);
  EXPECT_EQ(input.changed, changed) << dtype;
}

TEST(SphereFile, NpyOfEveryRealType) {
  expect_numbers<int8_t>("|i1", {-128, 127, 0}, {{-128, 127, 0, 1}});
  expect_numbers<uint8_t>("<u1", {255, 127, 0}, {{255, 127, 0, 1}});
  expect_numbers<int16_t>("<i2", {-32768, 32767, 1}, {{-32768, 32767, 1, 1}});
  expect_numbers<uint16_t>("<u2", {65535, 1, 2}, {{65535, 1, 2, 1}});
  expect_numbers<int32_t>("<i4", {-16777217, 16777216, 5}, {{-16777216, 16777216, 5, 1}}, 1);
  expect_numbers<uint32_t>("<u4", {4294967295, 1u << 31, 5}, {{4294967296, 2147483648, 5, 1}}, 1);
  expect_numbers<int64_t>("<i8", {INT64_MIN, INT64_MAX, 5}, {{-0x1p63f, 0x1p63f, 5, 1}}, 1);
  expect_numbers<uint64_t>("<u8", {UINT64_MAX, 7, 5}, {{0x1p64f, 7, 5, 1}}, 1);
  // 1, -2.5, the largest, the least and a denormal one.
  expect_numbers<uint16_t>("<f2", {0x3C00, 0xC100, 0x7BFF, 0x0001, 0x8400, 0x03FF},
                           {{1, -2.5f, 65504, 1}, {0x1p-24f, -0x1p-14f, 1023 * 0x1p-24f, 1}});
  EXPECT_NE(complaint_of([] {
              read_from(npy_file(npy_header("<f2", "(1, 3)"), npy_data<uint16_t>({0x7C00, 0, 0x7E00}, 3)),
                        {.radius = 1}, "npy");
            }).find("the first of 2 such numbers"),
            std::string::npos);
}

TEST(SphereFile, StructuredNpyFindsFieldsByName) {
  struct [[gnu::packed]] Row {
    int32_t id;
    double radius;
    float position[3];
    uint16_t velocity[3];
  };
  const Row rows[] = {{7, 0.5, {1, 2, 3}, {0x3C00, 0, 0}}, {8, 0.75, {4, 5, 6}, {0, 0xBC00, 0x4000}}};
  const std::string data(reinterpret_cast<const char*>(rows), sizeof rows);
  const SphereFile input =
      read_from(npy_file("{'descr': [('id', '<i4'), ('radius', '<f8'), ('pos', '<f4', (3,)), ('vel', '<f2', (3,))], "
                         "'fortran_order': False, 'shape': (2,)}",
                         data),
                {}, "npy");
  ASSERT_EQ(input.scene.size(), 2u);
  EXPECT_EQ(input.scene.positions[1].x, 4);
  EXPECT_EQ(input.scene.positions[1].w, 0.75f);
  EXPECT_EQ(input.scene.velocities[0].x, 1);
  EXPECT_EQ(input.scene.velocities[1].y, -1);
  EXPECT_EQ(input.scene.velocities[1].z, 2);
  EXPECT_NE(describe(input).find("not read: 'id'"), std::string::npos) << describe(input);
}

TEST(SphereFile, TextByColumns) {
  const std::vector<vec4> own = {{1, 2, 3, 0.5f}, {4, 5, 6, 0.75f}};
  for (const char* text :
       {"1 2 3 0.5\n4 5 6 0.75\n", "1,2,3,0.5\n4,5,6,.75", "# spheres\n1\t2 3 .5 # one\n\n4 5 6 .75\n",
        "\xef\xbb\xbf"
        "x, y, z, radius\r\n1, 2, 3, 0.5\r\n4, 5, 6, 0.75\r\n",
        "1;2;3;.5\n4 ; 5;6;.75\n"})
    expect_spheres(read_from(text, {}, "txt"), own);
  expect_spheres(read_from("\"X\",\"Y\",\"Z\",\"R\"\n1,2,3,.5\n4,5,6,.75\n", {}, "csv"), own);
  for (const char* quoted : {"\"1\",\"2\",\"3\",\".5\"\n4, \"5\" ,6,\".75\"\n", "\"1\" 2 \"3\" .5\n4 5 6 .75\n",
                             "x;y;z;r\n\"1\";\"2\";\"3\";\".5\"\n4;5;6;.75\n"})
    expect_spheres(read_from(quoted, {}, "csv"), own);
  expect_spheres(read_from("id,radius,z,y,x\n7,0.5,3,2,1\n8,.75,6,5,4\n", {}, "csv"), own);
  expect_spheres(read_from("7 0.5 3 2 1\n8 .75 6 5 4\n", {.columns = {"_", "radius", "z", "y", "x"}}, "log"), own);
  expect_spheres(read_from("1 2 3\n", {.radius = 0.25f}, "txt"), {{1, 2, 3, 0.25f}});
  const SphereFile moving = read_from("0 0 0 1 0 0 0\n1 1 1 2 3 4 5.\n", {}, "txt");
  ASSERT_EQ(moving.scene.size(), 2u);
  EXPECT_EQ(moving.scene.velocities[0].x, 0);
  EXPECT_EQ(moving.scene.velocities[1].z, 5);
}

}  // namespace
}  // namespace spherepair
