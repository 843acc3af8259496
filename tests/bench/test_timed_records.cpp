// SPDX-License-Identifier: MIT
// What a record of samples says besides the times: the slow end, the working set, the host's cores, the timer's floor.
#include <gtest/gtest.h>
#include <omp.h>
#include <sched.h>
#include <unistd.h>

#include <cstdlib>

#include "bench/measure/floors.h"
#include "bench/measure/pinned_team.h"
#include "tests/support/clocked_backend.h"
#include "tests/support/sphere_files.h"

namespace spherepair {
namespace {

int cores_allowed() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  sched_getaffinity(0, sizeof(cores), &cores);
  return CPU_COUNT(&cores);
}

TEST(TimedRecords, TheSlowEndOfTheSamplesIsTold) {
  Samples samples;
  samples.plan.steps = {1};
  for (int k = 0; k <= 20; ++k) add_turn(samples, {.seconds = {1e-3 * k}}, uint64_t(k));
  fit_rounds(samples);
  EXPECT_NEAR(to_json(samples).at("p95_ms"), 19, 1e-9);
}

TEST(TimedRecords, AWorkingSetThatFitsTheCacheIsMarkedWhereItsSizeIsKnown) {
  ClockedSession on;
  on["cuda"].facts().details["L2 bytes"] = "1000";
  on["cuda"].facts().uuid = on["opengl"].facts().uuid = "same";
  std::vector<Contender> contenders = {on.contender("cpu"), on.contender("opengl"), on.contender("cuda"),
                                       on.contender("cuda")};
  contenders[0].working_set = contenders[1].working_set = 1000, contenders[2].working_set = 1001;
  const auto samples = on.measure(contenders);
  EXPECT_TRUE(to_json(samples[0]).at("fits_l2").is_null()) << "nobody tells the host's cache";
  EXPECT_EQ(to_json(samples[1]).at("fits_l2"), true) << "CUDA tells it of the same GPU";
  EXPECT_EQ(to_json(samples[1]).at("working_set_bytes"), 1000);
  EXPECT_EQ(to_json(samples[2]).at("fits_l2"), false);
  EXPECT_TRUE(to_json(samples[3]).at("fits_l2").is_null());
  on["opengl"].facts().uuid = "another";
  EXPECT_TRUE(to_json(on.measure({contenders[1]}).front()).at("fits_l2").is_null());
}

TEST(TimedRecords, WorkingSetsAreTheArraysThatAStepTouches) {
  EXPECT_EQ(motion_set_bytes(10, {MotionMethod::paper, Precision::float32}), 10u * (16 + 16 + 4));
  EXPECT_EQ(search_set_bytes(10, Method::collide_tiled, false), 10u * (16 + 4));
  EXPECT_EQ(search_set_bytes(10, Method::collide_grid, true), 10u * 27);
  EXPECT_EQ(search_set_bytes(10, Method::collide_grid, false), 10u * 67);
}

TEST(TimedRecords, TheCoresThatTheProcessKeepsBusyAreTold) {
  ClockedSession on;
  on["cpu"].busy = 2;
  const auto samples = on.measure({on.contender("cpu"), on.contender("opengl")});
  EXPECT_NEAR(to_json(samples[0]).at("busy_cores"), 2, 1e-9);
  EXPECT_FALSE(to_json(samples[1]).contains("busy_cores"));
}

// What this process itself keeps busy marks nothing, however many threads it has.
TEST(TimedRecords, OtherProgramsMarkTimesAndOurThreadsDoNot) {
  ClockedSession on;
  on["cpu"].busy = TestClock::machine_cores;
  const auto marks_of = [&] { return to_json(on.measure({on.contender("cpu")}).front()).value("unsteady", json()); };
  EXPECT_TRUE(marks_of().is_null());
  on["cpu"].busy = 1;
  on.clock.others = 0.5;
  EXPECT_TRUE(marks_of().is_null()) << "half of the cores";
  on.clock.others = 0.75;
  EXPECT_EQ(marks_of(), json::array({"other programs kept 75 % of this machine's cores busy"}));
  EXPECT_EQ(on.session.timings.all, 3u);
  EXPECT_EQ(on.session.timings.unsteady, 1u);
}

TEST(TimedRecords, TimesThatScatterAreMarkedInTables) {
  Samples samples;
  samples.plan.steps = {1};
  samples.seconds = {1e-3, 2e-3, 1e-3, 2e-3, 1e-3, 2e-3};
  EXPECT_TRUE(samples.unsteady().empty()) << "2x is not wider than 2x";
  Table table{"Times", {{"", "time", "ms"}}, {{time_cell(samples)}}, {}};
  EXPECT_EQ(table.text().find("decides nothing"), std::string::npos);
  samples.seconds.back() = 2.1e-3;
  EXPECT_EQ(samples.unsteady(), std::vector<std::string>{"its interval is wider than 2x"});
  table.rows = {{time_cell(samples)}};
  EXPECT_NE(table.text().find("1.500 [1.000, 2.100] !\n"), std::string::npos) << table.text();
  EXPECT_NE(table.text().find("such a time decides nothing"), std::string::npos) << table.text();
  EXPECT_EQ(table.to_json().at("notes").size(), 2u) << "of the interval and of the mark";
}

// Ticks of 0.01 s: user, nice, system, idle, iowait, irq, softirq, steal, guest.
TEST(TimedRecords, TheMachinesBusyTimeIsReadFromTheKernel) {
  const ScratchFolder folder;
  const auto read = [&](const std::string& text) { return machine_use(folder.write("stat", text).c_str()); };
  const auto found = read("cpu  100 20 30 9000 500 4 6 40 90\ncpu0 1 1\ncpu1 1 1\ncpu2 1 1\nintr 7\ncpu9 1\n");
  ASSERT_TRUE(found.has_value());
  EXPECT_DOUBLE_EQ(found->busy, 200.0 / double(sysconf(_SC_CLK_TCK)));
  EXPECT_EQ(found->cores, 3);
  EXPECT_FALSE(read("cpu  0 0 0 0 0 0 0 0\ncpu0 0 0\n").has_value()) << "a sandbox that tells nothing";
  EXPECT_FALSE(machine_use(folder.path("absent").c_str()).has_value());
}

// Threads that spin while they wait would show as busy cores next to the one that works.
TEST(TimedRecords, NothingElseSpinsWhileOneThreadIsTimed) {
  if (std::getenv("OMP_WAIT_POLICY") && std::string(std::getenv("OMP_WAIT_POLICY")) != "passive")
    GTEST_SKIP() << "OMP_WAIT_POLICY lets threads spin";
  Session session({"cpu"}, {}, open_backend);
  Backend& cpu = *session.find("cpu");
  cpu.upload(make_scene({.n = 4096}));
  std::vector<Contender> contenders;
  for (const Method method : {Method::parallel, Method::sequential})
    contenders.push_back({.label = method_name(method), .backend = &cpu, .step = [method](Backend& each) {
                            each.enqueue_collide({.method = method});
                          }});
  Sampling sampling;
  sampling.rounds = 3, sampling.software_seconds = 0.02;
  Progress progress;
  const auto samples = measure(session, contenders, sampling, progress);
  EXPECT_LT(to_json(samples[1]).at("busy_cores").get<double>(), 1.1);
}

TEST(TimedRecords, TheHostsThreadsAreEachOnACoreOfTheirOwn) {
  const int before = cores_allowed(), threads = std::min(before, omp_get_max_threads());
  if (std::getenv("OMP_PROC_BIND") || std::getenv("OMP_PLACES")) GTEST_SKIP() << "the environment places the threads";
  {
    const PinnedTeam team(threads);
    EXPECT_TRUE(team.pinned());
    int alone = 0;
#pragma omp parallel num_threads(threads) reduction(+ : alone)
    alone += cores_allowed() == 1;
    EXPECT_EQ(alone, threads);
  }
  int free = 0;
#pragma omp parallel num_threads(threads) reduction(+ : free)
  free += cores_allowed() == before;
  EXPECT_EQ(free, threads);
  EXPECT_FALSE(PinnedTeam(before + 1).pinned()) << "two threads would share a core";
  setenv("OMP_PROC_BIND", "spread", 1);
  EXPECT_FALSE(PinnedTeam(threads).pinned()) << "the environment places them";
  unsetenv("OMP_PROC_BIND");
}

TEST(TimedRecords, OnlyContendersOnTheHostArePinned) {
  if (std::getenv("OMP_PROC_BIND") || std::getenv("OMP_PLACES")) GTEST_SKIP() << "the environment places the threads";
  ClockedSession on;
  std::map<std::string, int> cores;
  std::vector<Contender> contenders;
  for (const std::string name : {"cpu", "opengl"}) {
    contenders.push_back(on.contender(name));
    contenders.back().step = [&cores, name](Backend& each) {
      cores[name] = cores_allowed();
      static_cast<ClockedBackend&>(each).run_step();
    };
  }
  const auto samples = on.measure(contenders);
  EXPECT_EQ(cores["cpu"], 1);
  EXPECT_EQ(cores["opengl"], cores_allowed());
  EXPECT_EQ(to_json(samples[0]).at("pinned"), true);
}

TEST(TimedRecords, StagesBelowTheReadingOfAnEmptyKernelAreMarked) {
  ClockedSession on;
  on["cuda"].facts().device_timers = true;
  Contender contender = on.contender("cuda");
  contender.step = [](Backend& each) {
    static_cast<ClockedBackend&>(each).run_step();
    static_cast<ClockedBackend&>(each).run_stages();
  };
  for (int time = 0; time < 2; ++time) {
    const json record = to_json(on.measure({contender}).front());
    EXPECT_NEAR(record.at("timer_floor_ms"), 5e-3, 1e-9);
    EXPECT_EQ(record.at("device_stages_at_floor"), json::array({"clear"}));
    EXPECT_TRUE(record.at("device_stages_ms").contains("clear")) << "marked, not left out";
  }
  EXPECT_EQ(on["cuda"].empty_launches, 100u) << "read once a session";
}

// From the state in which the samples begin, however many steps went before.
TEST(TimedRecords, AStageHasTheTimeOfAllItsLaunchesInAStep) {
  ClockedSession on;
  on["cuda"].facts().device_timers = true;
  on["cuda"].drift = 1e-6;
  Contender contender = on.contender("cuda");
  contender.batch = 3;
  contender.restart = [](Backend& each) { static_cast<ClockedBackend&>(each).steps = 0; };
  contender.step = [](Backend& each) {
    static_cast<ClockedBackend&>(each).run_step();
    static_cast<ClockedBackend&>(each).run_stages();
  };
  const json stages = to_json(on.measure({contender}).front()).at("device_stages_ms");
  EXPECT_NEAR(stages.at("clear"), 6e-3, 1e-9) << "steps 1 to 3 take 5, 6 and 7 us";
  EXPECT_NEAR(stages.at("collide_grid"), 2 * 52e-3, 1e-9);
}

}  // namespace
}  // namespace spherepair
