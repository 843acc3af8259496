// SPDX-License-Identifier: MIT
// What a run wrote it reads: runs with contacts, cut at random steps by checkpoints and resumed on other backends, end
// with the bits, the statistics and the messages of the uncut run.
#include <fmt/format.h>
#include <rapidcheck.h>

#include "tests/contacts/cut_runs.h"
#include "tests/support/backends.h"
#include "tests/support/motion_runs.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

constexpr uint64_t cuts_a_run = 4;

uint64_t any_number(uint64_t low, uint64_t high) {  // both included, whatever the size of RapidCheck's cases
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<uint64_t>(low, high + 1));
}
bool any_flag() { return any_number(0, 1) == 1; }
double any_power(int low, int high) { return std::exp2(double(any_number(0, uint64_t(high - low) * 8)) / 8 + low); }

DrawnRun any_run() {
  DrawnRun run;
  run.seed = any_number(0, 1'000'000);
  run.n = any_number(0, 7) ? any_number(2, 10) : any_number(20, 40);
  run.steps = any_number(1, 150);
  run.law = ContactLaw(any_number(1, 3));
  run.ratio = any_flag() ? 1 : any_power(0, 8);
  if (run.law == ContactLaw::spring && any_flag()) run.restitution = double(any_number(15, 100)) / 100;
  if (any_flag()) run.drag_a_step = any_flag() ? 0.45 : any_power(-16, -2);
  if (any_flag()) run.softness = any_power(0, 14);
  run.steps_a_contact = double(any_number(3, 60));
  if (any_flag()) run.gravity = any_flag() ? -9.81f : -1000.0f;
  if (!any_number(0, 4)) run.fall = any_power(-8, -4), run.n = any_number(2, 4), run.law = ContactLaw::spring;
  if (!any_number(0, 7)) run.squeezed = true, run.ratio = any_power(2, 6), run.softness = any_power(8, 12);
  run.walls = any_flag(), run.sleeping = any_number(0, 3) != 0;
  return run;
}

// Up to three, in ascending order, ahead of the step that fails.
std::vector<uint64_t> any_cuts(const DrawnRun& run, const RunEnd& whole) {
  const uint64_t last = whole.failed_step ? whole.failed_step - 1 : run.steps;
  std::vector<uint64_t> cuts(any_number(0, 3) ? 1 : any_number(2, 3));
  for (uint64_t& cut : cuts) cut = any_number(0, last);
  std::ranges::sort(cuts);
  return cuts;
}

struct Tried {
  uint64_t runs = 0, cuts = 0, failed = 0, with_contacts = 0;
};

// Runs on the first of the backends uncut, then cut so often; each part behind a cut takes one of the backends.
void expect_cuts_without_effect(std::span<Backend* const> backends, uint64_t times, const FastFolder& folder,
                                Tried& tried) {
  const DrawnRun run = any_run();
  const std::optional<Scene> scene = scene_of(run);
  if (!scene) return;
  const RunEnd whole = run_with_cuts(*scene, run.steps, {}, backends, folder);
  ++tried.runs, tried.failed += !whole.failure.empty(), tried.with_contacts += has_contacts(whole);
  for (uint64_t time = 0; time < times; ++time) {
    const std::vector<uint64_t> cuts = any_cuts(run, whole);
    std::vector<Backend*> parts;
    for (uint64_t part = 0; part <= cuts.size(); ++part) parts.push_back(backends[any_number(0, backends.size() - 1)]);
    const std::string difference = difference_of_ends(run_with_cuts(*scene, run.steps, cuts, parts, folder), whole);
    if (!difference.empty())
      RC_FAIL(fmt::format("{}, cut at {}: {}", describe(run), fmt::join(cuts, ", "), difference));
    tried.cuts += cuts.size();
  }
}

class CutRuns : public BackendTest {};

// In software a step takes a millisecond.
TEST_P(CutRuns, EndAsUncutOnesOfTheCpu) {
  if (backend().info().on_host) GTEST_SKIP() << "the CPU's have a test of their own";
  const FastFolder folder;
  const uint64_t wanted = is_gpu(backend()) ? 500 : 40;
  Backend* backends[] = {&cpu_backend(), &backend()};
  Tried tried;
  while (tried.cuts < wanted)
    ASSERT_TRUE(rc::check("a cut changes nothing", [&] {
      if (tried.cuts < wanted) expect_cuts_without_effect(backends, 2, folder, tried);
    }));
  EXPECT_GT(tried.with_contacts, tried.runs / 2);
}

class CutRunsOfTheCpu : public testing::Test {
 protected:
  CutRunsOfTheCpu() {
    for (const int threads : {1, 2, 7}) opened_.push_back(open_backend("cpu", {.threads = threads}));
    for (const auto& backend : opened_) backends_.push_back(backend.get());
  }
  std::vector<std::unique_ptr<Backend>> opened_;
  std::vector<Backend*> backends_;
  const FastFolder folder_;
};

TEST_F(CutRunsOfTheCpu, EndAsUncutOnes) {
  Tried tried;
  while (tried.cuts < 1000)
    ASSERT_TRUE(rc::check("a cut changes nothing", [&] {
      if (tried.cuts < 1000) expect_cuts_without_effect(backends_, cuts_a_run, folder_, tried);
    }));
  EXPECT_GT(tried.failed, tried.runs / 20);
  EXPECT_GT(tried.with_contacts, tried.runs / 2);
}

// So many spheres that several threads share them.
TEST_F(CutRunsOfTheCpu, EndAsUncutOnesOfOtherThreads) {
  Scene scene = gas({.side = 17, .ratio = 2, .gravity = -9.81f, .restitution = 0.6f, .law = ContactLaw::spring});
  const RunEnd whole = run_with_cuts(scene, 40, {}, backends_, folder_);
  EXPECT_TRUE(has_contacts(whole));
  const uint64_t cuts[] = {0, 9, 24, 39};
  EXPECT_EQ(difference_of_ends(run_with_cuts(scene, 40, cuts, backends_, folder_), whole), "");
}

INSTANTIATE_BACKENDS(CutRuns);

}  // namespace
}  // namespace spherepair
