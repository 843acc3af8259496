// SPDX-License-Identifier: MIT
// Writes, reads and compares files of spheres.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/sphere_files.h"

namespace spherepair {

inline const ScratchFolder& scratch() {
  static const ScratchFolder folder;
  return folder;
}

inline SphereFile read_from(const std::string& text, const SphereFileOptions& options = {},
                            const std::string& kind = "xyz") {
  return read_sphere_file(scratch().write("spheres." + kind, text), options);
}

inline void expect_spheres(const SphereFile& input, const std::vector<vec4>& expected) {
  ASSERT_EQ(input.scene.size(), expected.size());
  ASSERT_EQ(input.scene.velocities.size(), expected.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    const vec4 &p = input.scene.positions[i], &q = expected[i], &v = input.scene.velocities[i];
    EXPECT_TRUE(float_bits(p.x) == float_bits(q.x) && float_bits(p.y) == float_bits(q.y) &&
                float_bits(p.z) == float_bits(q.z) && float_bits(p.w) == float_bits(q.w))
        << fmt::format("sphere {}: ({} {} {} {}), not ({} {} {} {})", i, p.x, p.y, p.z, p.w, q.x, q.y, q.z, q.w);
    EXPECT_TRUE(v.x == 0 && v.y == 0 && v.z == 0) << "at rest";
  }
}

}  // namespace spherepair
