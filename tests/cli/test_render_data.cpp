// SPDX-License-Identifier: MIT
// spherepair render of spheres from files: films, colours, ground, and what it refuses.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include "bench/cli/commands.h"
#include "common/image/colouring.h"
#include "tests/support/images.h"
#include "tests/support/sphere_files.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

struct Pixels {
  uint width = 0, height = 0;
  std::vector<uint> rgba;
  size_t of(uint rgb) const {  // 0xRRGGBB
    const uint wanted = 0xFF000000u | (rgb & 255) << 16 | (rgb & 0xFF00) | rgb >> 16;
    return size_t(std::count(rgba.begin(), rgba.end(), wanted));
  }
};

class RenderData : public testing::Test {
 protected:
  RenderOptions options(const std::string& input, const std::string& output) {
    RenderOptions options;
    options.backend = "cpu";
    options.start.input_file = folder_.path("in.xyz");
    std::ofstream(options.start.input_file) << input;
    options.output_file = folder_.path(output);
    options.width = 320;
    options.height = 200;
    options.samples = 1;
    return options;
  }
  std::string run(const RenderOptions& options) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const std::string complaint = complaint_of([&] { EXPECT_EQ(render_command({{"test"}, {}}, options), kOk); });
    printed_ = testing::internal::GetCapturedStdout();
    testing::internal::GetCapturedStderr();
    return complaint;
  }
  json record(const std::string& file) const { return json::parse(std::ifstream(folder_.path(file))); }
  Pixels pixels(const std::string& file) const {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, folder_.path(file).c_str())) return {};
    image.format = PNG_FORMAT_RGBA;
    Pixels read{image.width, image.height, std::vector<uint>(size_t(image.width) * image.height)};
    png_image_finish_read(&image, nullptr, read.rgba.data(), 0, nullptr);
    return read;
  }

  const ScratchFolder folder_;
  std::string printed_;
};

constexpr const char* film =
    "2\nProperties=species:S:1:pos:R:3:radius:R:1\nO 0 0 0 1\nH 3 0 0 0.5\n"
    "3\nProperties=species:S:1:pos:R:3:radius:R:1\nO 0 -4 0 1\nH 3 0 0 0.5\nC 5 0 0 0.5\n";

TEST_F(RenderData, DrawsEveryFrameFromOneCamera) {
  RenderOptions all = options(film, "film.png");
  all.frames = true;
  EXPECT_EQ(run(all), "");
  const json first = record("film-0.json"), second = record("film-1.json");
  EXPECT_FALSE(fs::exists(folder_.path("film-2.json")));
  EXPECT_EQ(first.at("scene").at("n"), 2);
  EXPECT_EQ(second.at("scene").at("n"), 3);
  EXPECT_EQ(first.at("camera"), second.at("camera"));
  EXPECT_EQ(first.at("samples"), second.at("samples")) << "another ground or other colours";
  EXPECT_DOUBLE_EQ(first.at("samples")[0].at("ground")[3].get<double>(), -5) << "not below the lowest of all frames";
  EXPECT_DOUBLE_EQ(first.at("box").at("low")[1].get<double>(), -5);
}

TEST_F(RenderData, GivesEachSpeciesAColourOfItsOwnAndNamesIt) {
  RenderOptions all = options(film, "film.png");
  all.frames = true;
  all.colour = "species";
  EXPECT_EQ(run(all), "");
  std::map<std::string, std::string> colours;
  const json first = record("film-0.json");
  for (const json& key : first.at("colours").at("keys")) colours[key[1]] = key[0];
  EXPECT_EQ(colours.size(), 3u);
  EXPECT_NE(colours.at("C"), colours.at("O"));
  EXPECT_NE(colours.at("C"), colours.at("H"));
  EXPECT_NE(colours.at("H"), colours.at("O"));
  EXPECT_EQ(record("film-1.json").at("colours"), first.at("colours"));
}

