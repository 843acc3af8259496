// SPDX-License-Identifier: MIT
// Films, through a stand-in for ffmpeg: it keeps its arguments and copies the images into the file named by the caller.
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

constexpr size_t bytes_of_film = 3 * 64 * 48 * 4;

class Film : public ProgramTest {
 protected:
  // What ffmpeg does with the images: "cat > \"$film\"".
  Outcome film(const std::string& name, const std::string& encode, const std::string& before = "") const {
    fs::create_directories(path("bin"));
    folder_.write("bin/ffmpeg", fmt::format("#!/bin/sh\n[ \"$1\" = -version ] && exit 0\necho \"$*\" >>'{}'\n"
                                            "for film; do :; done\n{}\n",
                                            path("arguments"), encode));
    fs::permissions(path("bin/ffmpeg"), fs::perms::owner_all);
    return run(fmt::format("render --backend cpu --n 20 --size 64x48 --samples 1 --images 3 --video={}", name),
               fmt::format("cd '{}'; PATH='{}':$PATH {}", path(""), path("bin"), before));
  }
};

TEST_F(Film, IsWholeAndLeavesItsNeighboursAlone) {
  const std::string victim = folder_.write("victim", "mine");
  fs::create_symlink(victim, path("a.new.mp4"));
  folder_.write("a.mp4.new", "another's");
  const Outcome outcome = film("a.mp4", "cat >\"$film\"");
  EXPECT_EQ(outcome.code, kOk) << outcome.errors;
  EXPECT_EQ(read_bytes(path("a.mp4")).size(), bytes_of_film);
  EXPECT_EQ(read_bytes(victim), "mine");
  EXPECT_EQ(folder_.names(),
            (std::vector<std::string>{"a.json", "a.mp4", "a.mp4.new", "a.new.mp4", "arguments", "bin", "victim"}));
}

TEST_F(Film, ItsNameIsNeverAnOptionOfFfmpeg) {
  for (const char* name : {"-vf.mp4", "-.mp4", "pipe:1.mp4", "'it s '\\''quoted'\\''.mp4'"}) {
    const Outcome outcome = film(name, "cat >\"$film\"");
    EXPECT_EQ(outcome.code, kOk) << name << outcome.errors;
    EXPECT_EQ(read_bytes(path("arguments")).find("vf"), std::string::npos) << read_bytes(path("arguments"));
  }
  for (const char* name : {"-vf.mp4", "-.mp4", "pipe:1.mp4", "it s 'quoted'.mp4"})
    EXPECT_EQ(read_bytes(path(name)).size(), bytes_of_film) << name;
  EXPECT_FALSE(read_bytes(path("arguments")).empty());
}

TEST_F(Film, OfWhichFfmpegFailedReplacesNothing) {
  folder_.write("a.mp4", "old");
  const Outcome outcome = film("a.mp4", "head -c 1000 >\"$film\"; exit 1");
  EXPECT_EQ(outcome.code, kDeviceFailure) << outcome.errors;
  EXPECT_EQ(read_bytes(path("a.mp4")), "old");
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"a.mp4", "arguments", "bin"}));
}

// The second of three images never gets through; a signal then ends the program.
TEST_F(Film, ThatIsInterruptedLeavesNothing) {
  for (const char* signal : {"INT", "TERM", "HUP"})
    for (const std::string& system : {std::string(), std::string("LD_PRELOAD='" SPHEREPAIR_NO_UNNAMED_FILES "' ")}) {
      const bool loadable = limits_address_space && fs::exists(SPHEREPAIR_NO_UNNAMED_FILES);
      if (!system.empty() && !loadable) continue;  // a sanitizer must be loaded first
      const Outcome outcome = film("a.mp4",
                                   fmt::format("head -c 1000 >\"$film\"\nls >>listing\np=$PPID\n"
                                               "until [ \"$(cat /proc/$p/comm)\" = spherepair ]; do "
                                               "p=$(cut -d ' ' -f 4 /proc/$p/stat); done\nkill -{} $p; sleep 1",
                                               signal),
                                   system);
      EXPECT_EQ(folder_.names(), (std::vector<std::string>{"arguments", "bin", "listing"}))
          << signal << system << outcome.errors;
      EXPECT_NE(outcome.code, kOk);
      EXPECT_EQ(read_bytes(path("listing")).find("a.mp4.new") != std::string::npos, !system.empty())
          << "not what this tests";
      fs::remove(path("listing"));
    }
}

}  // namespace
}  // namespace spherepair
