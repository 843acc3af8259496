// SPDX-License-Identifier: MIT
// Drawing through the C calls: the pixels of `spherepair render`, only where the caller's array is, or a message.
#include <fmt/format.h>
#include <png.h>

#include <cmath>
#include <functional>

#include "bench/cli/commands.h"
#include "tests/lists/simulation_calls.h"
#include "tests/support/sphere_files.h"

namespace spherepair {
namespace {

constexpr int64_t width = 96, height = 72;

// A box of spheres, some of which overlap.
GivenSpheres many_spheres() {
  GivenSpheres spheres{.positions = {}, .velocities = {}, .radii = {}};
  for (int k = 0; k < 80; ++k) {
    for (const double x : {k % 4 * 0.37, 0.4 + k / 16 * 0.36, k / 4 % 4 * 0.41 + k % 7 * 0.01})
      spheres.positions.push_back(x);
    for (const double v : {0.01 * k, 0.3, -0.02 * k}) spheres.velocities.push_back(v);
    spheres.radii.push_back(0.1 + k % 5 * 0.03);
  }
  return spheres;
}

sp_drawing drawing(const std::function<void(sp_drawing&)>& change = [](sp_drawing&) {}) {
  sp_drawing made = {};
  made.size = sizeof made;
  made.samples = 2, made.azimuth = 30, made.elevation = 15;
  change(made);
  return made;
}

sp_array array_of(std::vector<uint8_t>& bytes, int64_t row_stride = 4 * width) {
  return {bytes.data(), height, 4 * width, row_stride, 1, SP_U8, 1, 0};
}

std::vector<uint8_t> drawn(OpenSimulation& opened, const sp_drawing& wanted) {
  std::vector<uint8_t> pixels(size_t(4 * width * height), 7);
  const sp_array array = array_of(pixels);
  EXPECT_EQ(sp_simulation_draw(opened.simulation, &wanted, &array), SP_OK) << opened.message();
  return pixels;
}

// The image that the program renders from a checkpoint.
std::vector<uint8_t> rendered(const ScratchFolder& folder, RenderOptions options) {
  options.backend = "cpu", options.start.resume_file = folder.path("checkpoint");
  options.output_file = folder.path("image.png");
  options.width = uint(width), options.height = uint(height), options.samples = 2;
  options.legend = options.box = false;
  testing::internal::CaptureStdout();
  const std::string complaint = complaint_of([&] { EXPECT_EQ(render_command({{"test"}, {}}, options), kOk); });
  testing::internal::GetCapturedStdout();
  EXPECT_EQ(complaint, "");
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&image, options.output_file.c_str())) return {};
  image.format = PNG_FORMAT_RGBA;
  std::vector<uint8_t> pixels(PNG_IMAGE_SIZE(image));
  png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr);
  return pixels;
}

struct Case {
  const char* name;
  std::function<void(sp_drawing&)> in_library;
  std::function<void(RenderOptions&)> in_program;
};

std::vector<Case> cases() {
  static const double eye[] = {3, 2.5, 4}, target[] = {0.5, 1, 0.25}, up[] = {0, 0, 1}, speeds[] = {0.25, 1.5},
                      radii[] = {0.1, 0.25};
  return {
      {"contacts", [](sp_drawing&) {}, [](RenderOptions&) {}},
      {"plain", [](sp_drawing& d) { d.plain = 1; }, [](RenderOptions& o) { o.plain = true; }},
      {"no ground, seen from behind",
       [](sp_drawing& d) { d.no_ground = 1, d.azimuth = -160, d.elevation = -5, d.field = 50; },
       [](RenderOptions& o) {
         o.ground = "none", o.camera.azimuth = -160, o.camera.elevation = -5, o.camera.field = 50;
       }},
      {"speed",
       [](sp_drawing& d) {
         d.color = "speed", d.eye = eye, d.target = target, d.azimuth = d.elevation = 0, d.nearest = 3.5;
       },
       [](RenderOptions& o) {
         o.colour = "speed", o.camera.eye = {eye, eye + 3}, o.camera.target = {target, target + 3}, o.camera.near = 3.5;
       }},
      {"speed of a range", [](sp_drawing& d) { d.color = "speed", d.color_range = speeds, d.plain = 1; },
       [](RenderOptions& o) {
         o.colour = "speed", o.colour_range = {0.25, 1.5}, o.plain = true;
       }},
      {"radius, z upwards", [](sp_drawing& d) { d.color = "radius", d.up = up, d.no_ground = 1; },
       [](RenderOptions& o) {
         o.colour = "radius", o.camera.up = {0, 0, 1}, o.ground = "none";
       }},
      {"radius of a range", [](sp_drawing& d) { d.color = "radius", d.color_range = radii; },
       [](RenderOptions& o) {
         o.colour = "radius", o.colour_range = {0.1, 0.25};
       }}};
}

