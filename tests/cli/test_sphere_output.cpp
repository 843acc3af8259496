// SPDX-License-Identifier: MIT
// run --spheres: what one run writes, the next reads, to the same bits in every format.
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/output/sphere_output.h"
#include "common/scene/scene.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

class SphereOutput : public ProgramTest {
 protected:
  const std::vector<std::string> extensions_ = {".npy", ".xyz", ".extxyz", ".csv", ".tsv", ".txt", ".dat"};
};

// Numbers whose shortest text is long, of all sizes, and both zeros.
Scene awkward_spheres() {
  Scene scene = make_scene({.name = "clustered", .n = 3000, .radius_ratio = 8});
  scene.positions[0] = {0.1f, -0.0f, 1e-45f, 0};
  scene.positions[1] = {16777217.0f, 3.4028235e38f, -1.17549435e-38f, 0x1.fffffep-100f};
  scene.velocities[1] = {1.0f / 3, -2e-7f, 123456.79f, 0};
  return scene;
}

TEST_F(SphereOutput, EveryFormatGivesTheSameBitsBack) {
  const Scene scene = awkward_spheres();
  for (const std::string& extension : extensions_) {
    const std::string file = path("spheres" + extension);
    write_spheres(file, scene.positions, scene.velocities);
    const SphereFile read = read_sphere_file(file, {});
    ASSERT_EQ(read.scene.size(), scene.size()) << extension;
    EXPECT_FALSE(read.at_rest) << extension;
    for (size_t i = 0; i < scene.size(); ++i) {
      const vec4 &p = scene.positions[i], &q = read.scene.positions[i];
      const vec4 &v = scene.velocities[i], &w = read.scene.velocities[i];
      for (const auto& [wanted, found] :
           {std::pair{p.x, q.x}, {p.y, q.y}, {p.z, q.z}, {p.w, q.w}, {v.x, w.x}, {v.y, w.y}, {v.z, w.z}})
        ASSERT_EQ(std::bit_cast<uint32_t>(wanted), std::bit_cast<uint32_t>(found)) << extension << ", sphere " << i;
    }
  }
}

// The arrays behind the mark _, each with its size before it, where the description says.
TEST_F(SphereOutput, VtpHoldsTheSameBits) {
  const Scene scene = awkward_spheres();
  const std::string file = path("spheres.vtp");
  write_spheres(file, scene.positions, scene.velocities);
  const std::string bytes = read_bytes(file);
  EXPECT_NE(bytes.find("NumberOfPoints=\"3000\" NumberOfVerts=\"3000\""), bytes.npos);
  EXPECT_TRUE(bytes.ends_with("\n</AppendedData>\n</VTKFile>\n"));
  const size_t data = bytes.find("_", bytes.find("<AppendedData encoding=\"raw\">")) + 1;
  const auto array_of = [&]<typename Number>(const std::string& name, const std::string& type, Number) {
    const size_t tag = bytes.find(fmt::format("<DataArray type=\"{}\" Name=\"{}\"", type, name));
    const size_t at = data + std::stoull(bytes.substr(bytes.find("offset=\"", tag) + 8));
    uint64_t size = 0;
    std::memcpy(&size, bytes.data() + std::min(at, bytes.size() - sizeof size), sizeof size);
    if (size > bytes.size() - at) return std::vector<Number>();  // not an array's size
    std::vector<Number> numbers(size / sizeof(Number));
    std::memcpy(numbers.data(), bytes.data() + at + sizeof size, size);
    return numbers;
  };
  const auto points = array_of("Points", "Float32", uint32_t()), radii = array_of("radius", "Float32", uint32_t()),
             velocities = array_of("velocity", "Float32", uint32_t());
  const auto vertices = array_of("connectivity", "Int64", int64_t()), ends = array_of("offsets", "Int64", int64_t());
  ASSERT_EQ(points.size(), 3 * scene.size());
  ASSERT_EQ(velocities.size(), points.size());
  for (const size_t size : {radii.size(), vertices.size(), ends.size()}) ASSERT_EQ(size, scene.size());
  for (size_t i = 0; i < scene.size(); ++i) {
    const vec4 &p = scene.positions[i], &v = scene.velocities[i];
    const auto same = [&](float wanted, uint32_t found) { return float_bits(wanted) == found; };
    ASSERT_TRUE(same(p.x, points[3 * i]) && same(p.y, points[3 * i + 1]) && same(p.z, points[3 * i + 2])) << i;
    ASSERT_TRUE(same(v.x, velocities[3 * i]) && same(v.y, velocities[3 * i + 1]) && same(v.z, velocities[3 * i + 2]))
        << i;
    ASSERT_TRUE(same(p.w, radii[i]) && vertices[i] == int64_t(i) && ends[i] == int64_t(i) + 1) << i;
  }
}

