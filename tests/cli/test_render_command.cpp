// SPDX-License-Identifier: MIT
// spherepair render as a whole: images and their records, the same on every backend, and nothing lost when it fails.
#include <gtest/gtest.h>
#include <png.h>

#include <fstream>

#include "bench/cli/commands.h"
#include "common/files/file_bytes.h"
#include "common/image/box_edges.h"
#include "tests/support/images.h"
#include "tests/support/sphere_files.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

class RenderCommand : public testing::Test {
 protected:
  RenderOptions options(const std::string& output) const {
    RenderOptions options;
    options.backend = "cpu";
    options.start.scene.n = 300;
    options.output_file = folder_.path(output);
    options.width = 200;
    options.height = 120;
    options.samples = 2;
    return options;
  }
  std::string run(const RenderOptions& options) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const std::string complaint = complaint_of([&] { EXPECT_EQ(render_command({{"test"}, {}}, options), kOk); });
    testing::internal::GetCapturedStdout();
    testing::internal::GetCapturedStderr();
    return complaint;
  }
  // Width, height and the number of pixels that are not white.
  std::array<size_t, 3> looked_at(const std::string& file) const {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, folder_.path(file).c_str())) return {};
    image.format = PNG_FORMAT_RGBA;
    std::vector<uint> pixels(size_t(image.width) * image.height);
    if (!png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr)) return {};
    return {image.width, image.height, pixels.size() - size_t(std::count(pixels.begin(), pixels.end(), ~0u))};
  }

  const ScratchFolder folder_;
};

TEST_F(RenderCommand, WritesASeriesAndItsRecords) {
  RenderOptions series = options("fall.png");
  series.images = 11;
  series.every = 3;
  EXPECT_EQ(run(series), "");
  for (const char* name : {"fall-00", "fall-05", "fall-10"}) {
    const auto [width, height, marked] = looked_at(std::string(name) + ".png");
    EXPECT_EQ(width, 200u);
    EXPECT_EQ(height, 120u);
    EXPECT_GT(marked, 1000u);
  }
  const json record = json::parse(std::ifstream(folder_.path("fall-10.json")));
  EXPECT_EQ(record.at("step"), 30);
  EXPECT_EQ(record.at("samples").size(), 2u);
  EXPECT_EQ(record.at("scene").at("n"), 300);
  EXPECT_FALSE(fs::exists(folder_.path("fall-11.png")));
}

TEST_F(RenderCommand, IsTheSameOnEveryBackend) {
  std::string first;
  for (const Backend* backend : open_backends()) {
    RenderOptions one = options("image.png");
    one.backend = backend->info().name;
    one.steps = 20;
    EXPECT_EQ(run(one), "") << one.backend;
    const std::string bytes = read_bytes(folder_.path("image.png"));
    if (first.empty()) first = bytes;
    EXPECT_EQ(bytes, first) << one.backend;
  }
}

TEST_F(RenderCommand, LeavesTheBoxOutWhenAsked) {
  RenderOptions with = options("with.png"), without = options("without.png");
  without.box = false;
  EXPECT_EQ(run(with), "");
  EXPECT_EQ(run(without), "");
  EXPECT_GT(looked_at("with.png")[2], looked_at("without.png")[2]);
}

// A box ahead of the camera; everywhere a surface so far forward: before, between and behind its near and far faces.
TEST(BoxEdges, StandBehindWhatIsNearer) {
  const View view = make_view({{0, 0, 10}, {0, 0, 0}}, contact_look(), 120, 90);
  const Bounds box = {{-1, -1, -1}, {1, 1, 1}};
  const auto marked = [&](double ahead) {
    std::vector<uint> image(size_t(view.width) * view.height, ~0u);
    draw_edges(image, std::vector<double>(image.size(), ahead), view, box);
    return image.size() - size_t(std::count(image.begin(), image.end(), ~0u));
  };
  EXPECT_EQ(marked(8), 0u);
  EXPECT_GT(marked(9.5f), 50u);
  EXPECT_GT(marked(20), marked(9.5f) + 50);
}

// Every backend's spheres through OpenGL: the record says how they came there.
TEST_F(RenderCommand, DrawsTheCpusSpheresThroughOpenGL) {
  if (const std::string why = why_no_pipeline(*open_backend("cpu")); !why.empty()) GTEST_SKIP() << why;
  RenderOptions mesh = options("a.png");
  mesh.draw = "mesh";
  mesh.plain = true;
  EXPECT_EQ(run(mesh), "");
  const json record = json::parse(FileBytes(folder_.path("a.json")).bytes());
  EXPECT_EQ(record.at("drawn_by"), "mesh");
  EXPECT_EQ(record.at("transfer"), "host");
}

TEST_F(RenderCommand, RefusesAndLeavesNothing) {
  RenderOptions none = options("a.png");
  none.output_file.clear();
  EXPECT_NE(run(none).find("--output"), std::string::npos);
  EXPECT_NE(run(options("a.jpg")).find(".png"), std::string::npos);
  EXPECT_NE(run(options("no/such/folder/a.png")).find("a.png"), std::string::npos);
  RenderOptions tilted = options("a.png");
  tilted.camera.eye = {1, 2, 3};
  tilted.camera.target = {1, 2, 3};
  EXPECT_NE(run(tilted).find("direction"), std::string::npos);
  RenderOptions unknown = options("a.png");
  unknown.draw = "cubes";
  EXPECT_NE(run(unknown).find("quadric"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_.path("a.png")));
}

}  // namespace
}  // namespace spherepair
