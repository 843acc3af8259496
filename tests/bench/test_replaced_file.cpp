// SPDX-License-Identifier: MIT
// A file that is to be replaced stays as it is when writing fails or the program is killed, and nothing is left behind.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>

#include "common/files/replaced_file.h"
#include "tests/support/sphere_files.h"

namespace {
std::function<void(bool is_folder)> on_fsync = [](bool) {};
}

// In place of the C library's, so that a test sees what is on the disk at that moment.
extern "C" int fsync(int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) == 0) on_fsync(S_ISDIR(status.st_mode));
  return int(syscall(SYS_fsync, descriptor));
}

namespace spherepair {
namespace {

TEST(ReplacedFile, FullDiskLosesNothing) {
  const ScratchFolder folder;
  const std::string old = folder.write("pairs.npy", "old");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{1000, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string complaint = complaint_of([&] {
    ReplacedFile file(old);
    file.write(std::string(2000, 'x'));
    file.commit();
  });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(complaint.find("cannot write " + old), std::string::npos) << complaint;
  EXPECT_EQ(read_bytes(old), "old");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"pairs.npy"});
}

TEST(ReplacedFile, BeingKilledLosesNothing) {
  const ScratchFolder folder;
  const std::string old = folder.write("pairs.npy", "old");
  const pid_t child = fork();
  if (child == 0) {
    ReplacedFile half(old);
    half.write("half");
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(read_bytes(old), "old");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"pairs.npy"});
}

// Else a loss of power could leave the name with an empty file.
TEST(ReplacedFile, BytesReachTheDiskBeforeTheNameDoes) {
  const ScratchFolder folder;
  const std::string file = folder.write("pairs.npy", "old");
  std::vector<std::string> seen;
  on_fsync = [&](bool is_folder) { seen.push_back((is_folder ? "folder: " : "file: ") + read_bytes(file)); };
  ReplacedFile replaced(file);
  replaced.write("new");
  replaced.commit();
  on_fsync = [](bool) {};
  EXPECT_EQ(seen, (std::vector<std::string>{"file: old", "folder: new"}));
}

}  // namespace
}  // namespace spherepair