TEST(SimulationDraw, HasThePixelsOfTheProgramOnEveryBackend) {
  const ScratchFolder folder;
  GivenSpheres spheres = many_spheres();
  for (const char* law : {"none", "spring"}) {
    sp_scene given = spheres.scene(law);
    given.gravity = 9.81, given.plane = 0.125;
    OpenSimulation start(given);
    ASSERT_EQ(start.status, SP_OK) << start.message();
    start.move(12);
    ASSERT_EQ(sp_simulation_save(start.simulation, folder.path("checkpoint").c_str()), SP_OK) << start.message();
    std::vector<std::vector<uint8_t>> expected;
    for (const Case& each : cases()) {
      RenderOptions options;
      each.in_program(options);
      expected.push_back(rendered(folder, options));
    }
    for (size_t k = 1; k < expected.size(); ++k) EXPECT_NE(expected[k], expected[k - 1]) << "images tell nothing apart";
    for (int32_t k = 0; const char* name = sp_backend_name(k); ++k) {
      OpenSimulation other(given, name);
      if (other.status == SP_E_BACKEND) continue;  // it is not here
      other.move(12);
      for (size_t image = 0; image < expected.size(); ++image)
        EXPECT_TRUE(drawn(other, drawing(cases()[image].in_library)) == expected[image])
            << law << ", " << cases()[image].name << " on " << name;
    }
  }
}

TEST(SimulationDraw, ChangesNoStepAndFollowsTheSpheres) {
  GivenSpheres spheres = many_spheres();
  sp_scene given = spheres.scene("hertz");
  given.gravity = 9.81;
  OpenSimulation seen(given), unseen(given);
  const double eye[] = {3, 2.5, 4}, target[] = {0.5, 1, 0.25};
  const sp_drawing still = drawing([&](sp_drawing& d) { d.eye = eye, d.target = target, d.azimuth = d.elevation = 0; });
  const std::vector<uint8_t> first = drawn(seen, still);
  EXPECT_EQ(drawn(seen, still), first);
  for (int k = 0; k < 5; ++k) seen.move(20), drawn(seen, still), unseen.move(20);
  EXPECT_EQ(seen.state(80), unseen.state(80));
  EXPECT_NE(drawn(seen, still), first);
}

TEST(SimulationDraw, WritesOnlyThePixels) {
  GivenSpheres spheres = many_spheres();
  OpenSimulation opened(spheres.scene());
  const sp_drawing wanted = drawing();
  const std::vector<uint8_t> expected = drawn(opened, wanted);
  constexpr int64_t stride = 4 * width + 12;
  std::vector<uint8_t> pixels(size_t(stride * height), 7);
  sp_array array = array_of(pixels, -stride);  // the upper row is the last in memory
  array.data = pixels.data() + stride * (height - 1);
  ASSERT_EQ(sp_simulation_draw(opened.simulation, &wanted, &array), SP_OK) << opened.message();
  for (int64_t row = 0; row < height; ++row) {
    const auto begin = pixels.begin() + stride * (height - 1 - row);
    const auto whole = expected.begin() + 4 * width * row;
    ASSERT_TRUE(std::equal(begin, begin + 4 * width, whole)) << row;
    ASSERT_TRUE(std::all_of(begin + 4 * width, begin + stride, [](uint8_t byte) { return byte == 7; })) << row;
  }
}

TEST(SimulationDraw, SpheresAtRestAndNoneAreDrawn) {
  GivenSpheres still{.positions = {0, 1, 0}, .radii = {0.5}}, none{.positions = {}, .radii = {}};
  OpenSimulation resting(still.scene());
  const std::vector<uint8_t> pixels = drawn(resting, drawing([](sp_drawing& d) { d.color = "speed", d.plain = 1; }));
  EXPECT_GT(std::count(pixels.begin(), pixels.end(), 255), 4 * width) << "a background";
  EXPECT_LT(std::count(pixels.begin(), pixels.end(), 255), 4 * width * height - 3 * width) << "a sphere";
  sp_scene given = none.scene();
  given.positions = {nullptr, 0, 3, 3, 1, SP_F64, 1, 0}, given.radii = {nullptr, 0, 1, 1, 1, SP_F64, 1, 0};
  OpenSimulation empty(given);
  ASSERT_EQ(empty.status, SP_OK) << empty.message();
  EXPECT_EQ(drawn(empty, drawing([](sp_drawing& d) { d.plain = 1; })),
            std::vector<uint8_t>(size_t(4 * width * height), 255));
  drawn(empty, drawing());
}

