// SPDX-License-Identifier: MIT
// Sorts and moves that begin while the search before is under way.
#include "frames.h"
#include "grid_answers.h"

namespace spherepair {
namespace {

class Overlap : public BackendTest {
 protected:
  // Nothing waits between steps, one after another by turns with radii and without, so that a sort has other words to
  // write than the one before has; then moves among them.
  Answer after_many_steps(std::optional<bool> overlap) {
    const auto step = [&](bool load_radii) {
      return grid_step([&](CollideOptions& o) {
        o.grid.cells = Cells::dense, o.grid.sort = Sort::buckets;
        o.load_radii = load_radii, o.tricks.overlap = overlap;
      });
    };
    backend().upload(make_scene({.name = "uniform", .n = 100'000}));
    for (int k = 0; k < 12; ++k) {
      backend().collide(step(k % 2 == 0));
      if (k % 3 == 2) backend().move();
    }
    return ask(backend(), step(true));
  }
  bool overlaps() {
    const std::string& name = backend().info().name;
    return name == "glsl" || (name == "cuda" && std::stod(backend().info().details.at("compute capability")) >= 9);
  }
};

TEST_P(Overlap, NeverChangesTheSet) {
  const Answer wanted = after_many_steps(false);
  const std::optional<bool> kinds[] = {std::nullopt, true};
  for (const std::optional<bool> overlap : kinds) {
    if (overlap && !overlaps()) continue;
    const Answer given = after_many_steps(overlap);
    EXPECT_EQ(given.totals.pairs, wanted.totals.pairs);
    EXPECT_EQ(given.totals.fingerprint, wanted.totals.fingerprint);
    EXPECT_EQ(given.totals.colliding_spheres, wanted.totals.colliding_spheres);
    EXPECT_EQ(given.counts, wanted.counts);
    backend().check_guards();
  }
}

TEST_P(Overlap, IsOfWhatNeedsNothingOfTheSearch) {
  if (!overlaps()) GTEST_SKIP() << "launches wait for one another here";
  const auto beside = [&](auto act) {
    const uint64_t before = backend().work_counts().beside;
    act();
    return backend().work_counts().beside - before;
  };
  backend().upload(make_scene({.name = "uniform", .n = 5000}));
  CollideOptions options = grid_step([](CollideOptions& o) { o.grid.sort = Sort::buckets; });
  const auto collide = [&] { backend().collide(options); };
  const auto move = [&] { backend().move(); };
  EXPECT_EQ(beside(collide), 0u) << "nothing was there before";
  EXPECT_EQ(beside(collide), 1u) << "split_tiles beside collide_grid";
  EXPECT_EQ(beside(move), 1u);
  EXPECT_EQ(beside(move), 0u) << "a move needs the move before";
  EXPECT_EQ(beside(collide), 0u) << "spheres that move are not sorted";
  options.tricks.overlap = false;
  EXPECT_EQ(beside(collide), 0u);
  EXPECT_EQ(beside(move), 0u);
  options = grid_step([](CollideOptions& o) { o.grid.sort = Sort::counting; });
  for (int k = 0; k < 2; ++k) EXPECT_EQ(beside(collide), 0u) << "grid_clear writes the cells that are searched";
  options = grid_step([](CollideOptions& o) { o.grid.keep_order = true; });
  backend().upload(in_cell_order(make_scene({.name = "uniform", .n = 5000})));
  for (int k = 0; k < 2; ++k) EXPECT_EQ(beside(collide), 0u);
  EXPECT_EQ(beside(move), 0u) << "the search reads the spheres that are moved";
}

INSTANTIATE_BACKENDS(Overlap);

}  // namespace
}  // namespace spherepair