TEST_F(RenderData, SaysWhichSpeciesShareAColour) {
  std::string many = "12\nx\n";
  for (int k = 0; k < 12; ++k) many += fmt::format("S{} {} 0 0\n", std::min(k, 9), k);
  RenderOptions species = options(many, "a.png");
  species.start.radius = 0.4f;
  species.colour = "species";
  EXPECT_EQ(run(species), "");
  EXPECT_NE(printed_.find("10 species, but 8 colours: the 3 rarest share one"), std::string::npos) << printed_;
  EXPECT_EQ(record("a.json").at("colours").at("keys")[0][1], "S9");
  EXPECT_EQ(record("a.json").at("colours").at("keys")[7][1], "3 others");
}

// Up is z: the ground lies below the lowest z, and the image is that of the same spheres turned so that y is up.
TEST_F(RenderData, TurnsGroundAndLightWithTheUpDirection) {
  RenderOptions y_up = options("3\nx\n0 0 0 1\n1 1.9 0.5 1\n-1 4 2 0.7\n", "y.png");
  EXPECT_EQ(run(y_up), "");
  RenderOptions z_up = options("3\nx\n0 0 0 1\n0.5 1 1.9 1\n2 -1 4 0.7\n", "z.png");
  z_up.camera.up = {0, 0, 1};
  EXPECT_EQ(run(z_up), "");
  EXPECT_EQ(record("z.json").at("samples")[0].at("ground"), json({0.0, 0.0, 1.0, -1.0}));
  const Pixels turned = pixels("z.png"), straight = pixels("y.png");
  ASSERT_EQ(turned.rgba.size(), straight.rgba.size());
  size_t different = 0;
  for (size_t k = 0; k < turned.rgba.size(); ++k) different += turned.rgba[k] != straight.rgba[k];
  EXPECT_LT(different, turned.rgba.size() / 200) << "more than rounding";
}

TEST_F(RenderData, PutsTheGroundWhereItIsAskedFor) {
  const std::string two = "2\nx\n0 0 0 1\n3 5 0 0.5\n";
  const auto ground = [&](const std::string& wanted) {
    RenderOptions one = options(two, "a.png");
    one.ground = wanted;
    EXPECT_EQ(run(one), "") << wanted;
    const json sample = record("a.json").at("samples")[0];
    return sample.at("lighting").get<uint>() & LIGHT_GROUND ? sample.at("ground")[3].get<double>() : NAN;
  };
  EXPECT_DOUBLE_EQ(ground(""), -1);
  EXPECT_DOUBLE_EQ(ground("lowest"), -1);
  EXPECT_DOUBLE_EQ(ground("-2.5"), -2.5);
  EXPECT_TRUE(std::isnan(ground("none")));
  for (const char* wanted : {"plane", "floor", "1e99", "3m"}) {
    RenderOptions wrong = options(two, "b.png");
    wrong.ground = wanted;
    EXPECT_NE(run(wrong).find("--ground"), std::string::npos) << wanted;
  }
  EXPECT_FALSE(fs::exists(folder_.path("b.png")));
}

TEST_F(RenderData, RefusesABlankImageAndSaysWhatToDo) {
  EXPECT_NE(run(options("0\nx\n", "a.png")).find("no spheres"), std::string::npos);
  RenderOptions away = options("1\nx\n0 0 0 1\n", "a.png");
  away.camera.eye = {0, 0, 10};
  away.camera.target = {0, 0, 20};
  EXPECT_NE(run(away).find("--eye"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_.path("a.png")));
  EXPECT_FALSE(fs::exists(folder_.path("a.json")));
}

TEST_F(RenderData, RefusesColoursThatTheDataLack) {
  RenderOptions plain = options("1\nx\n0 0 0 1\n", "a.png");
  for (const char* colour : {"species", "speed", "mass"}) {
    plain.colour = colour;
    EXPECT_NE(run(plain), "") << colour;
  }
  EXPECT_FALSE(fs::exists(folder_.path("a.png")));
}

