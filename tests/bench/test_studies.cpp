// SPDX-License-Identifier: MIT
// spherepair crossover and spherepair ablate as a user runs them: their records and what they refuse.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "api/open.h"
#include "bench/io/report.h"
#include "bench/studies/frames_study.h"
#include "tests/support/forwarding_backend.h"
#include "tests/support/sphere_files.h"

namespace spherepair {
namespace {

class Studies : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(SPHEREPAIR_PROGRAM)) GTEST_SKIP() << "no " << SPHEREPAIR_PROGRAM << " here";
  }
  int run(const std::string& words) const {
    const std::string command = std::string(SPHEREPAIR_PROGRAM) + " " + words + " > " + folder_.path("said") + " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  std::string said() const {
    std::ifstream file(folder_.path("said"));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  json record(const std::string& name) const { return json::parse(std::ifstream(folder_.path(name))); }

  const ScratchFolder folder_;
};

void expect_measurements(const json& rows, const std::string& table) {
  ASSERT_FALSE(rows.empty());
  for (const json& row : rows) {
    EXPECT_EQ(row.at("table"), table);
    EXPECT_EQ(row.at("samples_ms").size(), 1u);
    EXPECT_GT(row.at("median_ms").get<double>(), 0);
    EXPECT_TRUE(row.at("scene").contains("name"));
  }
}

TEST_F(Studies, CrossoverNamesTheChoiceAndItsReason) {
  const std::string words = "crossover --backends cpu --n 100,3000 --kinds gas,one_cell --rounds 1 --results ";
  ASSERT_EQ(run(words + folder_.path("crossover")), 0) << said();
  const json found = record("crossover/crossover.json");
  expect_measurements(found.at("measurements"), "crossover");
  EXPECT_LE(found.at("measurements").size(), 16u) << "two kinds, two sizes, four ways";
  EXPECT_GE(found.at("measurements").size(), 14u) << "all pairs may be stopped";
  EXPECT_TRUE(found.at("complete"));
  EXPECT_EQ(found.at("auto").size(), 4u);
  for (const json& row : found.at("auto")) {
    EXPECT_NEAR(row.at("loss_percent"), 100 * (row.at("auto_ms").get<double>() / row.at("best_ms").get<double>() - 1),
                1e-6);
  }
  EXPECT_NE(said().find("In 0 of 4 rows auto takes at most 1.1x"), std::string::npos) << said();
  EXPECT_NE(said().find("4 not decided by this data"), std::string::npos) << "a round decides nothing: " << said();
}

// The CPU, whose spheres OpenGL draws as if they were CUDA's.
class Transferring : public ForwardingBackend {
 public:
  Transferring() : ForwardingBackend("cpu", open_backend("cpu", {})) {}
  std::vector<DrawMethod> draw_methods() const override { return {DrawMethod::compute, DrawMethod::points}; }
  std::vector<Transfer> transfers() const override { return {Transfer::host, Transfer::registered}; }
  void transfer(Transfer) override {}
  void enqueue_draw(const View& view, const DrawOptions& options) override { draw(view, options); }
  void draw(const View& view, const DrawOptions& options) override {
    const bool transferred = options.method == DrawMethod::points;
    ForwardingBackend::draw(view, transferred ? DrawOptions{} : options);
  }
};

FramesOptions transfers(const std::vector<std::string>& draws) {
  return {.draws = draws,
          .places = {"outside"},
          .works = {"frame"},
          .width = 64,
          .height = 48,
          .transfer = true,
          .rounds = 1,
          .min_seconds = 1e-4};
}

TEST_F(Studies, FramesTellsCudasImagesFromThoseOfTransfers) {
  Session session({"cpu"}, {}, [](const std::string&, const OpenOptions&) { return std::make_unique<Transferring>(); });
  const FramesOptions options = transfers({"compute", "points"});
  FramesStudy study(session, options);
  study.measure_size(64);
  const auto transferred = [](const json& entry) { return entry.contains("transferred"); };
  EXPECT_EQ(std::ranges::count_if(study.frames, transferred), 1 + 2 + 2 * 2) << "a step, two ways alone, with images";
  EXPECT_EQ(study.frames.size(), 2u + 7u);
  EXPECT_EQ(study.overlaps.size(), 2u);
  for (const json& entry : study.frames) EXPECT_EQ(entry.value("to", ""), transferred(entry) ? "opengl" : "");
  const std::string text = study.text_of(64, kTextWidth);
  for (const char* word : {"compute", "points", "host", "registered", "pipelined"})
    EXPECT_NE(text.find(word), std::string::npos) << word << " in\n" << text;
}

// OpenGL by any name, with its buffers.
class WithBuffers : public ForwardingBackend, public DevicePositions {
 public:
  WithBuffers(const std::string& name, std::unique_ptr<Backend> real) : ForwardingBackend(name, std::move(real)) {
    info_.software = false;  // else CUDA has no crossover
  }
  Device* device() override { return forwarded().device(); }
  DevicePositions* device_positions() override { return this; }
  const Memory& positions() override { return forwarded().device_positions()->positions(); }
  void positions_changed() override { ++changes, forwarded().device_positions()->positions_changed(); }
  int changes = 0;
};

