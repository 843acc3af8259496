// SPDX-License-Identifier: MIT
// The backend opengl-spirv finds the same sets and states as opengl-core, whose kernels the driver compiles from text.
#include "tests/support/backends.h"

namespace spherepair {
namespace {

// Null, and the reason, where the driver takes no SPIR-V or this build makes none.
std::unique_ptr<Backend> opened(const std::string& name, std::string& reason) {
  try {
    return open_backend(name, {});
  } catch (const BackendError& error) {
    return reason = error.what(), nullptr;
  }
}

TEST(OpenGlSpirv, SetsAndStatesAreThoseOfTheText) {
  std::string reason;
  const auto text = opened("opengl-core", reason), spirv = opened("opengl-spirv", reason);
  if (!text || !spirv) {
    ASSERT_FALSE(backend_required("opengl")) << reason;
    GTEST_SKIP() << reason;
  }
  EXPECT_EQ(spirv->info().name, "opengl-spirv");
  for (Backend* backend : {text.get(), spirv.get()}) {
    backend->upload(make_scene({.name = "uniform", .n = 700}));
    for (int k = 0; k < 3; ++k) backend->move();
  }
  EXPECT_EQ(hash_of_state(*spirv), hash_of_state(*text));
  constexpr uint blocks[] = {64};
  for (const CollideOptions& options : every_method(*text, blocks))
    EXPECT_EQ(run_step(*spirv, options).totals.fingerprint, run_step(*text, options).totals.fingerprint)
        << describe(options);
}

}  // namespace
}  // namespace spherepair
