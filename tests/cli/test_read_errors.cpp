// SPDX-License-Identifier: MIT
// What cannot be read, or is no text, is never taken for a file that ends there.
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

class ReadErrors : public ProgramTest {
 protected:
  void expect_refused(const std::string& arguments, const std::string& reason) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, kUsage) << arguments << '\n' << outcome.output;
    EXPECT_NE(outcome.errors.find(reason), std::string::npos) << arguments << '\n' << outcome.errors;
  }
  void expect_line(const std::string& name, const std::string& text, const std::string& reason) const {
    expect_refused("run --backend cpu --input " + folder_.write(name, text), reason);
  }
};

// The first page of a process's memory: to read it is an I/O error.
TEST_F(ReadErrors, AnErrorIsNotTheEndOfTheFile) {
  for (const char* name : {"memory.txt", "memory.xyz", "memory.npy"}) {
    fs::create_symlink("/proc/self/mem", path(name));
    expect_refused("run --backend cpu --input " + path(name), "Input/output error");
  }
  expect_refused("equal /proc/self/mem /proc/self/mem", "Input/output error");
}

TEST_F(ReadErrors, AFolderHoldsNoSpheres) {
  for (const char* name : {"folder.txt", "folder.xyz", "folder.npy"}) {
    fs::create_directory(path(name));
    expect_refused("run --backend cpu --input " + path(name), "Is a directory");
  }
  expect_refused(fmt::format("equal {0} {0}", path("folder.txt")), "Is a directory");
}

TEST_F(ReadErrors, ANulByteIsNamedByItsLine) {
  const std::string nul(1, '\0');
  for (const std::string& line : {"1 2 3 4" + nul, nul + nul + nul, "# comment" + nul, nul + " 1 2 3 4"})
    expect_line("a.txt", "0 0 0 1\n" + line + "\n5 5 5 1\n", "a.txt, line 2: expected text, found a NUL byte");
  for (const std::string& line : {"H" + nul + " 1 2 3 1", nul, "H 1 2 3 1" + nul})
    expect_line("a.xyz", "2\n\nH 9 9 9 1\n" + line + "\n", "a.xyz, line 4: expected text, found a NUL byte");
  expect_line("a.xyz", "1\n" + nul + "\nH 9 9 9 1\n", "a.xyz, line 2: expected text");
}

TEST_F(ReadErrors, ABadLineOfTextSaysWhatIsWrong) {
  expect_line("a.txt", "0 0 0 1\n\n1 2 x 4\n", "a.txt, line 3: expected a number for z in column 3, found 'x'");
  expect_line("a.txt", "1 2 3 4 5\n",
              "line 1: expected 3 columns (x y z), 4 (and radius) or 7 (and vx vy vz); others need --columns, found 5");
  expect_line("a.txt", "1 2 3 4 5 6 7 8\n", "found 8");
  expect_line("a.txt", "1 2 3 -4\n", "a radius that is not negative for radius, found '-4'");
  for (const char* wrong : {"nan", "inf", "1e39"})
    expect_line("a.txt", fmt::format("0 0 0 1 0 {} 0\n", wrong), "a finite number within the range of float32 for vy");
}

TEST_F(ReadErrors, TextIsReadAsBefore) {
  const std::string text = "# spheres\n0 1 0 .5 0 0 0\r\n\t+0.9\t1e0 -0 0.5 1 2 3. # fast\n\n   \n3 1 0 0.5 0 0 0";
  const std::string pairs = path("pairs.txt");
  const Outcome outcome =
      run(fmt::format("run --backend cpu --input {} --pairs {}", folder_.write("a.txt", text), pairs));
  EXPECT_EQ(outcome.code, kOk) << outcome.errors;
  EXPECT_NE(outcome.output.find("3 spheres"), std::string::npos) << outcome.output;
  EXPECT_EQ(read_bytes(pairs), "# i j\n0 1\n");
}

}  // namespace
}  // namespace spherepair
