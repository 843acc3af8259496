// SPDX-License-Identifier: MIT
// Command lines that cannot be taken: what is wrong with which word, and what to do.
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

class Complaints : public ProgramTest {
 protected:
  void expect(const std::string& arguments, const std::string& message) const {
    const Outcome outcome = run(arguments, "timeout 60");
    EXPECT_EQ(outcome.code, kUsage) << arguments;
    EXPECT_EQ(outcome.output, "") << arguments;
    EXPECT_EQ(outcome.errors, "spherepair: " + message + "\n") << arguments;
  }
};

TEST_F(Complaints, OptionsThatDoNotGoTogether) {
  expect("run --resume a --n 5", "--n does not go with --resume: omit one of the two");
  expect("view --n 5 --input a", "--n does not go with --input: omit one of the two");
  expect("render --frames --plain --ground none --input a --output a.png",
         "--plain does not go with --ground: omit one of the two");
  expect("run --naive --swept", "--naive does not go with --swept: omit one of the two");
  expect("render --eye 1,2,3 --azimuth 10 --output a.png", "--azimuth does not go with --eye: omit one of the two");
  expect("run --frame 2", "--frame has no effect without --input: give both, or omit it");
}

TEST_F(Complaints, WhatIsMissing) {
  expect("", "no subcommand was given: spherepair --help lists them; spherepair devices is a start");
  expect("pairs --output -", "pairs needs --input: spherepair pairs --help says what it is");
  expect("equal a.json", "equal needs right: spherepair equal --help says what it is");
  expect("run --n", "--n needs 1 value, but none was given");
  expect("render --eye 1,2 --output a.png", "--eye needs 3 values, but 2 were given");
  expect("run --n 5 --n 6", "--n needs 1 value, but 2 were given");
}

TEST_F(Complaints, WhatIsNoNumber) {
  expect("run --dt abc", "--dt: 'abc' is not made of numbers");
  expect("run --n many",
         "--n: 'many' is not a whole number from 0 to 2147483647, written like 16384, 16k, 1.5M or 1e6");
  expect("render --target 1,b,3 --output a.png", "--target: '1,b,3' is not made of numbers");
  expect("pairs --input a --columns x,y,q --output -",
         "--columns: unknown column 'q'; known are x, y, z, radius, vx, vy, vz, diameter, species, _; a column by its "
         "name "
         "in the file: x=NAME");
}

TEST_F(Complaints, AWordThatStandsTwiceInAList) {
  const std::string results = " --results " + path("r");
  for (const auto& [arguments, message] : {std::pair{"compare --backends cpu,cpu", "--backends has cpu"},
                                           {"devices --backends cpu --backends cpu", "--backends has cpu"},
                                           {"compare --methods parallel,sequential,parallel", "--methods has parallel"},
                                           {"compare --scenes random,aligned:8x16,random", "--scenes has random"},
                                           {"compare --tables methods,methods", "--tables has methods"},
                                           {"compare --blocks 64,64", "--blocks has 64"},
                                           {"compare --n 16k,16000", "--n has 16000"},
                                           {"frames --draws mesh,mesh", "--draws has mesh"},
                                           {"frames --most mesh:5,mesh:6", "--most has mesh"},
                                           {"frames --places inside,inside", "--places has inside"},
                                           {"ablate --names cells,cells", "--names has cells"},
                                           {"crossover --kinds gas,gas", "--kinds has gas"},
                                           {"sweep --orders cold,cold", "--orders has cold"},
                                           {"sweep --packing-fractions 0.3,0.30", "--packing-fractions has 0.30"},
                                           {"precision --motions paper,paper", "--motions has paper"},
                                           {"precision --steps 4,4", "--steps has 4"},
                                           {"sets --precisions float32,float32", "--precisions has float32"}}) {
    const bool folder = !std::string(arguments).starts_with("devices");
    expect(arguments + (folder ? results : ""), std::string(message) + " more than once: name it once");
    if (HasFailure()) return;  // what is not refused would run
  }
  EXPECT_FALSE(std::filesystem::exists(path("r")));
}

TEST_F(Complaints, ListsWhereWordsMayStandTwice) {
  const std::string file = folder_.write("a.txt", "7 0 0 0 8 1\n");
  EXPECT_EQ(run(fmt::format("pairs --backend cpu --input {} --columns _,x,y,z,_,radius --output -", file)).code, kOk);
  EXPECT_EQ(
      run("render --backend cpu --n 5 --size 64x48 --samples 1 --eye 9,9,9 --up 0,1,0 --output " + path("a.png")).code,
      kOk);
}

TEST_F(Complaints, ACheckpointThatIsNoneBeginsAtByte0) {
  const std::string text = folder_.write("a.txt", "0 1 0 0.5 and more of it\n");
  expect("run --resume " + text, text + ", byte 0: expected SPHCHECK, found '0 1 0 0.': no checkpoint");
}

TEST_F(Complaints, FilesThatPeopleHave) {
  const std::string commas = folder_.write("de.csv", "x;y;z;radius\n0,5;0;0;1\n");
  expect(
      "run --input " + commas,
      commas +
          ", line 2: expected a number for x in column 1, with a decimal point (or give --decimal-comma), found '0,5'");
  const std::string packed = folder_.write("a.xyz.gz", "\x1f\x8b\x08");
  expect("run --input " + packed, packed + " is a gzip file: unpack or convert it to XYZ, NPY or text");
  const std::string text = folder_.write("a.txt", "some words\n");
  expect("run --input " + text,
         text +
             ", line 1, read as names of columns: the columns x, y and z must be among 'some words'; name them with "
             "--columns x=NAME,y=NAME,z=NAME");
  const std::string atoms = folder_.write("atoms.txt", "C 1.3 8.4 7.6\n");
  expect("run --input " + atoms,
         atoms +
             ", line 1: expected numbers, or names of columns with x, y and z; others need --columns, such as "
             "--columns _,x,y,z, found 'C 1.3 8.4 7.6'");
  for (const char* line : {"0,0 0,0 0,0 1,0", "1,3 8,4 7,6"}) {
    const std::string decimal_commas = folder_.write("commas.txt", std::string(line) + "\n");
    expect("run --input " + decimal_commas,
           fmt::format("{}, line 1: expected columns separated by blanks, commas or semicolons alone, and decimal "
                       "points (or give --decimal-comma), found '{}'",
                       decimal_commas, line));
  }
  expect(fmt::format("equal {0} {0}", text),
         text + " is not the results.json of a compare run: no JSON from byte 1 on");
}

TEST_F(Complaints, GroupsThatAreNotAllSpheres) {
  expect("run --backend cpu --scene aligned --groups 3 --group-size 5",
         "3 groups of 5 make 15 spheres, but n is 16384: give --n 15");
}

TEST_F(Complaints, AFieldOfViewThatNoCameraHas) {
  const std::string render = "render --backend cpu --n 9 --output " + path("a.png") + " --field ";
  for (const char* wrong : {"0", "-1", "180"})
    expect(render + wrong, fmt::format("--field {}: the field of view must be above 0 and below 180 degrees", wrong));
}

TEST_F(Complaints, AViewWithoutSpheres) {
  expect("view --n 0", "random has no spheres, so the window would be blank: give --n, or a file with spheres");
}

}  // namespace
}  // namespace spherepair
