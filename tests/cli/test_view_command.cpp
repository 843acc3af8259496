// SPDX-License-Identifier: MIT
// spherepair view in a window of its own X server: it shows spheres and goes on with the same bits on every backend.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <png.h>
#include <signal.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

#include "bench/cli/commands.h"
#include "common/shared/hash.h"
#include "tests/support/backends.h"
#include "tests/support/sphere_files.h"

namespace spherepair {
namespace {

struct Ended {
  int code;
  std::string said;
};
Ended run(const std::string& words, const ScratchFolder& folder) {
  const int status = std::system(fmt::format("{} > {} 2>&1", words, folder.path("said")).c_str());
  return {WEXITSTATUS(status), read_bytes(folder.path("said"))};
}

bool finds(const char* program) { return std::system(fmt::format("command -v {} >/dev/null", program).c_str()) == 0; }

// One X server for all tests of the suite.
class ViewCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!finds("Xvfb") || !std::filesystem::exists(SPHEREPAIR_PROGRAM)) return;
    server_ = popen("echo $$; exec Xvfb -displayfd 1 -screen 0 800x600x24 -nolisten tcp -ac 2>/dev/null", "r");
    if (server_ && std::fscanf(server_, "%d %d", &process_, &display_) != 2) display_ = -1;
  }
  static void TearDownTestSuite() {
    if (!server_) return;
    if (process_ > 0) kill(process_, SIGTERM);
    pclose(server_);
  }
  void SetUp() override {
    if (!std::filesystem::exists(SPHEREPAIR_PROGRAM)) GTEST_SKIP() << "no " << SPHEREPAIR_PROGRAM << " here";
  }
  Ended view(const std::string& more, const char* size = "640x480") {
    return run(fmt::format("DISPLAY=:{} {} view --scene random --n 300 --size {} {}", display_, SPHEREPAIR_PROGRAM,
                           size, more),
               folder_);
  }
  // Why nothing can be shown; empty where a window can open.
  std::string why_no_windows() {
    if (display_ < 0) return "Xvfb is not installed, or does not start (Debian: xvfb)";
    static const std::string said = view("--backend cpu --frames 1").said;
    return said.find("built without windows") != std::string::npos ? said : "";
  }
  const ScratchFolder folder_;

 private:
  static inline FILE* server_ = nullptr;
  static inline int process_ = 0, display_ = -1;
};

// EGL opens windows only where a driver of its own reaches the display.
bool lacks_egl_windows(const Ended& ended) {
  return ended.code == kDeviceFailure && ended.said.find("EGL: Failed to get EGL display") != std::string::npos;
}

// The text from the last ": step" on.
std::string totals_in(const std::string& said) { return said.substr(said.rfind(": step")); }

struct Shot {
  uint width = 0, height = 0;
  std::vector<uint> pixels;
};
Shot shot_in(const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&image, file.c_str())) return {};
  image.format = PNG_FORMAT_RGBA;
  Shot shot{image.width, image.height, std::vector<uint>(size_t(image.width) * image.height)};
  return png_image_finish_read(&image, nullptr, shot.pixels.data(), 0, nullptr) ? shot : Shot();
}

uint64_t hash_of(const Shot& shot) {
  uint64_t hash = splitmix64(shot.width);
  for (uint pixel : shot.pixels) hash = splitmix64(hash ^ pixel);
  return hash;
}

TEST_F(ViewCommand, ShowsSpheresAndThePanel) {
  if (const std::string why = why_no_windows(); !why.empty()) GTEST_SKIP() << why;
  const std::string file = folder_.path("shot.png");
  const Ended ended = view("--backend cpu --frames 4 --screenshot " + file);
  ASSERT_EQ(ended.code, kOk) << ended.said;
  EXPECT_NE(ended.said.find("plane at y = -5\n"), std::string::npos) << ended.said;
  const Shot shot = shot_in(file);
  ASSERT_EQ(shot.width, 640u);
  ASSERT_EQ(shot.height, 480u);
  const auto colours = [&](uint left, uint right) {
    std::set<uint> found;
    for (uint y = 0; y < shot.height; ++y)
      for (uint x = left; x < right; ++x) found.insert(shot.pixels[y * shot.width + x]);
    return found.size();
  };
  EXPECT_GT(colours(0, 200), 30u) << "the panel";
  EXPECT_GT(colours(400, 640), 100u) << "the spheres";
}

// Also where they never leave OpenGL or CUDA: the pixels of the window itself, without its panel.
TEST_F(ViewCommand, ShowsTheSamePixelsOnEveryBackend) {
  if (const std::string why = why_no_windows(); !why.empty()) GTEST_SKIP() << why;
  for (const std::string draw : {"", "d", "dddd", "ddddd"}) {
    const auto pixels_of = [&](const std::string& backend) {
      const std::string file = folder_.path(backend + ".png");
      const Ended ended =
          view(fmt::format("--backend {} --frames 8 --keys h{} --screenshot {}", backend, draw, file), "240x180");
      EXPECT_EQ(ended.code, kOk) << ended.said;
      EXPECT_NE(ended.said.find("images stay in the window's OpenGL context"), std::string::npos) << ended.said;
      return read_bytes(file);
    };
    const std::string cpu = pixels_of("cpu");
    for (Backend* backend : open_backends()) {
      const std::string name = backend->info().name;
      if (backend->info().on_host || draw.size() >= drawing_of(*backend).draw_methods().size()) continue;
      if (name == "vulkan" && !draw.empty() && !is_gpu(*backend)) continue;  // of the same OpenGL
      EXPECT_TRUE(pixels_of(name) == cpu) << name << ", drawing method " << draw.size();
    }
    EXPECT_GT(cpu.size(), 5000u) << "a blank window";
    if (!draw.empty()) continue;
    const std::string own = folder_.path("own.png");
    const Ended ended = view("--backend opengl --gl-device 0 --frames 8 --keys h --screenshot " + own, "240x180");
    if (lacks_egl_windows(ended)) continue;
    EXPECT_NE(ended.said.find("images are uploaded to the window"), std::string::npos) << ended.said;
    EXPECT_EQ(read_bytes(own), cpu) << "in a context of its own";
  }
}

