// SPDX-License-Identifier: MIT
// --too-fast divide: a run with divided steps has the bits of one that was given the smaller time step, at the
// times of the undivided ones; and a run that is refused leaves nothing behind.
#include <fmt/format.h>

#include <sstream>

#include "bench/image/image_files.h"
#include "bench/options/command.h"
#include "common/scene/contact/contact_faults.h"
#include "common/scene/contact_scene.h"
#include "tests/support/backends.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

// Small spheres that fall, by 0.2 m/s more in each step of 0.02 s; a step allows 0.05 m/s, and a 64th of it 3.2 m/s.
class TooFastOption : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    folder_.write("s.txt", "0 0 0 0.001\n0.004 0.002 0 0.001\n0 0.004 0.002 0.001\n");
  }
  std::string falling(const std::string& command, const std::string& rest) const {
    return fmt::format("{} --input {} --contact spring --stiffness 1.29e-4 {}", command, path("s.txt"), rest);
  }
  Outcome divided(const std::string& command, const std::string& rest) const {
    return run(falling(command, "--dt 0.02 --too-fast divide " + rest));
  }
};

TEST_F(TooFastOption, HasTheBitsOfTheSmallerStepOnEveryBackend) {
  ASSERT_EQ(run(falling("run", "--backend cpu --dt 0.00125 --steps 48 --json " + path("a.json"))).code, kOk);
  const nlohmann::json plain = read_json("a.json");
  for (const Backend* backend : open_backends()) {
    const std::string name = backend->info().name;
    const Outcome outcome = divided("run", fmt::format("--backend {} --steps 3 --json {}", name, path("b.json")));
    ASSERT_EQ(outcome.code, kOk) << outcome.errors;
    const nlohmann::json record = read_json("b.json");
    EXPECT_EQ(record["steps"][0]["state"], plain["steps"][0]["state"]) << name;
    EXPECT_EQ(record["steps"][0]["step"], 3);
    EXPECT_EQ(record["divided_into"], 16);
    EXPECT_EQ(record["times"]["moves"], 48);  // of the last attempt
    EXPECT_FLOAT_EQ(record["dt"].get<float>(), 0.02f);
    for (const char* line : {"divided into 2 of 0.01 s\n", "divided into 16 of 0.00125 s\n"})
      EXPECT_NE(
          outcome.errors.find(std::string("* sphere 0 is too fast: from the start again, with each step ") + line),
          std::string::npos)
          << name << ": " << outcome.errors;
    EXPECT_NE(outcome.output.find("each step is divided into 16\n"), std::string::npos) << outcome.output;
  }
}

TEST_F(TooFastOption, KeepsTheTimesOfRowsAndCheckpoints) {
  const std::string files = fmt::format("--statistics {} --save {} --save-every 2", path("s.csv"), path("c"));
  ASSERT_EQ(divided("run", "--backend cpu --steps 3 --per-step " + files).code, kOk);
  std::istringstream rows(read_bytes(path("s.csv")));
  std::string row;
  std::getline(rows, row);
  for (const char* wanted : {"0,0,", "1,0.0199999", "2,0.0399999", "3,0.0599999"}) {
    std::getline(rows, row);
    EXPECT_EQ(row.substr(0, std::string(wanted).size()), wanted);
  }
  EXPECT_FALSE(std::getline(rows, row)) << row;
  ASSERT_EQ(run(falling("run", "--backend cpu --dt 0.00125 --steps 48 --save " + path("d"))).code, kOk);
  EXPECT_EQ(read_bytes(path("c")), read_bytes(path("d")));
}

TEST_F(TooFastOption, DrawsTheImagesOfTheSmallerStep) {
  const std::string look = "--backend cpu --no-legend --samples 1 --size 64x48 --color speed --images 2 ";
  ASSERT_EQ(divided("render", look + "--steps 1 --output " + path("a.png")).code, kOk);
  ASSERT_EQ(run(falling("render", look + "--steps 8 --every 8 --dt 0.0025 --output " + path("b.png"))).code, kOk);
  for (const char* k : {"-0", "-1"})
    EXPECT_EQ(read_bytes(path(fmt::format("a{}.png", k))), read_bytes(path(fmt::format("b{}.png", k)))) << k;
  EXPECT_NE(read_bytes(path("a-0.png")), read_bytes(path("a-1.png")));
}

