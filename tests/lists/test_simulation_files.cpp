// SPDX-License-Identifier: MIT
// Checkpoints through the C calls: continued on every backend and by the program to the same bits, or refused.
#include <fmt/format.h>

#include <filesystem>

#include "tests/lists/simulation_calls.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

std::string bytes_of(OpenSimulation& opened) {
  size_t size = 0;
  EXPECT_EQ(sp_simulation_save_bytes(opened.simulation, nullptr, 0, &size), SP_E_CAPACITY);
  std::string bytes(size, '\0');
  EXPECT_EQ(sp_simulation_save_bytes(opened.simulation, bytes.data(), size, &size), SP_OK) << opened.message();
  return bytes;
}

// The reason why these bytes are refused; empty if they are not.
std::string refusal_of(const std::string& bytes) {
  OpenSimulation resumed(bytes, "cpu");
  EXPECT_EQ(resumed.status == SP_OK, resumed.simulation != nullptr);
  EXPECT_TRUE(resumed.status == SP_OK || resumed.status == SP_E_ARGUMENT) << resumed.message();
  return resumed.message();
}

TEST(SimulationFiles, EveryBackendContinuesEveryOthers) {
  for (const char* law : {"none", "spring", "hertz", "quartic"}) {
    GivenSpheres spheres = three_spheres();
    sp_scene given = spheres.scene(law);
    given.gravity = 9.81, given.plane = 0.125;
    OpenSimulation whole(given);
    ASSERT_EQ(whole.status, SP_OK) << whole.message();
    whole.move(400);
    for (int32_t k = 0; const char* from = sp_backend_name(k); ++k) {
      OpenSimulation first(given, from);
      if (first.status == SP_E_BACKEND) continue;  // it is not here
      first.move(150);
      const std::string bytes = bytes_of(first);
      for (int32_t other = 0; const char* to = sp_backend_name(other); ++other) {
        SCOPED_TRACE(fmt::format("{} from {} to {}", law, from, to));
        OpenSimulation second(bytes, to);
        if (second.status == SP_E_BACKEND) continue;
        ASSERT_EQ(second.status, SP_OK) << second.message();
        EXPECT_EQ(sp_simulation_spheres(second.simulation), 3u);
        EXPECT_EQ(sp_simulation_dt(second.simulation), sp_simulation_dt(whole.simulation));
        EXPECT_EQ(bytes_of(second), bytes);
        second.move(250);
        EXPECT_EQ(sp_simulation_steps(second.simulation), 400u);
        EXPECT_EQ(second.state(3), whole.state(3));
        EXPECT_EQ(bytes_of(second), bytes_of(whole));
      }
    }
  }
}

TEST(SimulationFiles, EverySizeOfRoomIsKept) {
  GivenSpheres spheres = three_spheres();
  OpenSimulation opened(spheres.scene("spring"));
  const std::string bytes = bytes_of(opened);
  std::string room(bytes.size() + 9, '#');
  size_t size = 0;
  EXPECT_EQ(sp_simulation_save_bytes(opened.simulation, room.data(), bytes.size() - 1, &size), SP_E_CAPACITY);
  EXPECT_EQ(opened.message(), fmt::format("the checkpoint has {} bytes, but room is {}", size, size - 1));
  EXPECT_EQ(room, std::string(bytes.size() + 9, '#')) << "written without room";
  EXPECT_EQ(sp_simulation_save_bytes(opened.simulation, room.data(), room.size(), &size), SP_OK);
  EXPECT_EQ(size, bytes.size());
  EXPECT_EQ(room, bytes + "#########");
}

TEST(SimulationFiles, WhatIsNoWholeCheckpointIsRefused) {
  GivenSpheres spheres = three_spheres();
  OpenSimulation opened(spheres.scene("hertz"));
  opened.move(20);
  const std::string bytes = bytes_of(opened);
  EXPECT_EQ(refusal_of(bytes), "");
  for (size_t length = 0; length < bytes.size(); ++length)
    ASSERT_NE(refusal_of(bytes.substr(0, length)).find("the checkpoint, byte"), std::string::npos) << length;
  EXPECT_NE(refusal_of(bytes + "x").find("1 byte more"), std::string::npos);
  EXPECT_NE(refusal_of("\x89PNG and more").find("no checkpoint"), std::string::npos);
  std::string damaged = bytes;
  damaged[bytes.size() / 2] ^= 1;
  EXPECT_NE(refusal_of(damaged).find("damaged"), std::string::npos);
}