// The rasteriser's bits reach the window of any driver.
TEST_F(ViewCommand, ShowsTheRecordedPixels) {
  if (const std::string why = why_no_windows(); !why.empty()) GTEST_SKIP() << why;
  for (const Backend* backend : open_backends()) {
    const std::string file = folder_.path("shot.png"), name = backend->info().name;
    const Ended ended = view(fmt::format("--backend {} --speed max --frames 8 --keys h --screenshot {}", name, file));
    EXPECT_EQ(hash_of(shot_in(file)), 0x708fdaff5622542bu) << name << ": " << ended.said;
  }
}

TEST_F(ViewCommand, WhatStandsStillIsAntialiasedTheSameOnEveryBackend) {
  if (const std::string why = why_no_windows(); !why.empty()) GTEST_SKIP() << why;
  const std::string file = folder_.path("still.png");
  const auto shown = [&](const std::string& options) {
    return view(fmt::format("{} --keys 'h ' --screenshot {}", options, file), "240x180");
  };
  const auto pixels_of = [&](const std::string& options) {
    const Ended ended = shown(options);
    EXPECT_EQ(ended.code, kOk) << ended.said;
    return read_bytes(file);
  };
  const std::string still = pixels_of("--backend cpu --frames 17");
  EXPECT_FALSE(still == pixels_of("--backend cpu --frames 16")) << "a sample is missing";
  EXPECT_TRUE(still == pixels_of("--backend cpu --frames 20"));
  EXPECT_TRUE(still == pixels_of("--backend opengl --frames 17"));
  if (lacks_egl_windows(shown("--backend opengl --gl-device 0 --frames 1"))) return;
  EXPECT_TRUE(still == pixels_of("--backend opengl --gl-device 0 --frames 17")) << "in a context of its own";
}

TEST_F(ViewCommand, SavesImagesAndCloses) {
  if (const std::string why = why_no_windows(); !why.empty()) GTEST_SKIP() << why;
  const std::string shot = folder_.path("shot.png");
  const Ended ended = view("--backend cpu --speed max --keys ...s..sq --screenshot " + shot);
  EXPECT_EQ(ended.code, kOk) << ended.said;
  EXPECT_NE(ended.said.find("step 7"), std::string::npos) << ended.said;
  const std::vector<std::string> names = folder_.names();
  EXPECT_EQ(names, (std::vector<std::string>{"said", "shot.png", "spherepair-4.png", "spherepair-7.png"}));
}

TEST_F(ViewCommand, HelpListsKeysInLinesOf100Columns) {
  const Ended ended = run(fmt::format("{} view --help", SPHEREPAIR_PROGRAM), folder_);
  std::istringstream lines(ended.said.substr(std::min(ended.said.find("Keys:"), ended.said.size())));
  size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 100u) << line;
  EXPECT_GT(count, 8u) << ended.said;
}

TEST_F(ViewCommand, RefusesASpeedThatIsNone) {
  for (const std::string speed : {"-1", "fast", "1e9", "nan", "''"}) {
    const Ended ended = run(fmt::format("{} view --speed {}", SPHEREPAIR_PROGRAM, speed), folder_);
    EXPECT_EQ(ended.code, kUsage) << speed << ": " << ended.said;
    EXPECT_NE(ended.said.find("--speed"), std::string::npos) << ended.said;
  }
}

TEST_F(ViewCommand, GoesOnWithTheSameBits) {
  if (const std::string why = why_no_windows(); !why.empty()) GTEST_SKIP() << why;
  const Ended plain = view("--backend cpu --frames 9");
  ASSERT_EQ(plain.code, kOk) << plain.said;
  EXPECT_NE(plain.said.find("step 9"), std::string::npos) << plain.said;
  const Ended switched = view("--backend cpu --frames 9 --keys bmmdlbd");
  ASSERT_EQ(switched.code, kOk) << switched.said;
  EXPECT_EQ(totals_in(switched.said), totals_in(plain.said));
  const Ended paused = view("--backend cpu --frames 14 --keys ' xxxx x'");  // five frames stand still
  EXPECT_EQ(totals_in(paused.said), totals_in(plain.said));
}

TEST_F(ViewCommand, NamesRenderWhereNoDisplayIs) {
  const Ended ended = run(fmt::format("env -u DISPLAY -u WAYLAND_DISPLAY {} view --n 10", SPHEREPAIR_PROGRAM), folder_);
  EXPECT_EQ(ended.code, kDeviceFailure);
  EXPECT_NE(ended.said.find("spherepair render"), std::string::npos) << ended.said;
}

}  // namespace
}  // namespace spherepair