TEST(SimulationDraw, WrongUseIsRefused) {
  GivenSpheres spheres = many_spheres();
  OpenSimulation opened(spheres.scene());
  std::vector<uint8_t> pixels(size_t(4 * width * height), 7);
  const auto expect = [&](sp_status status, const std::string& says, auto change) {
    sp_drawing wanted = drawing();
    sp_array array = array_of(pixels);
    change(wanted, array);
    EXPECT_EQ(sp_simulation_draw(opened.simulation, &wanted, &array), status) << says;
    EXPECT_NE(opened.message().find(says), std::string::npos) << opened.message();
    EXPECT_EQ(opened.message().find("--"), std::string::npos) << "an option of the program: " << opened.message();
  };
  static const double nowhere[] = {NAN, 0, 0}, zeros[] = {0, 0, 0}, far[] = {1e16, 0, 0}, falling[] = {2, 1};
  using D = sp_drawing;
  using A = sp_array;
  expect(SP_E_ARGUMENT, "drawing.size is 8", [](D& d, A&) { d.size = 8; });
  expect(SP_E_ARGUMENT, "pixels has 7 columns, but each pixel has 4", [](D&, A& a) { a.columns = 7; });
  expect(SP_E_ARGUMENT, "pixels has 0 rows of 96 pixels", [](D&, A& a) { a.rows = 0; });
  expect(SP_E_ARGUMENT, "but each must be 1 to 16384", [](D&, A& a) { a.columns = int64_t(1) << 40; });
  expect(SP_E_ARGUMENT, "pixels is of type F32, but must be U8", [](D&, A& a) { a.type = SP_F32; });
  expect(SP_E_ARGUMENT, "no data", [](D&, A& a) { a.data = nullptr; });
  expect(SP_E_ARGUMENT, "a device of type 2", [](D&, A& a) { a.device_type = 2; });
  expect(SP_E_ARGUMENT, "samples is -1", [](D& d, A&) { d.samples = -1; });
  expect(SP_E_ARGUMENT, "unknown quantity 'sped'", [](D& d, A&) { d.color = "sped"; });
  expect(SP_E_ARGUMENT, "color is species", [](D& d, A&) { d.color = "species"; });
  expect(SP_E_ARGUMENT, "color_range is of radius and speed, not of contacts", [](D& d, A&) { d.color_range = zeros; });
  expect(SP_E_ARGUMENT, "color_range is 2,1, but must ascend",
         [](D& d, A&) { d.color = "speed", d.color_range = falling; });
  expect(SP_E_ARGUMENT, "azimuth is 400", [](D& d, A&) { d.azimuth = 400; });
  expect(SP_E_ARGUMENT, "elevation is -91", [](D& d, A&) { d.elevation = -91; });
  expect(SP_E_ARGUMENT, "azimuth is given, but with an eye", [](D& d, A&) { d.eye = zeros; });
  expect(SP_E_ARGUMENT, "field 180", [](D& d, A&) { d.field = 180; });
  expect(SP_E_ARGUMENT, "nearest is -1", [](D& d, A&) { d.nearest = -1; });
  expect(SP_E_ARGUMENT, "up direction is 0,0,0", [](D& d, A&) { d.up = zeros; });
  expect(SP_E_ARGUMENT, "no number below 1e15", [](D& d, A&) { d.target = far; });
  expect(SP_E_ARGUMENT, "eye and target must differ",
         [](D& d, A&) { d.eye = d.target = zeros, d.azimuth = d.elevation = 0; });
  expect(SP_E_ARGUMENT, "leave the ground out", [](D& d, A&) { d.elevation = -80; });
  expect(SP_E_NONFINITE, "eye[0] is not finite", [](D& d, A&) { d.eye = nowhere; });
  expect(SP_E_NONFINITE, "field is not finite", [](D& d, A&) { d.field = NAN; });
  expect(SP_E_NONFINITE, "azimuth is not finite", [](D& d, A&) { d.azimuth = INFINITY; });
  EXPECT_EQ(pixels, std::vector<uint8_t>(pixels.size(), 7)) << "something was written";
  const sp_drawing wanted = drawing();
  const sp_array array = array_of(pixels);
  EXPECT_EQ(sp_simulation_draw(opened.simulation, nullptr, &array), SP_E_ARGUMENT);
  EXPECT_EQ(sp_simulation_draw(opened.simulation, &wanted, nullptr), SP_E_ARGUMENT);
  EXPECT_EQ(sp_simulation_draw(nullptr, &wanted, &array), SP_E_ARGUMENT);
  EXPECT_EQ(drawn(opened, wanted).size(), pixels.size()) << "the simulation stays usable";
}

}  // namespace
}  // namespace spherepair