TEST_F(TooFastOption, RefusesBeyond64AndLeavesNothing) {
  const std::string files =
      fmt::format("--statistics {} --statistics-every 4 --save {} --save-every 4", path("s.csv"), path("c"));
  for (const Outcome& outcome :
       {divided("run", "--backend cpu --steps 20 " + files),
        divided("render", "--backend cpu --images 21 --size 64x48 --plain --samples 1 --output " + path("a.png"))}) {
    EXPECT_EQ(outcome.code, kUsage);
    EXPECT_NE(outcome.errors.find("each step is already divided into 64"), std::string::npos) << outcome.errors;
  }
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"s.txt"});
}

// A sphere falls onto one that lies on the plane faster than their contact can stop.
TEST_F(TooFastOption, DividesForDeepContactsOnTheWay) {
  folder_.write("s.txt", "0 -4.999 0 0.001\n0 -4.95 0 0.001\n");
  const Outcome outcome =
      run("run --backend cpu --contact spring --stiffness 1 --dt 0.002 --steps 60 --too-fast divide "
          "--input " +
          path("s.txt"));
  EXPECT_EQ(outcome.code, kUsage);
  for (const char* said :
       {"* sphere 1 is too fast: from the start again, with each step divided into 2 of 0.001 s",
        "* sphere 0 is too deep in another or a wall: from the start again, with each step divided into 64",
        "s: sphere 0 is deeper in sphere 1 than the smaller radius, ", "is already divided into 64"})
    EXPECT_NE(outcome.errors.find(said), std::string::npos) << said << ": " << outcome.errors;
}

TEST_F(TooFastOption, IsForFastSpheresAndDeepContacts) {
  Scene three = make_scene({.name = "gas", .n = 3});
  choose_contacts(three, {.law = ContactLaw::spring});
  const ContactParams params = contact_params(three);
  const auto kind = [&](const std::vector<uint>& faults) -> std::string {
    try {
      if (has_faults(faults)) throw_fault("cpu", {faults, 1, bodies_of(fixed_state(three), three.positions)}, params);
    } catch (const StepTooLong& fault) {
      return fmt::format("sphere {}{}{}", fault.sphere, fault.fast ? " fast" : "", fault.deep ? " deep" : "");
    } catch (const std::invalid_argument&) {
      return "other";
    }
    return "none";
  };
  EXPECT_EQ(kind({~0u, ~0u, ~0u}), "none");
  EXPECT_EQ(kind({2, ~0u, ~0u}), "sphere 2 deep");
  EXPECT_EQ(kind({~0u, ~0u, 2}), "other");
  EXPECT_EQ(kind({~0u, 1, 2}), "sphere 1 fast");
  EXPECT_EQ(kind({2, 1, ~0u}), "sphere 1 fast deep");
}

TEST_F(TooFastOption, PutsBackWhatItReplacedWhereNothingHelps) {
  folder_.write("old", "of an earlier run");
  std::filesystem::create_symlink("old", path("link"));
  std::filesystem::create_symlink("/dev/null", path("null"));
  const std::string end = "--backend cpu --steps 20 --save-every 4 ";
  EXPECT_EQ(divided("run", end + fmt::format("--save {} --statistics {}", path("link"), path("null"))).code, kUsage);
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"link", "null", "old", "s.txt"}));
  EXPECT_EQ(read_bytes(path("old")), "of an earlier run");
}

TEST_F(TooFastOption, WritesOnceWhereNothingCanBeTakenBack) {
  const auto times_in = [](const std::string& text, const std::string& word) {
    int times = 0;
    for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++times;
    return times;
  };
  const std::string words = "--backend cpu --steps 3 --save-every 1 --save ";
  EXPECT_EQ(times_in(divided("run", words + "/dev/stdout | cat").output, "SPHCHECK"), 1);
  const std::string rows = divided("run", words + path("c") + " --statistics /dev/stdout | cat").output;
  EXPECT_EQ(times_in(rows, "\n0,0,"), 1) << rows;
}