// The strip of the legend is white but for its line, letters and colours, and the image above is as without it, but
// lower.
TEST_F(RenderData, KeepsTheLegendBelowTheSpheres) {
  const std::string one = "1\nx\n0 0 0 1\n";
  RenderOptions with = options(one, "with.png");
  EXPECT_EQ(run(with), "");
  const uint above = record("with.json").at("height_above_legend");
  EXPECT_LT(above, 200u);
  RenderOptions without = options(one, "without.png");
  without.legend = false;
  without.height = above;
  EXPECT_EQ(run(without), "");
  const Pixels tall = pixels("with.png"), low = pixels("without.png");
  EXPECT_EQ(tall.height, 200u);
  EXPECT_EQ(low.height, above);
  EXPECT_TRUE(std::equal(low.rgba.begin(), low.rgba.end(), tall.rgba.begin()));
  for (const uint colour : contact_look().palette) EXPECT_GT(tall.of(colour), 30u);
  RenderOptions small = options(one, "small.png");
  small.width = 60;
  EXPECT_EQ(run(small), "");
  EXPECT_NE(printed_.find("no room for the legend"), std::string::npos) << printed_;
}

// Every way through OpenGL has the ground with its shadow, and the edges of the box.
TEST_F(RenderData, DrawsBoxAndGroundThroughOpenGLToo) {
  if (const std::string why = why_no_pipeline(*open_backend("cpu")); !why.empty()) GTEST_SKIP() << why;
  for (const char* draw : {"compute", "mesh", "mesh_each", "quadric", "points", "impostor"}) {
    const auto colours = [&](bool box, const char* ground) {
      RenderOptions one = options("2\nx\n0 1 0 1\n3 5 0 0.5\n", "a.png");
      one.draw = draw;
      one.box = box;
      one.ground = ground;
      EXPECT_EQ(run(one), "") << draw;
      return pixels("a.png");
    };
    const Pixels all = colours(true, "lowest"), no_box = colours(false, "lowest"), no_ground = colours(false, "none");
    EXPECT_GT(no_box.of(0xFFFFFF), all.of(0xFFFFFF) + 300) << draw << ": no edges";
    EXPECT_GT(no_ground.of(0xFFFFFF), no_box.of(0xFFFFFF) + 500) << draw << ": no shadow";
    EXPECT_EQ(printed_.find("without ambient occlusion") != std::string::npos, std::string(draw) != "compute");
  }
}

TEST(Colouring, FitsTheRangeOfManyContacts) {
  std::vector<double> dense;
  for (int k = 0; k < 1000; ++k) dense.push_back(8 + k % 14);
  const Colouring colouring(ColourBy::contacts, dense, "");
  const std::vector<uint> classes = colouring.classes(dense);
  std::map<uint, size_t> spheres;
  for (const uint each : classes) ++spheres[each];
  EXPECT_EQ(spheres.size(), 7u) << "all but no contacts";
  for (const auto& [each, count] : spheres) EXPECT_GT(count, 70u) << each;
  EXPECT_EQ(colouring.classes({0})[0], 0u);
  std::set<std::string> labels;
  for (const LegendKey& key : colouring.legend().keys) labels.insert(key.label);
  EXPECT_EQ(labels.size(), 8u);
}

TEST(Colouring, KeepsTheClassesOfFewContacts) {
  const std::vector<double> few = {0, 1, 2, 3, 4, 5, 6, 7};
  const Colouring colouring(ColourBy::contacts, few, "");
  EXPECT_EQ(colouring.classes(few), (std::vector<uint>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(colouring.legend().keys.back().label, "7+");
  EXPECT_EQ(colouring.look().palette, contact_look().palette);
}

TEST(Colouring, SpreadsRadiiOverThePalette) {
  const std::vector<double> even = {1, 1.5, 2, 3, 5}, wide = {0.001, 0.011, 0.11, 1.1, 10}, equal = {2, 2};
  EXPECT_EQ(Colouring(ColourBy::radius, even, "").classes(even), (std::vector<uint>{0, 1, 2, 4, 7}));
  EXPECT_EQ(Colouring(ColourBy::radius, wide, "").classes(wide), (std::vector<uint>{0, 2, 4, 6, 7}));
  EXPECT_EQ(Colouring(ColourBy::radius, equal, "").classes(equal), (std::vector<uint>{0, 0}));
  EXPECT_EQ(Colouring(ColourBy::radius, equal, "").legend().keys.size(), 1u);
}

}  // namespace
}  // namespace spherepair