TEST_F(Studies, FramesTimesExchangesOfVulkanAndCuda) {
  Session session({"vulkan", "cuda"}, {}, [](const std::string& name, const OpenOptions&) {
    return std::make_unique<WithBuffers>(name, open_backend("opengl", {}));
  });
  const FramesOptions options = transfers({"compute"});
  FramesStudy study(session, options);
  study.measure_size(64);
  ASSERT_EQ(study.frames.size(), 2u + 2u) << "two images, each direction through the host; " << study.left_out;
  for (const size_t k : {2, 3}) {
    const json& entry = study.frames[k];
    EXPECT_EQ(entry.at("backend"), k == 2 ? "vulkan" : "cuda");
    EXPECT_EQ(entry.at("to"), k == 2 ? "cuda" : "vulkan");
    EXPECT_EQ(entry.at("work"), "host");
    EXPECT_EQ(entry.at("bytes"), 64 * sizeof(vec4));
  }
  for (const auto& each : session.backends()) EXPECT_GT(dynamic_cast<WithBuffers&>(*each).changes, 0);
  EXPECT_EQ(study.left_out.size(), 2u) << "both are OpenGL's, which shares no memory: " << study.left_out;
  const std::string text = study.text_of(64, kTextWidth);
  for (const char* word : {"from", "left out: vulkan to cuda, imported: interop: "})
    EXPECT_NE(text.find(word), std::string::npos) << word << " in\n" << text;
}

class Blind : public ForwardingBackend {
 public:
  Blind() : ForwardingBackend("cpu", open_backend("cpu", {})) {}
  Drawing* drawing() override { return nullptr; }
};

TEST_F(Studies, FramesLeavesOutWhatDoesNotDraw) {
  Session session({"cpu"}, {}, [](const std::string&, const OpenOptions&) { return std::make_unique<Blind>(); });
  const FramesOptions options = transfers({"compute"});
  FramesStudy study(session, options);
  study.measure_size(64);
  EXPECT_TRUE(study.frames.empty());
  EXPECT_EQ(study.left_out.at(0).at("reason"), "this backend does not have it");
  EXPECT_THROW(drawing_of(session.reference()), BackendError);
}

// The same image on several backends is timed in turns, those of devices with as many steps a sample.
TEST_F(Studies, FramesOfSeveralBackendsAreContests) {
  Session session({"cpu", "opengl"}, {}, [](const std::string& name, const OpenOptions&) {
    return std::make_unique<ForwardingBackend>(name, open_backend("cpu", {}));
  });
  const FramesOptions options = {.draws = {"compute"},
                                 .places = {"outside"},
                                 .works = {"frame", "loop"},
                                 .width = 64,
                                 .height = 48,
                                 .rounds = 3,
                                 .min_seconds = 1e-4};
  FramesStudy study(session, options);
  study.measure_size(64);
  ASSERT_EQ(study.frames.size(), 4u) << study.left_out;
  for (size_t i = 0; i < 4; i += 2) {
    const json &left = study.frames[i], &right = study.frames[i + 1];
    EXPECT_EQ(left.at("backend"), "cpu");
    EXPECT_EQ(right.at("backend"), "opengl");
    EXPECT_EQ(left.at("contest"), "compute outside " + left.at("work").get<std::string>());
    for (const char* field : {"work", "contest", "image"}) EXPECT_EQ(left.at(field), right.at(field)) << field;
    for (size_t round = 0; round < 3; ++round) {
      EXPECT_EQ(left.at("turns").at(round).get<size_t>() / 2, round);
      EXPECT_EQ(right.at("turns").at(round).get<size_t>() / 2, round);
    }
  }
}

TEST_F(Studies, AblationsAreRecordedOnAndOff) {
  const std::string words = "ablate --backends cpu --n 300 --rounds 1 --results ";
  ASSERT_EQ(run(words + folder_.path("ablate")), 0) << said();
  const json rows = record("ablate/ablate.json").at("measurements");
  expect_measurements(rows, "ablation");
  int on = 0;
  for (const json& row : rows) {
    on += row.at("on").get<bool>();
    if (row.at("option") == "cells") {
      EXPECT_EQ(row.at("work_per_step").at("cells_kept"), row.at("on").get<bool>() ? 1.0 : 0.0);
    }
    if (row.at("option") == "plane_test") {
      const json& work = row.at("work_per_step");
      EXPECT_LE(work.at("bounces"), work.at("plane_tests"));
      if (!row.at("on").get<bool>()) {
        EXPECT_EQ(work.at("plane_tests"), 300);
      }
    }
  }
  EXPECT_EQ(size_t(2 * on), rows.size());
}

TEST_F(Studies, WhatIsUnknownIsRefused) {
  EXPECT_EQ(run("ablate --backends cpu --names nothing"), 2);
  EXPECT_NE(said().find("exact_stages"), std::string::npos) << said();
  EXPECT_EQ(run("crossover --backends cpu --kinds nothing"), 2);
  EXPECT_EQ(run("run --backend cpu --n 100 --method nothing"), 2);
}

TEST_F(Studies, RunNamesTheMethodThatAutoChose) {
  ASSERT_EQ(run("run --backend cpu --n 100 --scene uniform --verbose --json " + folder_.path("run.json")), 0) << said();
  EXPECT_NE(said().find("auto: parallel"), std::string::npos) << said();
  EXPECT_EQ(record("run.json").at("choice").at("name"), "parallel");
}

}  // namespace
}  // namespace spherepair
