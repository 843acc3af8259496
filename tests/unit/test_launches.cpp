// SPDX-License-Identifier: MIT
// spherepair launches as a user runs it, the steps that it times, and which launches wait for others.
#include <fmt/format.h>

#include <algorithm>

#include "bench/gpu/launch_paths.h"
#include "bench/measure/timing.h"
#include "common/device/hazards.h"
#include "tests/support/clocked_backend.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

using Launches = ProgramTest;

bool glsl_in_software(const json& record) {
  for (const json& backend : record.at("backends"))
    if (backend.at("name") == "opengl") return backend.at("software");
  return false;
}

void expect_times_of_a_launch(const json& row, double launches) {
  const double ns = row.at("host_ns_per_launch"), us = row.at("us_per_kernel"), ms = row.at("median_ms");
  EXPECT_GT(ns, 0) << row;
  EXPECT_NEAR(row.at("host_ns_per_step"), ns * launches, 1e-6 * ns);
  EXPECT_NEAR(ms, 1e-3 * us * launches, 1e-9 * ms);
}

// Each path of OpenGL launches as it says; those of CUDA are absent where CUDA is not open. In software few spheres are
// sorted by counting, whose launches overlap nothing.
TEST_F(Launches, AreCountedAndTimedOnEveryPath) {
  if (run("devices --backends opengl").code != 0) GTEST_SKIP() << "no OpenGL here";
  const Outcome outcome =
      run(fmt::format("launches --backends cpu,opengl --n 64,300 --rounds 1 --results '{}'", path("launches")));
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const json found = read_json("launches/launches.json");
  EXPECT_TRUE(found.at("complete"));
  const bool software = glsl_in_software(found);
  EXPECT_EQ(found.at("left_out").size(), software ? 2u : 0u) << found.at("left_out");
  for (const json& one : found.at("left_out"))
    EXPECT_TRUE(one.get<std::string>().starts_with("opengl overlapping, grid of ")) << one;
  const std::map<std::string, double> launches = {{"empty", 8}, {"all_pairs", 2}, {"grid", software ? 6 : 3}};
  std::map<std::string, int> rows;
  for (const json& row : found.at("measurements")) {
    const std::string path = row.at("path"), work = row.at("work");
    ++rows[work + " " + path];
    EXPECT_EQ(row.at("table"), "launches");
    EXPECT_EQ(row.at("backend"), "opengl");
    EXPECT_TRUE(row.at("scene").contains("name"));
    const json& each = row.at("work_per_step");
    EXPECT_EQ(each.at("launches"), launches.at(work)) << path;
    EXPECT_EQ(each.at("kernels"), launches.at(work)) << path;
    EXPECT_EQ(each.at("waits"), path != "waited" ? json(0) : each.at("launches")) << path;
    EXPECT_EQ(each.at("overlapped"), path == "overlapping" ? 1 : 0) << path;
    expect_times_of_a_launch(row, launches.at(work));
  }
  std::map<std::string, int> expected = {{"empty waited", 1},      {"empty batched", 1}, {"all_pairs waited", 2},
                                         {"all_pairs batched", 2}, {"grid waited", 2},   {"grid batched", 2}};
  if (!software) expected["grid overlapping"] = 2;
  EXPECT_EQ(rows, expected);
}

TEST_F(Launches, NeedAGpuApi) {
  const Outcome outcome = run(fmt::format("launches --backends cpu --results '{}'", path("launches")));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.errors.find("none of opengl, cuda and vulkan is open"), std::string::npos) << outcome.errors;
}

// In software the buckets of a GPU's sort, each a group of 512 threads, took 800 times as long as the step of `sweep`.
TEST(TimedLaunches, OfTheGridTakeTheTimeOfASweeps) {
  std::optional<Session> session;
  try {
    session.emplace(std::vector<std::string>{"opengl"}, OpenOptions{}, open_backend);
  } catch (const BackendError& error) {
    GTEST_SKIP() << error.what();
  }
  Backend& opengl = *session->find("opengl");
  if (!opengl.info().software)
    GTEST_SKIP() << "OpenGL runs on a GPU here, where other programs' work would be timed as well";
  opengl.upload(make_scene(launch_scene(LaunchWork::grid, 64)));
  const auto batched = [](const LaunchPath& one) {
    return std::string_view(one.backend) == "opengl" && std::string_view(one.name) == "batched";
  };
  const LaunchPath& path = *std::ranges::find_if(launch_paths(), batched);
  const auto contender = [&](const char* label, std::function<void(Backend&)> step) {
    return Contender{
        .label = label, .backend = &opengl, .step = std::move(step), .contest = "step", .alternates = true};
  };
  const CollideOptions swept = {.method = Method::collide_grid, .grid = {.keep_cells = false}};
  const std::vector<Contender> contenders = {
      contender("launches", [&](Backend& b) { enqueue_steps(path, LaunchWork::grid, b, 1); }),
      contender("sweep", [&](Backend& b) { b.enqueue_collide(swept); })};
  Sampling sampling;
  sampling.rounds = 5, sampling.longest = 0.05, sampling.software_seconds = 0.005;
  Progress progress;
  const std::vector<Samples> samples = measure(*session, contenders, sampling, progress);
  const double ratio = contest(samples[0], samples[1]).ratio;
  EXPECT_GT(ratio, 0.5);
  EXPECT_LT(ratio, 2);
}

