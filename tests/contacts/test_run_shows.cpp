// SPDX-License-Identifier: MIT
// How long a run moves, what it writes and prints on the way, and the colours of its film.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "bench/run/run_times.h"
#include "tests/contacts/run_program.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

using RunShows = RunProgram;

TEST_F(RunShows, UpToAStepOrATime) {
  const std::string json = " --json " + path("a.json");
  good(bed + " --dt 4e-4 --time 0.1" + json);
  EXPECT_EQ(end("a.json").at("step"), 250);
  EXPECT_NEAR(end("a.json").at("seconds").get<double>(), 0.1, 1e-8);
  good(bed + " --dt 4e-4 --time 0.0999 --save " + path("ck") + json);
  EXPECT_EQ(end("a.json").at("step"), 250);
  good("run --backend cpu --until-step 300 --resume " + path("ck") + json);
  EXPECT_EQ(end("a.json").at("step"), 300);
  refused("run --until-step 200 --resume " + path("ck"), "is at step 250 already");
  refused(bed + " --time 1e20", "--time");
  refused(bed + " --time 1 --steps 3", "does not go with");
}

TEST_F(RunShows, UntilAllIsAtRest) {
  const std::string few =
      "run --backend cpu --scene bed --n 20 --contact spring --restitution 0.3 --stiffness 1e6 --drag 30";
  const std::string save = fmt::format(" --save {} --json {}", path("ck"), path("a.json"));
  const Outcome outcome = good(few + " --until-rest" + save);
  EXPECT_NE(outcome.output.find("at rest to the bit"), std::string::npos) << outcome.output;
  const uint64_t steps = end("a.json").at("step");
  EXPECT_TRUE(end("a.json").at("at_rest"));
  EXPECT_EQ(steps % 1000, 1);
  const std::string rest = state("a.json");
  good("run --backend cpu --steps 777 --resume " + path("ck") + " --json " + path("b.json"));
  EXPECT_EQ(state("b.json"), rest);
  good(fmt::format("{} --steps {}{}", few, steps - 1001, save));
  EXPECT_FALSE(end("a.json").at("at_rest"));
  good(fmt::format("{} --until-rest --steps {}{}", few, 50, save));
  EXPECT_EQ(end("a.json").at("step"), 50);
  EXPECT_FALSE(end("a.json").at("at_rest"));
  refused("run --scene bed --n 20 --contact spring --until-rest", "--drag");
}

// Frames are the states of runs that end there, each with its step, its time and the box.
TEST_F(RunShows, WithATrajectory) {
  good(fmt::format("{} --steps 50 --trajectory {} --trajectory-every 20", bed, path("t.extxyz")));
  const uint64_t steps[] = {0, 20, 40, 50};
  for (uint64_t frame = 0; frame < 4; ++frame) {
    good(fmt::format("{} --steps {} --save {} --spheres {}", bed, steps[frame], path("ck"), path("end.npy")));
    const SphereFile read = read_sphere_file(path("t.extxyz"), {.frame = frame}),
                     wanted = read_sphere_file(path("end.npy"), {});
    EXPECT_EQ(state_hash(read.scene.positions, read.scene.velocities),
              state_hash(wanted.scene.positions, wanted.scene.velocities));
    EXPECT_EQ(read.frames, 4);
    EXPECT_TRUE(read.box);
  }
  const std::string text = read_bytes(path("t.extxyz"));
  EXPECT_NE(text.find(" step=20 time=0.0"), std::string::npos) << text.substr(0, 300);
  refused(fmt::format("run --resume {} --steps 5 --trajectory {}", path("ck"), path("t.extxyz")), "another file");
  EXPECT_EQ(read_bytes(path("t.extxyz")), text);
  refused(bed + " --steps 5 --trajectory " + path("t.npy"), ".extxyz");
}

// Equal intervals from 0 to all but the fastest 2 % of all images.
TEST_F(RunShows, AsAFilmWhoseColoursFitAllImages) {
  const std::string scene = "--backend cpu --scene bed --n 60 --contact spring --restitution 0.5 --stiffness 1e6 ";
  std::vector<double> speeds;
  for (uint64_t k = 0; k < 5; ++k) {
    good(fmt::format("run {} --steps {} --save {} --spheres {}", scene, 300 * k, path("ck"), path("end.npy")));
    for (const vec4& v : read_sphere_file(path("end.npy"), {}).scene.velocities)
      speeds.push_back(std::hypot(double(v.x), double(v.y), double(v.z)));
  }
  std::ranges::sort(speeds);
  const double last = speeds[speeds.size() * 98 / 100];
  const std::string film =
      fmt::format("render {} --color speed --size 160x120 --samples 1 --output {} ", scene, path("f.png"));
  good(film + "--images 5 --every 300");
  for (const char* image : {"f-0.json", "f-4.json"}) {
    const nlohmann::json keys = read_json(image).at("colours").at("keys");
    ASSERT_EQ(keys.size(), 8u) << keys;
    EXPECT_EQ(keys.front()[1], fmt::format("0–{:.3g}", last / 8));
    EXPECT_EQ(keys.back()[1], fmt::format("{:.3g}+", last * 7 / 8));
  }
  good(film + "--steps 900 --color-range 2,6");
  const nlohmann::json keys = read_json("f.json").at("colours").at("keys");
  EXPECT_EQ(keys.front()[1], "under 2.5");
  EXPECT_EQ(keys.back()[1], "5.5+");
  refused(film + "--steps 900 --color-range 6,2", "must ascend");
  refused(film + "--steps 900 --color contacts --color-range 2,6", "--color");
  refused(fmt::format("render {} --steps 3 --color contacts --color-range 2,6 --output {}", scene, path("f.png")),
          "is of radius and speed");
}

TEST(RunShowsTimes, OfEachKindOfWorkAndTheSumOfAKernelsLaunches) {
  RunTimes times;
  times.spend(RunTimes::moves, [] { std::this_thread::sleep_for(std::chrono::milliseconds(30)); });
  times.set_stages(*open_backends().front(), {{"sort", 0.25}, {"search", 1}, {"sort", 0.5}});
  const nlohmann::json record = times.to_json();
  EXPECT_GE(record.at("moves_s").get<double>(), 0.03);
  EXPECT_EQ(record.at("searches_s"), 0);
  EXPECT_EQ(record.at("last_step_ms").at("sort"), 750);
  EXPECT_EQ(record.at("last_step_ms").at("search"), 1000);
}

TEST_F(RunShows, SayingWhatIsAskedFor) {
  const std::string hash = "hash of the state";
  EXPECT_EQ(good(bed + " --steps 5 --quiet").output, "");
  const std::string plain = good(bed + " --steps 5").output, hashes = good(bed + " --steps 5 --hashes").output,
                    verbose = good(bed + " --steps 5 --verbose").output;
  EXPECT_EQ(plain.find(hash), std::string::npos) << plain;
  EXPECT_NE(plain.find("greatest overlap"), std::string::npos) << plain;
  EXPECT_NE(hashes.find(hash), std::string::npos) << hashes;
  EXPECT_NE(verbose.find("the last step on"), std::string::npos) << verbose;
}

}  // namespace
}  // namespace spherepair
