// SPDX-License-Identifier: MIT
// Runs that begin where others ended: from a file with its box, from a checkpoint with other parameters, with files
// that go on; and how long a run moves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tests/contacts/run_program.h"

namespace spherepair {
namespace {

using RunGoesOn = RunProgram;

float lowest(const std::vector<vec4>& spheres) {
  float y = INFINITY;
  for (const vec4& s : spheres) y = std::min(y, s.y);
  return y;
}

TEST_F(RunGoesOn, InTheBoxOfTheFile) {
  good(fmt::format("{} --steps 3000 --spheres {}", bed, path("a.extxyz")));
  const std::string rest = "--contact spring --stiffness 1e6 --restitution 0.4 --drag 2 --steps 2500 --spheres ";
  good(fmt::format("run --backend cpu --input {} --walls {} {}", path("a.extxyz"), rest, path("b.npy")));
  EXPECT_NEAR(lowest(positions("b.npy")), lowest(positions("a.extxyz")), 0.01);
}

TEST_F(RunGoesOn, InABoxOfItsOwn) {
  good(fmt::format("{} --steps 1500 --spheres {} --json {}", bed, path("a.extxyz"), path("a.json")));
  good(
      fmt::format("run --backend cpu --input {} --columns _,x,y,z,radius,vx,vy,vz --contact spring --stiffness 1e6 "
                  "--walls --steps 500 --json {}",
                  path("a.extxyz"), path("walls.json")));
  const SphereFile file = read_sphere_file(path("a.extxyz"), {});
  ASSERT_TRUE(file.box);
  good(fmt::format("run --backend cpu --input {} --contact spring --stiffness 1e6 --box {},{} --steps 500 --json {}",
                   path("a.extxyz"), fmt::join(file.box->low, ","), fmt::join(file.box->high, ","), path("box.json")));
  EXPECT_EQ(state("walls.json"), state("box.json"));
  EXPECT_EQ(read_json("box.json").at("plane"), read_json("a.json").at("plane"));
  const std::string input = fmt::format("run --input {} --contact spring --steps 3 ", path("a.extxyz"));
  good(input + fmt::format("--backend cpu --box -1.5,-2.25,-3.1,19.7,20,21 --spheres {}", path("b.extxyz")));
  const auto box = read_sphere_file(path("b.extxyz"), {}).box;
  ASSERT_TRUE(box);
  EXPECT_EQ(box->low, (std::array{-1.5f, -2.25f, -3.1f}));
  EXPECT_EQ(box->high, (std::array{19.7f, 20.0f, 21.0f}));
  refused(input + "--box 0,0,0,1,1,1", "outside of the box");
  refused(input + "--box 9,0,0,1,9,9", "give the lower corner first");
  refused(input + "--walls --plane -3", "omit --plane, or --walls");
  refused(input + "--box 0,0,0,1,1", "--box");
  refused("run --n 20 --steps 3 --box 0,0,0,1,1,1", "--contact");
}

TEST_F(RunGoesOn, OnAPlaneThatIsGiven) {
  folder_.write("s.txt", "0 10 0 0.5\n3 2 0 1\n");
  const std::string input =
      fmt::format("run --backend cpu --input {} --steps 64 --json {} ", path("s.txt"), path("s.json"));
  good(input + "--plane 1");
  EXPECT_EQ(read_json("s.json").at("plane"), 1);
  refused(input + "--plane 1.5", "give --plane 1 or less");
  const Outcome outcome = run(input + "--plane 1.5");
  const std::string advice = outcome.errors.substr(outcome.errors.find("--plane "), 9);
  good(input + advice);
  refused("run --n 20 --steps 3 --plane 0", "--input");
}

// A free fall of one second.
TEST_F(RunGoesOn, WithAnotherGravity) {
  folder_.write("s.txt", "0 10 0 0.5\n");
  for (const double gravity : {0.0, 1.62, 24.79}) {
    good(fmt::format("run --backend cpu --input {} --plane -30 --steps 64 --gravity {} --spheres {}", path("s.txt"),
                     gravity, path("end.npy")));
    EXPECT_NEAR(positions("end.npy")[0].y, 10 - gravity / 2, 1e-5) << gravity;
  }
  refused("run --n 20 --steps 3 --gravity -9.81", "--gravity");
}

// Spheres of another density and as much stiffer contacts move alike; their energies and forces are in proportion.
TEST_F(RunGoesOn, WithAnotherDensity) {
  const std::string gas =
      "run --backend cpu --scene bed --n 40 --contact spring --restitution 0.5 --drag 1 --steps 400 ";
  good(gas + fmt::format("--stiffness 1e6 --statistics {} --json {}", path("a.csv"), path("a.json")));
  good(gas + fmt::format("--stiffness 4e6 --density 4000 --statistics {} --json {} --save {}", path("b.csv"),
                         path("b.json"), path("ck")));
  EXPECT_EQ(state("a.json"), state("b.json"));
  EXPECT_EQ(read_json("b.json").at("contacts").at("stiffness"), 4e6);
  std::istringstream water(read_bytes(path("a.csv"))), heavy(read_bytes(path("b.csv")));
  std::string one, other;
  size_t rows = 0;
  for (std::getline(water, one), std::getline(heavy, other); std::getline(water, one) && std::getline(heavy, other);
       ++rows) {
    std::istringstream left(one), right(other);
    std::string a, b;
    for (int column = 0; std::getline(left, a, ',') && std::getline(right, b, ','); ++column) {
      const bool scales = (column >= 2 && column <= 7) || column >= 11;
      EXPECT_DOUBLE_EQ(std::stod(b), (scales ? 4 : 1) * std::stod(a)) << "column " << column << "\n" << one;
    }
  }
  EXPECT_EQ(rows, 401);
  good(fmt::format("run --backend cpu --resume {} --restitution 0.6 --steps 3 --json {}", path("ck"), path("c.json")));
  EXPECT_EQ(read_json("c.json").at("contacts").at("density"), 4000);
  EXPECT_EQ(read_json("c.json").at("contacts").at("stiffness"), 4e6);
  refused("run --n 30 --steps 3 --density 2000", "--contact");
}

// A checkpoint that is resumed with other parameters goes on as its spheres do from a file with all of these
// parameters.
TEST_F(RunGoesOn, FromACheckpointWithOtherParameters) {
  good(fmt::format("{} --dt 5e-4 --steps 800 --save {} --spheres {}", bed, path("ck"), path("a.extxyz")));
  struct {
    const char *changed, *all;
  } const cases[] = {
      {"--restitution 0.7", "--restitution 0.7 --stiffness 1e6 --drag 2 --dt 5e-4"},
      {"--gravity 3", "--restitution 0.4 --stiffness 1e6 --gravity 3 --drag 2 --dt 5e-4"},
      {"--drag 0.5", "--restitution 0.4 --stiffness 1e6 --drag 0.5 --dt 5e-4"},
      {"--drag 0 --dt 2e-4", "--restitution 0.4 --stiffness 1e6 --dt 2e-4"},
      {"--stiffness 2e6 --gravity 3", "--restitution 0.4 --stiffness 2e6 --gravity 3 --drag 2 --dt 5e-4"}};
  for (const auto& [changed, all] : cases) {
    const Outcome outcome = good(fmt::format("run --backend cpu --resume {} {} --steps 300 --json {}", path("ck"),
                                             changed, path("resumed.json")));
    EXPECT_NE(outcome.output.find("A new run"), std::string::npos) << outcome.output;
    good(fmt::format("run --backend cpu --input {} --contact spring --walls {} --steps 300 --json {}", path("a.extxyz"),
                     all, path("file.json")));
    EXPECT_EQ(state("resumed.json"), state("file.json")) << changed;
    EXPECT_EQ(end("resumed.json").at("step"), 300);
  }
  refused(fmt::format("run --resume {} --stiffness 1e12 --steps 3", path("ck")), "--dt");
  refused(fmt::format("run --resume {} --walls --steps 3", path("ck")), "does not go with");
  good(fmt::format("run --backend cpu --n 50 --steps 20 --save {}", path("plain")));
  refused(fmt::format("run --resume {} --drag 1 --steps 3", path("plain")), "without contacts");
  good(fmt::format("run --backend cpu --resume {} --restitution 0.5 --steps 3", path("plain")));
}

TEST_F(RunGoesOn, WithItsFileOfStatistics) {
  const std::string rows = fmt::format(" --statistics-every 100 --statistics {} ", path("s.csv"));
  good(bed + " --steps 1000" + rows);
  const std::string whole = read_bytes(path("s.csv"));
  good(bed + " --steps 400 --save " + path("ck") + rows);
  const std::string resume = "run --backend cpu --resume " + path("ck");
  good(resume + " --until-step 1000" + rows);
  EXPECT_EQ(read_bytes(path("s.csv")), whole);
  good(resume + " --steps 600" + rows);  // the rows behind the checkpoint are computed again
  EXPECT_EQ(read_bytes(path("s.csv")), whole);
  refused(resume + " --steps 500" + rows, "has rows up to step 1000, and this run ends at step 900");
  refused(resume + " --steps 600 --drag 1" + rows, "of the run before");
  std::string other = whole;
  other[other.find("\n400,") + 9] ^= 1;
  for (const std::string& text : {whole.substr(0, whole.find("\n400,") + 1), std::string("step\n400,1\n"), other}) {
    folder_.write("s.csv", text);
    refused(resume + " --steps 600" + rows, "give --statistics another file");
    EXPECT_EQ(read_bytes(path("s.csv")), text);
  }
}

}  // namespace
}  // namespace spherepair