TEST_F(TooFastOption, PutsBackImagesToo) {
  folder_.write("a.png", "of an earlier run");
  std::filesystem::create_symlink("c", path("c.png"));  // to no file yet
  EarlierFiles earlier;
  for (int attempt = 0; attempt < 2; ++attempt) {
    ImageWriters writers(&earlier);
    for (const char* name : {"a.png", "b.png", "c.png"}) writers.write(path(name), {0, 0, 0, 0}, 2, {});
    writers.finish();
  }
  EXPECT_NE(read_bytes(path("a.png")), "of an earlier run");
  EXPECT_EQ(folder_.names(),
            (std::vector<std::string>{"a.json", "a.png", "b.json", "b.png", "c", "c.json", "c.png", "s.txt"}));
  earlier.take_back();
  EXPECT_EQ(read_bytes(path("a.png")), "of an earlier run");
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"a.png", "c.png", "s.txt"}));
}

// By steps above half a contact, and by impulses that could add up beyond 64 bits.
TEST_F(TooFastOption, DividesAStartThatIsRefused) {
  folder_.write("s.txt", "0 0 0 1\n4 2 0 2\n");
  for (const char* more : {"--dt 0.3", "--dt 0.06 --restitution 0.1"}) {
    const std::string words =
        fmt::format("run --input {} --contact spring --stiffness 129000 --backend cpu --steps 1 --json {} {}",
                    path("s.txt"), path("r.json"), more);
    const Outcome refused = run(words);
    EXPECT_EQ(refused.code, kUsage);
    EXPECT_NE(refused.errors.find("give --dt"), std::string::npos) << refused.errors;
    const Outcome outcome = run(words + " --too-fast divide");
    ASSERT_EQ(outcome.code, kOk) << outcome.errors;
    EXPECT_NE(outcome.errors.find("* the start needs smaller steps: each is divided into "), std::string::npos)
        << outcome.errors;
    EXPECT_FLOAT_EQ(read_json("r.json")["dt"].get<float>(), std::stof(std::string(more).substr(5)));
  }
  const Outcome shaped = run("run --scene gas --n 8 --steps 1 --contact quartic --restitution 0.5 --too-fast divide");
  EXPECT_EQ(shaped.code, kUsage);  // for a reason that no step mends
  EXPECT_EQ(shaped.errors.find("smaller steps"), std::string::npos) << shaped.errors;
}

TEST_F(TooFastOption, OtherwiseTheRunEnds) {
  const Outcome refused = run(falling("run", "--backend cpu --dt 0.02 --steps 3"));
  EXPECT_EQ(refused.code, kUsage);
  EXPECT_NE(refused.errors.find("sphere 0 moves by more than the smallest radius in a step"), std::string::npos);
  folder_.write("s.txt", "0 0 0 0.001\n0.0005 0 0 0.001\n");  // too deep, which no smaller step mends
  const Outcome deep = divided("run", "--backend cpu --steps 1");
  EXPECT_EQ(deep.code, kUsage);
  EXPECT_NE(deep.errors.find("sphere 0 is deeper in sphere 1"), std::string::npos) << deep.errors;
  EXPECT_EQ(deep.errors.find("divided"), std::string::npos) << deep.errors;  // though gravity makes them fast as well
  for (const char* rest : {"--n 8 --steps 1 --too-fast divide", "--n 8 --steps 1 --contact none --too-fast divide",
                           "--resume c --too-fast divide", "--n 8 --steps 1 --contact spring --too-fast devide"}) {
    const Outcome outcome = run(fmt::format("run --backend cpu {}", rest));
    EXPECT_EQ(outcome.code, kUsage) << rest;
    EXPECT_NE(outcome.errors.find("--too-fast"), std::string::npos) << outcome.errors;
  }
}

}  // namespace
}  // namespace spherepair
