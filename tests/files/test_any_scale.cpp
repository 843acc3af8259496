// SPDX-License-Identifier: MIT
// Spheres of any size are drawn and meet a plane that fits them.
#include <cmath>

#include "bench/cli/commands.h"
#include "bench/image/drawing_scale.h"
#include "tests/files/columns_of_files.h"

namespace spherepair {
namespace {

// The bytes of the image of these spheres with all lengths times 2^exponent, or why there is none.
struct Picture {
  std::string png, printed, complaint;
};
Picture picture_of(const std::vector<std::array<double, 4>>& spheres, int exponent, RenderOptions options = {}) {
  std::string text = fmt::format("{}\nProperties=pos:R:3:radius:R:1\n", spheres.size());
  for (const auto& s : spheres) {
    for (const double x : s) text += fmt::format("{} ", std::ldexp(x, exponent));
    text += "\n";
  }
  options.backend = "cpu";
  options.start.input_file = scratch().write("scaled.xyz", text);
  options.output_file = scratch().path("scaled.png");
  options.width = 160, options.height = 120, options.samples = 1;
  for (std::vector<double>* point : {&options.camera.eye, &options.camera.target})
    for (double& x : *point) x = std::ldexp(x, exponent);
  options.camera.near = std::ldexp(options.camera.near, exponent);
  Picture picture;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  picture.complaint = complaint_of([&] { render_command({{"test"}, {}}, options); });
  picture.printed = testing::internal::GetCapturedStdout();
  testing::internal::GetCapturedStderr();
  if (picture.complaint.empty()) picture.png = read_bytes(options.output_file);
  return picture;
}

const std::vector<std::array<double, 4>> three = {{0, 0, 0, 1}, {1.5, 0.25, 0, 0.25}, {-3, 2, 1, 0.5}};

TEST(AnyScale, ImagesOfAPowerOfTwoAreTheSame) {
  RenderOptions plain, lit;
  plain.plain = true;
  lit.colour = "radius";
  lit.legend = false;
  RenderOptions from = plain;
  from.camera.eye = {0, 3, 9}, from.camera.target = {0, 0, 1}, from.camera.near = 0.25;
  for (const RenderOptions& options : {plain, lit, from}) {
    const Picture metres = picture_of(three, 0, options);
    EXPECT_EQ(metres.complaint, "");
    for (const int exponent : {-120, -100, -60, -40, -33, -31, -30, -29, -3, 3, 40, 48, 60, 100}) {
      const Picture scaled = picture_of(three, exponent, options);
      EXPECT_EQ(scaled.complaint, "") << exponent;
      EXPECT_TRUE(scaled.png == metres.png) << "another image at 2^" << exponent;
      EXPECT_EQ(scaled.printed.find("not drawn"), std::string::npos) << scaled.printed;
    }
  }
}

TEST(AnyScale, WhatIsNotDrawnIsSaid) {
  const Picture points = picture_of({{0, 0, 0, 1}, {3, 0, 0, 0}}, 0);
  EXPECT_NE(points.printed.find("1 of 2 spheres not drawn: the smallest radius that is drawn is 9.31e-10"),
            std::string::npos)
      << points.printed;
  EXPECT_NE(picture_of({{0, 0, 0, 0}, {3, 0, 0, 0}}, 0).complaint.find("2 of 2 spheres not drawn"), std::string::npos);
  const Picture far = picture_of({{0, 0, 0, 1}, {0x1p70, 0, 0, 0x1p69}}, 0);
  EXPECT_NE(far.printed.find("1 of 2 spheres not drawn: the smallest radius"), std::string::npos)
      << far.printed << far.complaint;
  EXPECT_EQ(picture_of({{0, 0, 0, 1}}, 0).printed.find("not drawn"), std::string::npos);
}

Scene contacts_of(const std::string& text) {
  StartOptions options;
  options.input_file = scratch().write("micro.txt", text);
  options.motion.contact.law = ContactLaw::spring;
  return start_of(options, 1).scene;
}

TEST(AnyScale, ThePlaneFitsSpheresOfAMicrometre) {
  for (const double unit : {1e-4, 1e-5, 1e-6, 1e-7}) {
    const Scene scene = contacts_of(fmt::format("{0} 0 0 {1} 0 0 0\n-{0} 0 0 {1} 0.001 0 0\n", 1.1 * unit, unit));
    EXPECT_EQ(why_no_contacts(scene), "") << unit;
    EXPECT_LT(double(scene.plane), -unit) << "below the lowest sphere";
  }
  EXPECT_EQ(contacts_of("0 0 0 0.5\n3 0 0 0.5\n").plane, -5) << "as before where it fits";
  EXPECT_LT(contacts_of("0 0 0 0.001\n3e-3 -7 0 0.001\n").plane, -7);
}

}  // namespace
}  // namespace spherepair
