// SPDX-License-Identifier: MIT
// Help texts and documentation name every format of the table of formats.
#include "bench/spheres/sphere_formats.h"
#include "tests/support/pairs_command.h"

namespace spherepair {
namespace {

using SphereFormats = PairsCommand;

std::string without_blanks(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  return text;
}

TEST_F(SphereFormats, HelpOfPairsDescribesEachOne) {
  if (!fs::exists(SPHEREPAIR_PROGRAM)) GTEST_SKIP() << "no " << SPHEREPAIR_PROGRAM << " here";
  ASSERT_EQ(run_program("pairs --help"), 0) << errors_;
  const std::string help = without_blanks(output_);
  for (const SphereFormat& format : sphere_formats()) {
    const std::string row = fmt::format("{} ({}; {})", format.name, format.extensions_text(), format.contents);
    EXPECT_NE(help.find(without_blanks(row)), help.npos) << row << "\nis not in\n" << output_;
  }
}

// | NPY (`.npy`) | contents |
TEST_F(SphereFormats, EachOneHasARowInTheDocumentation) {
  const std::string commands = read_bytes(std::string(SPHEREPAIR_DATA) + "/../../docs/commands.md");
  if (commands.empty()) GTEST_SKIP() << "no docs/commands.md here";
  for (const SphereFormat& format : sphere_formats()) {
    const auto end = std::ranges::find(format.extensions, "");
    const std::string row = fmt::format("(`{}`) |", fmt::join(format.extensions.begin(), end, "`, `"));
    EXPECT_NE(commands.find(row), commands.npos) << row << " is not in docs/commands.md";
  }
}

TEST_F(SphereFormats, RefusedOptionsNameTheFormatsThatTakeThem) {
  const std::string file = folder_.write("a.csv", "0 0 0 1\n");
  const auto refusal = [&](const SphereFileOptions& options) {
    return complaint_of([&] { read_sphere_file(file, options); });
  };
  EXPECT_EQ(refusal({.frame = 0}),
            fmt::format("{} (columns of text) has no frames: --frame is for {}, omit it", file, names_of_framed()));
  for (const SphereFormat& format : sphere_formats()) {
    EXPECT_EQ(refusal({.frame = 0}).find(format.name) != std::string::npos, format.open || format.read == read_text);
    EXPECT_EQ(refusal({.ignore_periodic = true}).find(format.name) != std::string::npos,
              format.has(FORMAT_HAS_BOXES) || format.read == read_text);
    EXPECT_EQ(refusal({.species = true}).find(format.name) != std::string::npos,
              format.has(FORMAT_HAS_SPECIES) || format.read == read_text);
  }
}

}  // namespace
}  // namespace spherepair
