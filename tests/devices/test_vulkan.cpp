// SPDX-License-Identifier: MIT
// What only Vulkan has: a loader and drivers that may be missing, rules that a layer checks, limits of its own.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "bench/cli/commands.h"
#include "tests/oracle/oracle.h"
#include "tests/support/backends.h"
#include "tests/support/grid_results.h"
#include "tests/support/images.h"
#include "tests/support/program.h"
#include "tests/support/sphere_files.h"

namespace spherepair {
namespace {

constexpr const char* layer = "VK_LAYER_KHRONOS_validation";
constexpr const char* of_built_program = "not in this build";

const OpenedBackend& vulkan() { return *std::ranges::find(all_backends(), "vulkan", &OpenedBackend::name); }

bool layer_installed() {
  return std::ranges::any_of(std::array{"/usr/share", "/usr/local/share", "/etc"}, [](const std::string& root) {
    return std::filesystem::exists(root + "/vulkan/explicit_layer.d/VkLayer_khronos_validation.json");
  });
}

std::string complaint_of_opening(const OpenOptions& options) {
  try {
    open_backend("vulkan", options);
  } catch (const BackendError& error) {
    return error.what();
  }
  return "";
}

class Vulkan : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (vulkan().backend) return;
    if (backend_required("vulkan")) FAIL() << vulkan().reason;
    GTEST_SKIP() << vulkan().reason;
  }
  // With the layer that checks what Vulkan's rules are, and that nothing reads what no barrier makes visible.
  void expect_valid(const std::string& arguments) const {
    const Outcome outcome = run(arguments, fmt::format("VK_LOADER_DEBUG=layer VK_INSTANCE_LAYERS={} VK_LAYER_ENABLES="
                                                       "VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT",
                                                       layer));
    const std::string all = outcome.output + outcome.errors;
    EXPECT_EQ(outcome.code, kOk) << arguments << "\n" << outcome.errors;
    EXPECT_NE(all.find(fmt::format("Insert instance layer \"{}\"", layer)), std::string::npos) << "no layer";
    for (const char* report : {"SYNC-HAZARD", "VUID-", "UNASSIGNED-"})
      EXPECT_EQ(all.find(report), std::string::npos) << arguments << "\n" << all.substr(0, 4000);
  }
};

// Mesa's renderer gives right results without any barrier, so that only the layer sees a missing one.
TEST_F(Vulkan, ValidationFindsNothing) {
  if (!layer_installed()) GTEST_SKIP() << layer << " is not installed (package vulkan-validationlayers)";
  expect_valid(fmt::format("compare --quick --scenes random,uniform --backends cpu,vulkan --tables none --results '{}'",
                           path("compare")));
  for (const char* motion : {"paper", "anchored"})
    expect_valid(fmt::format("run --backend vulkan --scene random --n 2000 --steps 40 --motion {}", motion));
  expect_valid(fmt::format("render --backend vulkan --n 2000 --steps 3 --images 3 --size 160x90 --output '{}'",
                           path("image.png")));
}

TEST_F(Vulkan, AMissingDriverIsSaid) {
  const Outcome outcome = run("run --backend vulkan --n 64", "VK_DRIVER_FILES=/nowhere VK_ICD_FILENAMES=/nowhere");
  EXPECT_EQ(outcome.code, kDeviceFailure);
  EXPECT_NE(outcome.errors.find("vulkan: the loader finds no driver; install"), std::string::npos) << outcome.errors;
}

