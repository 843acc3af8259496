// SPDX-License-Identifier: MIT
// Checkpoints on disk (row 30 of the stress catalogue): the same bits after a pause, and a damaged or truncated file
// refused by the name of what is wrong with it.
#include "common/files/checkpoint.h"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "common/scene/contact_scene.h"
#include "tests/support/catalogue.h"
#include "tests/support/motion_runs.h"
#include "tests/support/sphere_files.h"

namespace spherepair {
namespace {

Checkpoint sample(MotionOptions motion, uint64_t n = 3) {
  const Scene scene = bouncing_scene({.motion = motion, .dt = 0.125f, .restitution = 0.5f, .n = n});
  const Motion::State state = run_steps(cpu_backend(), scene, 20);
  Checkpoint checkpoint{scene, cpu_backend().save(), 20};
  checkpoint.scene.positions = state.positions;
  checkpoint.scene.velocities = state.velocities;
  return checkpoint;
}

constexpr MotionOptions largest_state = {MotionMethod::anchored, Precision::compensated};

TEST(Checkpoint, HoldsEverything) {
  const ScratchFolder folder;
  for (const MotionOptions& motion : all_motions())
    for (uint64_t n : {0, 1, 50}) {
      const Checkpoint written = sample(motion, n);
      write_checkpoint(folder.path("run.checkpoint"), written);
      const Checkpoint read = read_checkpoint(folder.path("run.checkpoint"));
      EXPECT_EQ(read.step, 20u);
      EXPECT_EQ(read.scene.name, written.scene.name);
      EXPECT_EQ(read.scene.motion, motion);
      EXPECT_EQ(read.scene.dt, 0.125f);
      EXPECT_EQ(read.scene.restitution, 0.5f);
      EXPECT_EQ(read.scene.gravity, written.scene.gravity);
      EXPECT_EQ(read.scene.plane, written.scene.plane);
      EXPECT_EQ(read.motion.steps, written.motion.steps);
      EXPECT_EQ(read.motion.flights, written.motion.flights);
      EXPECT_EQ(read.motion.since, written.motion.since);
      EXPECT_EQ(read.motion.next_event, written.motion.next_event);
      const Motion::State a = {read.scene.positions, read.scene.velocities, read.motion.wide};
      expect_equal_states(a, {written.scene.positions, written.scene.velocities, written.motion.wide},
                          motion_label(motion));
    }
}

Checkpoint sample_with_contacts(uint64_t steps = 20, float drag = 0.25f) {
  Scene scene = make_scene({.name = "bed", .n = 27, .radius_ratio = 3, .restitution = 0.5f});
  choose_contacts(scene, {.law = ContactLaw::spring, .drag = drag, .walls = true});
  const Motion::State state = run_steps(cpu_backend(), scene, steps);
  Checkpoint checkpoint{scene, cpu_backend().save(), steps};
  checkpoint.scene.positions = state.positions;
  checkpoint.scene.velocities = state.velocities;
  return checkpoint;
}

TEST(Checkpoint, HoldsContactsAndTheirUnits) {
  const ScratchFolder folder;
  Checkpoint written = sample_with_contacts();
  written.scene.contact.skin = 0.05f;  // another than that of most scenes
  write_checkpoint(folder.path("run.checkpoint"), written);
  const Checkpoint read = read_checkpoint(folder.path("run.checkpoint"));
  EXPECT_EQ(read.scene.contact.skin, 0.05f);
  EXPECT_EQ(read.scene.motion, written.scene.motion);
  EXPECT_EQ(read.motion.wide, written.motion.wide);
  const ContactParams left = contact_params(read.scene), right = contact_params(written.scene);
  EXPECT_EQ(left.law, CONTACT_SPRING);
  EXPECT_EQ(left.high_x, right.high_x);
  EXPECT_EQ(left.high_y, right.high_y);
  EXPECT_EQ(left.unit_exponent, right.unit_exponent);
  EXPECT_EQ(left.impulse, right.impulse);
  EXPECT_EQ(left.damping, right.damping);
  EXPECT_EQ(left.mobility, right.mobility);
  EXPECT_LT(left.high_x, int64_t(1) << 61) << "there are walls";
  EXPECT_EQ(read.scene.contact.drag, 0.25f);
}

// Reads a checkpoint as an earlier version wrote it: the contact header, at byte 64, has contact_bytes bytes, not 56.
Checkpoint read_as_of(char version, size_t contact_bytes, const Checkpoint& written) {
  const ScratchFolder folder;
  write_checkpoint(folder.path("new"), written);
  std::string bytes = read_bytes(folder.path("new"));
  const size_t end = 64 + contact_bytes + written.scene.name.size();
  bytes.erase(64 + contact_bytes, 56 - contact_bytes)[8] = version;
  const uint64_t sum = checksum(std::string_view(bytes).substr(0, end));
  bytes.replace(end, 8, std::string(reinterpret_cast<const char*>(&sum), 8));
  return read_checkpoint(folder.write("older", bytes));
}

TEST(Checkpoint, EarlierVersionsHaveNoDragNoSkinAndNoDensity) {
  Checkpoint written = sample_with_contacts();
  written.scene.contact.density = 7850;
  for (const auto& [version, bytes, drag] :
       {std::tuple(char(2), 44u, 0.0f), std::tuple(char(3), 48u, 0.25f), std::tuple(char(4), 52u, 0.25f)}) {
    const Checkpoint read = read_as_of(version, bytes, written);
    EXPECT_EQ(read.scene.contact.drag, drag);
    EXPECT_EQ(read.scene.contact.skin, written.scene.contact.skin) << "found again by spheres in the same places";
    EXPECT_EQ(read.scene.contact.stiffness, written.scene.contact.stiffness);
    EXPECT_EQ(read.scene.contact.density, 1000) << "that of water";
    EXPECT_EQ(read.motion.wide, written.motion.wide);
  }
  EXPECT_EQ(read_as_of(5, 56, written).scene.contact.density, 7850);
}

// As a gas of stiffness 1.4e4 has become after 4,000 steps, whose checkpoint was refused by advice for starts.
TEST(Checkpoint, ARunGoesOnFasterAndFartherOutThanItCouldStart) {
  const ScratchFolder folder;
  Checkpoint written = sample_with_contacts();
  const float skin = written.scene.contact.skin;
  written.scene.contact.stiffness /= 1e12f;
  EXPECT_NE(why_no_contacts(written.scene).find("its contacts can stop"), std::string::npos);
  write_checkpoint(folder.path("fast"), written);
  EXPECT_EQ(read_checkpoint(folder.path("fast")).scene.contact.skin, skin);
  for (vec4& sphere : written.scene.positions) sphere.x += 1e7f;
  EXPECT_EQ(contact_params(written.scene).skin, skin) << "that of the start";
  EXPECT_GT(skin_of(written.scene), skin) << "which another extent would not give";
}

TEST(Checkpoint, IntegersThatAreNotThePositionAreRefused) {
  const ScratchFolder folder;
  Checkpoint wrong = sample_with_contacts();
  store_real(wrong.motion.wide, 5, load_real<int64_t>(wrong.motion.wide, 5) + (int64_t(1) << 40));
  write_checkpoint(folder.path("run.checkpoint"), wrong);
  const std::string complaint = complaint_of([&] { read_checkpoint(folder.path("run.checkpoint")); });
  EXPECT_NE(complaint.find("wide state, sphere 5"), std::string::npos) << complaint;
}

// Each of a sphere's integers against the float32 number that is nearest to it; of a start, whose floats can be finer
// than integers, against those that are made of it.
TEST(Checkpoint, EveryIntegerIsThatOfItsFloat) {
  const ScratchFolder folder;
  const auto complaint_about = [&](const Checkpoint& wrong) {
    write_checkpoint(folder.path("run"), wrong);
    return complaint_of([&] { read_checkpoint(folder.path("run")); });
  };
  const auto expect_refused = [&](const Checkpoint& wrong, const std::string& what) {
    EXPECT_NE(complaint_about(wrong).find("wide state, sphere 13"), std::string::npos) << what;
  };
  for (const Checkpoint& right : {sample_with_contacts(), sample_with_contacts(0, 0)}) {
    EXPECT_EQ(complaint_about(right), "");
    const uint64_t n = right.scene.size(), i = 13;
    for (uint64_t k = i; k < 6 * n; k += n) {
      Checkpoint wrong = right;
      const auto value = load_real<int64_t>(wrong.motion.wide, k);
      store_real(wrong.motion.wide, k, value + value / 1024 + 1024);
      expect_refused(wrong, fmt::format("step {}, word {}", right.step, k));
    }
    constexpr float vec4::*components[] = {&vec4::x, &vec4::y, &vec4::z};
    for (const auto component : components)
      for (const bool is_velocity : {false, true}) {
        Checkpoint wrong = right;
        float& number = (is_velocity ? wrong.scene.velocities : wrong.scene.positions)[i].*component;
        number += number / 1024 + 0x1p-20f;
        expect_refused(wrong, fmt::format("step {}, velocity: {}", right.step, is_velocity));
      }
  }
}

std::string bytes_of_a_checkpoint(const ScratchFolder& folder) {
  const std::string file = folder.path("whole");
  write_checkpoint(file, sample(largest_state));
  return read_bytes(file);
}

TEST(Checkpoint, EveryTruncationIsRefused) {
  const ScratchFolder folder;
  const std::string bytes = bytes_of_a_checkpoint(folder);
  for (size_t length = 0; length < bytes.size(); ++length) {
    const std::string complaint = complaint_of([&] { read_checkpoint(folder.write("cut", bytes.substr(0, length))); });
    ASSERT_NE(complaint.find("cut off"), std::string::npos) << length << " bytes: " << complaint;
  }
  const std::string longer = folder.write("longer", bytes + "x");
  EXPECT_NE(complaint_of([&] { read_checkpoint(longer); }).find("1 byte more"), std::string::npos);
}

TEST(Checkpoint, EveryDamagedByteIsRefused) {
  const ScratchFolder folder;
  const std::string bytes = bytes_of_a_checkpoint(folder);
  for (size_t at = 0; at < bytes.size(); ++at) {
    std::string damaged = bytes;
    damaged[at] = char(damaged[at] ^ 0x10);
    const std::string complaint = complaint_of([&] { read_checkpoint(folder.write("damaged", damaged)); });
    ASSERT_NE(complaint.find("expected"), std::string::npos) << "byte " << at << ": " << complaint;
  }
}

TEST(Checkpoint, SaysWhatIsWrong) {
  const ScratchFolder folder;
  const std::string bytes = bytes_of_a_checkpoint(folder);
  const auto complaint = [&](size_t at, const std::string& replacement) {
    std::string changed = bytes;
    changed.replace(at, replacement.size(), replacement);
    return complaint_of([&] { read_checkpoint(folder.write("changed", changed)); });
  };
  EXPECT_NE(complaint(0, "P").find("no checkpoint"), std::string::npos);
  EXPECT_NE(complaint(8, "\x06").find("version 6"), std::string::npos);
  EXPECT_NE(complaint(12, "\x05").find("of the header"), std::string::npos);
  EXPECT_NE(complaint(64, "X").find("of the header"), std::string::npos);
  const size_t positions = 64 + std::string("random").size() + 16;
  EXPECT_NE(complaint(positions + 5, "X").find("of the positions"), std::string::npos);
  EXPECT_NE(complaint(positions + 3 * 16 + 16 + 7, "X").find("of the velocities"), std::string::npos);
  EXPECT_NE(complaint(bytes.size() - 9, "X").find("of the due steps"), std::string::npos);
  EXPECT_NE(complaint_of([&] { read_checkpoint(folder.path("nothing")); }).find("cannot read"), std::string::npos);
}

nlohmann::json last_step_of(const ScratchFolder& folder, const std::string& arguments) {
  const std::string json_file = folder.path("run.json");
  const std::string command = fmt::format("{} run --backend cpu {} --json {} > {}", SPHEREPAIR_PROGRAM, arguments,
                                          json_file, folder.path("output"));
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  return nlohmann::json::parse(read_bytes(json_file)).at("steps").back();
}

// The tests may have been carried to another machine without it.
class CheckpointProgram : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(SPHEREPAIR_PROGRAM)) GTEST_SKIP() << "no " << SPHEREPAIR_PROGRAM << " here";
  }
};

TEST_F(CheckpointProgram, Row30_TheProgramGoesOnToTheSameBits) {
  const ScratchFolder folder;
  const std::string file = folder.path("middle");
  for (const char* motion : {"paper", "anchored --precision compensated --restitution 0.9"}) {
    const std::string start = fmt::format("--n 500 --motion {}", motion);
    const nlohmann::json whole = last_step_of(folder, start + " --steps 1000");
    last_step_of(folder, fmt::format("{} --steps 500 --save {}", start, file));
    EXPECT_EQ(last_step_of(folder, fmt::format("--resume {} --steps 500", file)), whole) << motion;
    note_figure(motion);
  }
}

TEST_F(CheckpointProgram, ResumeExcludesTheScene) {
  const ScratchFolder folder;
  const std::string file = folder.path("run");
  write_checkpoint(file, sample({}));
  const std::string command = fmt::format("{} run --resume {} --n 7 2> {}", SPHEREPAIR_PROGRAM, file, folder.path("e"));
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 2);
}

}  // namespace
}  // namespace spherepair
