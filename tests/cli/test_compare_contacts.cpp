// SPDX-License-Identifier: MIT
// compare --contact compares runs with the contacts that were asked for, and its record names them.
#include <fmt/format.h>

#include "tests/support/backends.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

class CompareContacts : public ProgramTest {
 protected:
  Outcome compared(const std::string& contact, const std::string& to, const std::string& scene = "gas") const {
    return run(
        fmt::format("compare --scenes {} --n 300 --steps 24 --every 8 --blocks 64 --methods parallel,collide_grid "
                    "--tables none {} --results '{}'",
                    scene, contact, path(to)));
  }
  Outcome compared_on_cpu(const std::string& contact, const std::string& to, const std::string& scene = "gas") const {
    return compared("--backends cpu --contact " + contact, to, scene);
  }
  Outcome equal(const std::string& a, const std::string& b) const {
    return run(fmt::format("equal '{0}/results.json' '{1}/results.json'", path(a), path(b)));
  }
};

TEST_F(CompareContacts, ComparesTheRunThatWasAskedFor) {
  for (const char* contact : {"--contact spring --restitution 0.7", "--contact quartic --stiffness 1e9",
                              "--contact hertz --drag 0.5", "--contact spring --periodic xz"}) {
    ASSERT_EQ(compared(contact, "r").code, 0) << contact;
    const nlohmann::json entry = read_json("r/results.json")["equality"][0];
    ASSERT_EQ(
        run(fmt::format("run --backend cpu --scene gas --n 300 --steps 24 {} --json {}", contact, path("s.json"))).code,
        0);
    const nlohmann::json plain = read_json("s.json");
    EXPECT_EQ(entry["checkpoints"].back()["state"], plain["steps"][0]["state"]) << contact;
    EXPECT_EQ(entry["checkpoints"].size(), 4u);
    EXPECT_EQ(entry["scene"]["contact"], plain["contacts"]);
    for (const char* same : {"dt", "restitution"}) EXPECT_EQ(entry["scene"][same], plain[same]) << contact;
    EXPECT_GE(entry["configurations"].size(), open_backends().size());
  }
}

// Runs with different contacts are not comparable: `equal` reports nothing in common, not a difference.
TEST_F(CompareContacts, RecordsOfOtherContactsAreOthers) {
  ASSERT_EQ(compared_on_cpu("spring", "a").code, 0);
  ASSERT_EQ(compared_on_cpu("spring", "same").code, 0);
  EXPECT_EQ(equal("a", "same").code, 0);
  for (const char* other : {"hertz", "spring --stiffness 1e6", "spring --dt 1e-5", "spring --restitution 0.5",
                            "spring --drag 0.1", "spring --periodic xyz"}) {
    ASSERT_EQ(compared_on_cpu(other, "b").code, 0) << other;
    const Outcome outcome = equal("a", "b");
    EXPECT_EQ(outcome.code, 2) << other << outcome.output;
    EXPECT_EQ(outcome.output.find("DIFFERENT"), std::string::npos) << outcome.output;
  }
}

// Also where everything else that a record holds is the same.
TEST_F(CompareContacts, RecordsThatDifferInOneNumberAreOthers) {
  for (const auto& [scene, one, other] :
       {std::tuple("gas", "--drag 0.1", "--drag 0.2"),
        {"gas", "--stiffness 1e6 --dt 1e-5", "--stiffness 2e6 --dt 1e-5"},
        {"newton", "--stiffness 1e6 --dt 1e-5", "--stiffness 1e6 --dt 1e-5 --walls"}}) {
    ASSERT_EQ(compared_on_cpu(fmt::format("spring {}", one), "a", scene).code, 0) << one;
    ASSERT_EQ(compared_on_cpu(fmt::format("spring {}", other), "b", scene).code, 0) << other;
    EXPECT_EQ(equal("a", "b").code, 2) << one << " " << other;
  }
}

}  // namespace
}  // namespace spherepair
