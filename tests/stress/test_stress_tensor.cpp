// SPDX-License-Identifier: MIT
// Scenes that press the error bound of collide_tensor: pairs as near tangency as float32 allows, at extents of 2^6 to
// 2^12 diameters, far from the origin, over scales, with an outlier. The bound itself: tests/unit/test_tensor_form.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/oracle/adversarial.h"
#include "tests/oracle/oracle.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

const CollideOptions tensor = {.method = Method::collide_tensor};

class TensorCores : public KernelTest {
 protected:
  bool offered() {
    const std::vector<Method> methods = backend().methods();
    return std::ranges::find(methods, Method::collide_tensor) != methods.end();
  }
  // By the same search without tensor cores where there are none; in software Methods tests that.
  void expect_right_set(const std::vector<vec4>& spheres) {
    if (!offered() && !by_form(backend(), true, false)) return;
    const std::vector<Pair> expected = swept_pairs(spheres);
    EXPECT_TRUE(spheres.size() < 200 || !expected.empty());
    expect_pairs(backend(), scene_of(spheres), expected, {offered() ? tensor : fast_method(backend())});
  }
};

// Pairs that touch to within a few ulp, their centres all over a box, the most of them near its corners.
std::vector<vec4> near_tangent_pairs(uint64_t seed, float extent, float offset, float scale) {
  Random random(seed);
  std::vector<vec4> spheres;
  for (int pair = 0; pair < 1500; ++pair) {
    float centre[3], way[3];
    double norm = 0;
    for (int k = 0; k < 3; ++k) {
      const double corner = random.below(2) ? random.uniform(0.98, 1) : random.uniform(0, 1);
      centre[k] = float((double(offset) + double(random.sign()) * corner * extent) * scale);
      way[k] = float(random.uniform(-1, 1));
      norm += double(way[k]) * way[k];
    }
    const auto moved = [&](int k) { return float(centre[k] + double(way[k]) / std::sqrt(norm) * scale); };
    const vec4 a = {centre[0], centre[1], centre[2], 0.5f * scale}, b = {moved(0), moved(1), moved(2), 0};
    const double x = double(a.x) - b.x, y = double(a.y) - b.y, z = double(a.z) - b.z;
    const float radius = std::max(0.0f, float(std::sqrt(x * x + y * y + z * z) - double(a.w)));
    spheres.push_back(a);
    spheres.push_back({b.x, b.y, b.z, radius > scale * 0.01f ? nudged(radius, random.between(-3, 3)) : radius});
  }
  return spheres;
}

TEST_P(TensorCores, AreThereOnSomeGpusAndRefusedWithTheReasonElsewhere) {
  const auto& details = backend().info().details;
  const auto says = [&](const char* what, const char* value) {
    const auto found = details.find(what);
    return found != details.end() && found->second == value;
  };
  EXPECT_EQ(offered(), says("compute capability", "9.0") || says("tensor cores", "yes"));
  if (offered()) return;
  backend().upload(make_scene({.name = "uniform", .n = 300}));
  try {
    backend().collide(tensor);
    FAIL() << "searched";
  } catch (const std::invalid_argument& error) {
    for (const char* what : {"compute capability 9.0 (H100, H200)", "in Vulkan on one with VK_NV_cooperative_matrix"})
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
  }
}

TEST_P(TensorCores, DecideNearTangentPairsAtEveryExtent) {
  for (const float extent : {64.0f, 1024.0f, 4096.0f})
    for (const float offset : {0.0f, 1e6f})
      for (const float scale : {0x1p-40f, 1.0f, 0x1p40f})
        expect_right_set(near_tangent_pairs(1, extent, offset, scale));
}

TEST_P(TensorCores, HoldSizesAroundTheirTiles) {
  const auto expect_right_size = [&](uint64_t n, float ratio) {
    const Scene scene = make_scene({.name = "uniform", .n = n, .radius_ratio = ratio, .packing_fraction = 0.5});
    expect_right_set(scene.positions);
  };
  for (const uint64_t n : {2, 255, 256, 257, 1023, 1024, 1025, 2049, 5000})
    for (const float ratio : {1.0f, 30.0f}) expect_right_size(n, ratio);
  if (offered()) expect_right_size(70'000, 1);  // many tiles a group
}

TEST_P(TensorCores, LoseNothingToAnOutlier) {
  for (const float far : {1e3f, 1e6f, 1e30f}) {
    std::vector<vec4> spheres = make_scene({.name = "uniform", .n = 4000}).positions;
    spheres[1234] = {far, -far, far, 0.5f};
    expect_right_set(spheres);
    spheres[1234] = {0, 0, 0, far};
    expect_right_set(spheres);
  }
}

INSTANTIATE_BACKENDS(TensorCores);

}  // namespace
}  // namespace spherepair
