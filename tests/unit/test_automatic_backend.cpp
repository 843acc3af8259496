// SPDX-License-Identifier: MIT
// The backend that is taken where none is named: without a GPU, OpenGL and Vulkan in software are not even opened.
#include "bench/io/context.h"
#include "bench/measure/choice.h"
#include "tests/support/sphere_files.h"

namespace spherepair {
namespace {

// Opens the CPU alone, and notes what was asked for.
struct Asked {
  std::vector<std::string> names;
  Opener opener = [this](const std::string& name, const OpenOptions& options) {
    names.push_back(name);
    if (name != "cpu") throw BackendError(name + ": not here");
    return open_backend(name, options);
  };
};

TEST(AutomaticBackend, TriesAGpuOnlyWhereOneIsShown) {
  Asked asked;
  const ChosenBackend chosen = choose_backend("", {}, asked.opener);
  const std::vector<std::string> all = {"cuda", "vulkan", "opengl", "cpu"}, cpu = {"cpu"};
  EXPECT_EQ(asked.names, gpu_nodes_present() ? all : cpu);
  EXPECT_EQ(chosen.backend->info().name, "cpu");
  EXPECT_EQ(chosen.passed_over.size(), 3u);
}

TEST(AutomaticBackend, TriesWhatAnOptionAsksFor) {
  Asked asked;
  EXPECT_THROW(choose_backend("", {.require_hardware = true}, asked.opener), BackendError);
  EXPECT_EQ(asked.names, (std::vector<std::string>{"cuda", "vulkan", "opengl"}));
}

TEST(AutomaticBackend, KnowsTheNodesOfGpus) {
  namespace fs = std::filesystem;
  const ScratchFolder folder;
  folder.write("null", "");
  fs::create_directory(folder.path("dri"));
  EXPECT_FALSE(gpu_nodes_present(folder.path("")));
  for (const char* node : {"nvidia0", "nvidiactl", "dxg", "nvmap", "dri/renderD128"}) {
    folder.write(node, "");
    EXPECT_TRUE(gpu_nodes_present(folder.path(""))) << node;
    fs::remove(folder.path(node));
  }
  EXPECT_TRUE(gpu_nodes_present(folder.path("missing"))) << "nothing is known";
}

}  // namespace
}  // namespace spherepair