// What the host takes to enqueue is told apart from the wait behind it.
TEST(TimedLaunches, EnqueuingEndsBeforeTheWait) {
  ClockedSession on;
  on["opengl"].fixed = 1e-3;
  const Batch batch = time_batch(on.contender("opengl"), 64, 0, on.sampling.clocks);
  EXPECT_NEAR(batch.enqueuing, 64 * 1e-5, 1e-12);
  EXPECT_NEAR(batch.seconds, 64 * 1e-5 + 1e-3, 1e-12);
}

Launch in_order(Kernel kernel, Order order) { return {.kernel = kernel, .block = SERVICE_BLOCK, .order = order}; }
Launch split_tiles() { return {.kernel = Kernel::split_tiles, .block = SPLIT_BLOCK, .target = Order::buckets}; }
Launch move(Slots unused) { return {.kernel = Kernel::move, .block = SERVICE_BLOCK, .unused = unused}; }
constexpr Slots results = slots::count | slots::summary;

// Of a search in cell order the next sort needs nothing, nor does a move that clears no results. A search in the
// scene's order reads what is moved.
TEST(Hazards, AreWhereOneWritesWhatAnotherUses) {
  const BufferHandles buffers{};
  const auto second_overlaps = [&](const Launch& first, const Launch& second) {
    Hazards hazards;
    EXPECT_FALSE(hazards.overlaps(first, buffers)) << "what was before is not known";
    return hazards.overlaps(second, buffers);
  };
  const Launch by_cells = in_order(Kernel::collide_grid, Order::cells);
  const Launch by_scene = in_order(Kernel::collide_grid, Order::scene);
  EXPECT_TRUE(second_overlaps(by_cells, split_tiles()));
  EXPECT_TRUE(second_overlaps(by_scene, split_tiles())) << "both read";
  EXPECT_TRUE(second_overlaps(by_cells, move(results)));
  EXPECT_FALSE(second_overlaps(by_cells, move(slots::none))) << "both write totals";
  EXPECT_FALSE(second_overlaps(by_scene, move(results))) << "the second writes what the first reads";
  EXPECT_FALSE(second_overlaps(move(results), by_scene)) << "the first writes what the second reads";
  EXPECT_FALSE(second_overlaps(split_tiles(), in_order(Kernel::grid_sort, Order::buckets)));
  EXPECT_FALSE(second_overlaps(move(results), move(results)));
}

// Spheres may be drawn while the last image's pixels are shown, where they use nothing else of it: not where they are
// counted, or large ones listed.
TEST(Hazards, OfImagesByTurnsAreWhatTheyCount) {
  const BufferHandles buffers{};
  View view{};
  view.colour_by = COLOUR_BY_CLASS;
  Launch shown = {.kernel = Kernel::draw_resolve, .block = PIXELS_BLOCK, .view = &view};
  Launch drawn = {
      .kernel = Kernel::draw_spheres, .block = SERVICE_BLOCK, .view = &view, .visible_slot = SLOT_VISIBLE_ODD};
  const auto overlap = [&] {
    Hazards hazards;
    hazards.overlaps(shown, buffers);
    return hazards.overlaps(drawn, buffers);
  };
  EXPECT_FALSE(overlap()) << "both use the counts";
  drawn.unused = slots::drawn | slots::seen_left | slots::count;
  EXPECT_TRUE(overlap());
  drawn.visible_slot = SLOT_VISIBLE;
  EXPECT_FALSE(overlap()) << "the same pixels";
}

TEST(Hazards, AreOfAllLaunchesSinceTheLastWait) {
  const BufferHandles buffers{}, others{};
  const Launch search = in_order(Kernel::collide_grid, Order::cells);
  Hazards hazards;
  hazards.overlaps(search, buffers);
  EXPECT_TRUE(hazards.overlaps(split_tiles(), buffers));
  EXPECT_FALSE(hazards.overlaps(move(results), buffers)) << "split_tiles reads what is moved, the search does not";
  EXPECT_FALSE(hazards.overlaps(search, buffers, true)) << "it must wait";
  EXPECT_TRUE(hazards.overlaps(move(results), buffers)) << "what waited is the first of those that run";
  Launch empty = {.kernel = Kernel::empty, .block = SERVICE_BLOCK};
  EXPECT_TRUE(hazards.overlaps(empty, buffers));
  EXPECT_FALSE(hazards.overlaps(empty, others)) << "nothing is known of other buffers";
  empty.depends = true;
  EXPECT_FALSE(hazards.overlaps(empty, others));
  hazards.forget();
  EXPECT_FALSE(hazards.overlaps(split_tiles(), others));
}

}  // namespace
}  // namespace spherepair