// The folder may be damaged, and may not be written.
TEST_F(Vulkan, KeepsSpirvForLaterProcesses) {
  namespace fs = std::filesystem;
  const fs::path folder = path("cache");
  const auto pairs = [&](const std::string& cache) {
    const Outcome outcome = run(fmt::format("run --backend vulkan --n 300 --steps 2 --pairs '{}'", path("pairs.npy")),
                                fmt::format("SPHEREPAIR_CACHE='{}'", cache));
    EXPECT_EQ(outcome.code, kOk) << outcome.errors;
    return read_bytes(path("pairs.npy"));
  };
  const auto files = [&] {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::directory_iterator(folder)) found[entry.path()] = read_bytes(entry.path());
    return found;
  };
  const std::string expected = pairs("");
  EXPECT_TRUE(std::ranges::none_of(fs::directory_iterator("."), [](const auto& e) {
    return e.path().extension() == ".spv";
  })) << "kept where the program runs";
  EXPECT_EQ(pairs(folder), expected);
  const auto kept = files();
  EXPECT_GE(kept.size(), 3u);
  std::vector<fs::file_time_type> times;
  for (const auto& [file, bytes] : kept) times.push_back(fs::last_write_time(file));
  EXPECT_EQ(pairs(folder), expected);
  size_t at = 0;
  for (const auto& [file, bytes] : kept) EXPECT_EQ(fs::last_write_time(file), times[at++]) << "was compiled again";
  for (const auto& [file, bytes] : kept) {
    std::string damaged = bytes;
    damaged[damaged.size() / 2] ^= 1;
    std::ofstream(file) << (at++ % 2 ? damaged : bytes.substr(0, bytes.size() / 2));
  }
  EXPECT_EQ(pairs(folder), expected);
  EXPECT_EQ(files(), kept) << "damaged files were not replaced";
  EXPECT_EQ(pairs("/dev/null/nowhere"), expected);
}

TEST_F(Vulkan, SoftwareIsRefusedWhereHardwareIsRequired) {
  const std::string said = complaint_of_opening({.require_hardware = true, .allow_gpu = false});
  EXPECT_TRUE(said.starts_with("vulkan: no ")) << said;
  EXPECT_EQ(said.find(of_built_program), std::string::npos) << said;
}

TEST_F(Vulkan, RefusesTransfersThatItLacks) {
  Backend& backend = *vulkan().backend;
  if (const std::string why = why_no_pipeline(backend); !why.empty()) GTEST_SKIP() << why;
  const Scene scene = make_scene({.name = "uniform", .n = 10});
  backend.upload(scene);
  const View view = make_view(frame(bounds_of(scene.positions), 30, 20, 40, 1), contact_look(), 32, 32);
  const auto complaint = [&](Transfer way) -> std::string {
    try {
      drawing_of(backend).draw(view, {.method = DrawMethod::mesh, .transfer = way});
    } catch (const BackendError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(complaint(Transfer::registered).find("maps no buffers"), std::string::npos);
  const std::string imported = complaint(Transfer::imported);
  EXPECT_EQ(imported.find("share no memory") != std::string::npos,
            drawing_of(backend).transfers().back() == Transfer::host)
      << imported;
}

TEST_F(Vulkan, ATableLongerThanATexelBufferIsReadWithoutOne) {
  const std::unique_ptr<Backend> small = open_backend("vulkan", {.texels = 1000});
  const Scene scene = make_scene({.name = "uniform", .n = 5000});
  small->upload(scene);
  CollideOptions options = grid_step([](CollideOptions& o) { o.grid.cells = Cells::dense, o.want_pairs = true; });
  EXPECT_EQ(first_mismatch(run_step(*small, options), brute_force_pairs(scene.positions), scene.size()), "");
  options.api.texture_table = true;
  EXPECT_THROW(small->collide(options), BackendError);
  options.api.texture_table = {};
  EXPECT_EQ(first_mismatch(run_step(*small, options), brute_force_pairs(scene.positions), scene.size()), "");
}

// More launches than a ring of parameters and a pool of descriptor sets hold, none waited for.
TEST_F(Vulkan, LongRunsWithoutAWaitStayRight) {
  Backend &backend = *vulkan().backend, &cpu = *all_backends().front().backend;
  const Scene scene = make_scene({.name = "random", .n = 64});
  CollideOptions options = fast_method(backend);
  options.api.graph = false;
  for (Backend* each : {&backend, &cpu}) each->upload(scene);
  for (int k = 0; k < 6000; ++k) backend.enqueue_step(options), cpu.move();
  EXPECT_EQ(hash_of_state(backend), hash_of_state(cpu));
  EXPECT_TRUE(same_result(run_step(backend, options), run_step(cpu, fast_method(cpu))));
}

}  // namespace
}  // namespace spherepair