TEST(SimulationFiles, WhatCannotBeWrittenLeavesTheOldFile) {
  const ScratchFolder folder;
  GivenSpheres falling{.positions = {0, 1, 0, 0.5, 1, 0}, .radii = {0.002, 0.001}};
  sp_scene given = falling.scene("spring");
  given.gravity = 9.81, given.stiffness = 1e-4, given.dt = 0.004;
  OpenSimulation opened(given);
  const std::string file = folder.path("a --b"), bytes = bytes_of(opened);
  ASSERT_EQ(sp_simulation_save(opened.simulation, file.c_str()), SP_OK) << opened.message();
  EXPECT_EQ(read_bytes(file), bytes);
  EXPECT_EQ(sp_simulation_save(opened.simulation, folder.path("none/b").c_str()), SP_E_ARGUMENT);
  EXPECT_NE(opened.message().find("cannot write " + folder.path("none/b")), std::string::npos) << opened.message();
  EXPECT_EQ(sp_simulation_save(opened.simulation, ""), SP_E_ARGUMENT);
  EXPECT_EQ(sp_simulation_save(opened.simulation, nullptr), SP_E_ARGUMENT);
  EXPECT_EQ(opened.message(), "file has no name");
  EXPECT_EQ(sp_simulation_move(opened.simulation, 9), SP_E_ARGUMENT) << "a sphere gets too fast";
  EXPECT_EQ(sp_simulation_save(opened.simulation, file.c_str()), SP_E_ARGUMENT);
  EXPECT_EQ(opened.message(), "a step of this simulation failed: close it");
  EXPECT_EQ(read_bytes(file), bytes);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a --b"}) << "something is left";
}

TEST(SimulationFiles, WrongUseIsRefused) {
  sp_simulation* none = nullptr;
  const auto says = [&](sp_status status, const std::string& text) {
    EXPECT_EQ(status, SP_E_ARGUMENT) << text;
    EXPECT_EQ(none, nullptr);
    const std::string message = sp_simulation_message(nullptr);
    EXPECT_NE(message.find(text), std::string::npos) << message;
  };
  says(sp_simulation_resume("cpu", nullptr, 0, "/no --such/file", &none), "cannot read /no --such/file: No such file");
  says(sp_simulation_resume("cpu", nullptr, 0, "/", &none), "cannot read /: Is a directory");
  says(sp_simulation_resume("cpu", nullptr, 0, "-", &none), "cannot read ./-: No such file");
  says(sp_simulation_resume("cpu", nullptr, 0, nullptr, &none), "file has no name");
  says(sp_simulation_resume("cpu", nullptr, 0, "x", nullptr), "out is NULL");
  says(sp_simulation_resume_bytes("cpu", nullptr, 0, nullptr, 5, &none), "bytes is NULL, but size is 5");
  says(sp_simulation_resume_bytes("cpu", nullptr, 0, nullptr, 0, &none), "the checkpoint, byte 0");
  GivenSpheres spheres = three_spheres();
  OpenSimulation opened(spheres.scene());
  const std::string bytes = bytes_of(opened);
  says(sp_simulation_resume_bytes("abacus", nullptr, 0, bytes.data(), bytes.size(), &none), "abacus");
  size_t size = 0;
  EXPECT_EQ(sp_simulation_save_bytes(opened.simulation, nullptr, 0, nullptr), SP_E_ARGUMENT);
  EXPECT_EQ(sp_simulation_save_bytes(opened.simulation, nullptr, 5, &size), SP_E_ARGUMENT);
  EXPECT_EQ(opened.message(), "bytes is NULL, but room is 5");
  EXPECT_EQ(sp_simulation_save_bytes(nullptr, nullptr, 0, &size), SP_E_ARGUMENT);
  EXPECT_EQ(sp_simulation_save(nullptr, "x"), SP_E_ARGUMENT);
  EXPECT_EQ(sp_simulation_spheres(nullptr), 0u);
}

class SimulationOfTheProgram : public ProgramTest {};

TEST_F(SimulationOfTheProgram, ContinuesWhatTheLibrarySaved) {
  for (const char* law : {"none", "spring"}) {
    GivenSpheres spheres = three_spheres();
    sp_scene given = spheres.scene(law);
    given.gravity = 9.81;
    OpenSimulation opened(given);
    opened.move(30);
    ASSERT_EQ(sp_simulation_save(opened.simulation, path("first").c_str()), SP_OK) << opened.message();
    const Outcome done =
        run(fmt::format("run --backend cpu --resume {} --steps 70 --save {}", path("first"), path("second")));
    ASSERT_EQ(done.code, 0) << done.errors;
    opened.move(70);
    EXPECT_EQ(read_bytes(path("second")), bytes_of(opened)) << law;
  }
}

TEST_F(SimulationOfTheProgram, IsContinuedByTheLibrary) {
  for (const char* scene :
       {"--contact spring --restitution 0.5", "--motion anchored", "--motion symplectic --precision compensated",
        "--motion impact --precision float64", "--motion paper"}) {
    SCOPED_TRACE(scene);
    const std::string begin = fmt::format("run --backend cpu --scene random --n 60 {} --steps ", scene);
    for (const auto& [steps, file] : {std::pair("40", "first"), std::pair("90", "whole")}) {
      const Outcome done = run(fmt::format("{}{} --save {}", begin, steps, path(file)));
      ASSERT_EQ(done.code, 0) << done.errors;
    }
    OpenSimulation resumed;
    resumed.status = sp_simulation_resume("cpu", nullptr, 0, path("first").c_str(), &resumed.simulation);
    ASSERT_EQ(resumed.status, SP_OK) << resumed.message();
    EXPECT_EQ(sp_simulation_steps(resumed.simulation), 40u);
    resumed.move(50);
    EXPECT_EQ(bytes_of(resumed), read_bytes(path("whole")));
  }
}

}  // namespace
}  // namespace spherepair