TEST_F(SphereOutput, OneRunGoesOnWhereTheOtherEnded) {
  const std::string first = "run --backend cpu --scene random --n 700 --steps 50 --pairs " + path("pairs.txt");
  for (const std::string& extension : extensions_) {
    const std::string end = path("end" + extension), again = path("again" + extension);
    ASSERT_EQ(run(fmt::format("{} --spheres {}", first, end)).code, kOk) << extension;
    const Outcome second =
        run(fmt::format("run --backend cpu --input {} --spheres {} --pairs {}", end, again, path("same.txt")));
    ASSERT_EQ(second.code, kOk) << extension << second.errors;
    EXPECT_EQ(read_bytes(again), read_bytes(end)) << extension;
    EXPECT_EQ(read_bytes(path("same.txt")), read_bytes(path("pairs.txt"))) << extension;
  }
  const std::string lines = read_bytes(path("end.csv"));
  EXPECT_TRUE(lines.starts_with("x,y,z,radius,vx,vy,vz\n")) << lines.substr(0, 60);
  EXPECT_EQ(std::ranges::count(lines, '\n'), 701);
}

TEST_F(SphereOutput, TheSpheresHaveMoved) {
  for (const int steps : {0, 1}) {
    const std::string file = path(fmt::format("{}.csv", steps));
    ASSERT_EQ(run(fmt::format("run --backend cpu --n 9 --steps {} --spheres {}", steps, file)).code, kOk);
  }
  EXPECT_NE(read_bytes(path("0.csv")), read_bytes(path("1.csv")));
}

TEST_F(SphereOutput, SaysThatItLosesTheSpeciesOfAFile) {
  const std::string named = folder_.write("a.extxyz", "1\nProperties=species:S:1:pos:R:3:radius:R:1\nHe 1 2 3 1\n"),
                    classic = folder_.write("b.xyz", "1\n\nHe 1 2 3 1\n"),
                    bare = folder_.write("c.xyz", "1\n\n1. 2 3 1\n");
  const auto errors = [&](const std::string& in, const std::string& out) {
    return run(fmt::format("run --backend cpu --input {} {}", in, out.empty() ? "" : "--spheres " + path(out))).errors;
  };
  const std::string warning = "* --spheres writes no species: those of ";
  for (const std::string& in : {named, classic})
    for (const char* out : {"out.extxyz", "out.csv"})
      EXPECT_TRUE(errors(in, out).starts_with(warning + in)) << errors(in, out);
  EXPECT_EQ(errors(bare, "out.xyz"), "");
  EXPECT_EQ(errors(named, ""), "");
}

TEST_F(SphereOutput, GoesToStandardOutputAsText) {
  const Outcome outcome = run("run --backend cpu --n 3 --spheres -");
  EXPECT_EQ(outcome.code, kOk);
  EXPECT_TRUE(outcome.output.starts_with("# x y z radius vx vy vz\n")) << outcome.output;
  EXPECT_EQ(std::ranges::count(outcome.output, '\n'), 4);
  EXPECT_NE(outcome.errors.find("3 spheres"), std::string::npos) << "the report";
}

TEST_F(SphereOutput, RefusesWhatItCannotWrite) {
  const std::string in = folder_.write("in.txt", "0 1 0 0.5\n");
  for (const std::string& arguments : {"--n 5 --spheres " + path("a.vtk"), "--input " + in + " --spheres " + in,
                                       fmt::format("--n 5 --spheres {0} --pairs {0}", path("a.txt"))}) {
    const Outcome outcome = run("run --backend cpu " + arguments);
    EXPECT_EQ(outcome.code, kUsage) << arguments;
    EXPECT_NE(outcome.errors.find("--spheres"), std::string::npos) << outcome.errors;
  }
  EXPECT_EQ(read_bytes(in), "0 1 0 0.5\n");
}

}  // namespace
}  // namespace spherepair
