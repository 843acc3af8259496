// SPDX-License-Identifier: MIT
// The calls of spherepair.hpp as a user's program makes them, against the installed library. Exits 1 at the first that
// does not hold, and names its line.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <spherepair/simulation.hpp>
#include <spherepair/spherepair.hpp>
#include <type_traits>
#include <utility>
#include <vector>

using namespace spherepair;

static_assert(!std::is_copy_constructible_v<Context> && std::is_nothrow_move_constructible_v<Context>);
static_assert(!std::is_copy_constructible_v<PairList> && std::is_nothrow_move_assignable_v<PairList>);
static_assert(!std::is_convertible_v<std::vector<int>, Points> && !std::is_convertible_v<std::vector<double>, Offsets>);

#define HOLDS(condition)                                                         \
  do {                                                                           \
    if (!(condition)) {                                                          \
      std::fprintf(stderr, "line %d: %s does not hold\n", __LINE__, #condition); \
      std::exit(1);                                                              \
    }                                                                            \
  } while (false)

// The status with which work() fails, and whether its message has the words.
template <typename Work>
static bool fails(sp_status status, const char* words, Work work) {
  try {
    work();
  } catch (const Error& error) {
    if (error.status() == status && std::string(error.what()).find(words) != std::string::npos) return true;
    std::fprintf(stderr, "status %d: %s\n", int(error.status()), error.what());
  }
  return false;
}

const std::vector<double> row = {0, 0, 0, 1, 0, 0, 2, 0, 0, 4, 0, 0};  // four points on a line
using Ids = std::vector<int32_t>;

static Ids ids(std::span<const int32_t> column) { return {column.begin(), column.end()}; }

static void views(Context& context) {
  const std::vector<float> narrow(row.begin(), row.end());
  const std::vector<std::array<double, 3>> triples = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {4, 0, 0}};
  const std::array<std::array<float, 3>, 2> narrow_triples = {{{0, 0, 0}, {1, 0, 0}}};
  const double plain[] = {0, 0, 0, 1, 0, 0};
  struct Particle {
    double mass, position[3];
  } const particles[] = {{1, {0, 0, 0}}, {1, {1, 0, 0}}, {1, {9, 0, 0}}};
  HOLDS(context.count({.positions = row, .cutoff = 1.5, .half = true}) == 2);
  HOLDS(context.count({.positions = narrow, .cutoff = 1.5, .half = true}) == 2);
  HOLDS(context.count({.positions = triples, .cutoff = 1.5, .half = true}) == 2);
  HOLDS(context.count({.positions = std::span(row).first(6), .cutoff = 1.5, .half = true}) == 1);
  HOLDS(context.count({.positions = narrow_triples, .cutoff = 1.5, .half = true}) == 1);
  HOLDS(context.count({.positions = plain, .cutoff = 1.5, .half = true}) == 1);
  HOLDS(context.count({.positions = {particles[0].position, 3, 4}, .cutoff = 1.5, .half = true}) == 1);
  HOLDS(context.count({.positions = {row.data(), 2, 9}, .cutoff = 4.5, .half = true}) == 1);
  HOLDS(context.count({.positions = std::vector<double>(), .cutoff = 1}) == 0);
}

static void fields(Context& context) {
  const std::vector<float> radii = {0.5F, 0.5F, 0.75F, 1.25F};
  HOLDS(context.count({.positions = row, .radii = radii, .half = true}) == 1);
  HOLDS(context.count({.positions = row, .radii = radii, .half = true, .inclusive = true}) == 3);
  HOLDS(context.count({.positions = row, .radii = radii, .skin = 0.01, .half = true}) == 3);
  HOLDS(context.count({.positions = row, .cutoff = 0.5, .self_pairs = true}) == 4);

  const Ids two_systems = {0, 1, 4};
  const std::vector<std::array<int64_t, 2>> left_out = {{2, 1}};
  HOLDS(context.count({.positions = row, .cutoff = 1.5, .offsets = two_systems, .half = true}) == 1);
  HOLDS(context.count({.positions = row, .cutoff = 1.5, .exclusions = left_out, .half = true}) == 1);

  const std::vector<double> queries = {3, 0, 0}, far = {0, 9, 0, 4, 1, 0};
  const std::vector<double> query_radii = {0.5};
  const std::vector<int64_t> a_query_each = {0, 1, 2};
  const auto found = context.list({.positions = row, .cutoff = 1.5, .queries = queries}, SP_OFFSETS);
  HOLDS(ids(found.second()) == Ids({2, 3}) && ids(found.first()) == Ids({0, 0}) && found.offsets().size() == 2);
  HOLDS(context.count({.positions = row, .radii = radii, .queries = queries, .query_radii = query_radii}) == 2);
  HOLDS(context.count({.positions = row, .cutoff = 1.5, .queries = std::vector<float>()}) == 0);
  HOLDS(context.count(
            {.positions = row, .cutoff = 1.5, .offsets = two_systems, .queries = far, .query_offsets = a_query_each}) ==
        1);

  std::vector<Box> boxes = {Box::orthogonal(5, 1, 1), Box::orthogonal(5, 1, 1)};
  boxes[0].periodic = boxes[1].periodic = {true, false, false};
  HOLDS(context.count({.positions = row, .cutoff = 1.5, .box = boxes[0], .half = true}) == 3);
  HOLDS(context.count({.positions = row, .cutoff = 2.5, .boxes = boxes, .offsets = two_systems, .half = true}) == 3);
  boxes[1].rows[0][0] = 6;
  HOLDS(context.count({.positions = row, .cutoff = 2.5, .boxes = boxes, .offsets = two_systems, .half = true}) == 2);
}

static void columns(Context& context) {
  const Problem problem{.positions = row, .cutoff = 1.5, .box = Box::orthogonal(5, 50, 50), .half = true};
  PairList list = context.list(problem);
  HOLDS(list.size() == 3 && list.shifts().empty() && list.vectors().empty() && list.offsets().empty());
  list = context.list(problem, SP_SHIFTS | SP_VECTORS | SP_DISTANCES | SP_OFFSETS);
  HOLDS(ids(list.first()) == Ids({0, 0, 1}) && ids(list.second()) == Ids({1, 3, 2}));
  HOLDS(list.shifts()[1] == (std::array{-1, 0, 0}) && list.vectors()[1] == (std::array{-1.0, 0.0, 0.0}));
  HOLDS(list.distances()[2] == 1 && list.offsets().size() == 5 && list.offsets()[1] == 2);

  Ids first(3), second(3);
  std::vector<std::array<int32_t, 3>> shifts(3);
  std::vector<std::array<double, 3>> vectors(3);
  std::vector<double> distances(3);
  std::vector<int64_t> offsets(5);
  HOLDS(context.fill(problem, {first, second, shifts, vectors, distances, offsets}) == 3);
  HOLDS(first == ids(list.first()) && second == ids(list.second()) && std::ranges::equal(shifts, list.shifts()));
  HOLDS(std::ranges::equal(vectors, list.vectors()) && std::ranges::equal(distances, list.distances()));
  HOLDS(std::ranges::equal(offsets, list.offsets()));

  HOLDS(context.fill(problem, {}) == 3);
  std::vector<double> none;
  HOLDS(fails(SP_E_CAPACITY, "distances has 0 rows", [&] { context.fill(problem, {.distances = none}); }));
  try {
    context.fill(problem, {.first = std::span(first).first(2)});
    HOLDS(false);
  } catch (const CapacityError& error) {
    HOLDS(error.needed() == 3);
  }
}

static void errors(Context& context) {
  const std::vector<double> seven(7), infinite = {0, 0, HUGE_VAL};
  const std::vector<Box> boxes(1);
  HOLDS(fails(SP_E_ARGUMENT, "7 numbers", [&] { context.count({.positions = seven, .cutoff = 1}); }));
  HOLDS(fails(SP_E_NONFINITE, "positions[0].z", [&] { context.list({.positions = infinite, .cutoff = 1}); }));
  HOLDS(fails(SP_E_ARGUMENT, "radii has 0 rows",
              [&] { context.count({.positions = row, .radii = std::vector<double>()}); }));
  HOLDS(fails(SP_E_ARGUMENT, "box and boxes",
              [&] { context.count({.positions = row, .box = boxes[0], .boxes = boxes}); }));
  HOLDS(fails(SP_E_ARGUMENT, "gpu", [] { Context("gpu"); }));
  HOLDS(fails(SP_E_ARGUMENT, "device", [] { Context("cpu", "0"); }));
}

void checkpoints_and_images(Simulation& simulation) {
  HOLDS(simulation.spheres() == 3);
  const std::vector<std::byte> saved = simulation.save();
  Simulation resumed = Simulation::resume(saved, "cpu");
  HOLDS(resumed.steps() == simulation.steps() && resumed.spheres() == 3);
  simulation.move(20), resumed.move(20);
  HOLDS(resumed.state().positions == simulation.state().positions && resumed.save() == simulation.save());
  HOLDS(fails(SP_E_ARGUMENT, "cut off", [&] { Simulation::resume(std::span(saved).first(99), "cpu"); }));
  HOLDS(fails(SP_E_ARGUMENT, "cannot read", [] { Simulation::resume("/no/such/file", "cpu"); }));
  HOLDS(fails(SP_E_ARGUMENT, "cannot write", [&] { simulation.save("/no/such/file"); }));
  const Drawing view = {
      .eye = {{2, 1, 6}}, .target = {{1, 1, 0}}, .color = "speed", .color_range = {{0, 3}}, .samples = 2};
  const std::vector<uint8_t> image = resumed.draw(16, 12, view);
  HOLDS(image.size() == 16 * 12 * 4 && image[3] == 255 && image == simulation.draw(16, 12, view));
  std::vector<uint8_t> wider(12 * 100, 7);
  resumed.draw(wider.data(), 16, 12, 100, view);
  HOLDS(wider[64] == 7 && std::equal(image.end() - 64, image.end(), wider.end() - 100));
  HOLDS(fails(SP_E_ARGUMENT, "1 to 16384", [&] { resumed.draw(1 << 30, 1 << 30); }));
  HOLDS(fails(SP_E_ARGUMENT, "1 to 16384", [&] { resumed.draw(-1, 5); }));
  HOLDS(fails(SP_E_ARGUMENT, "no data", [&] { resumed.draw(nullptr, 16, 12, 64); }));
  HOLDS(fails(SP_E_ARGUMENT, "azimuth is given", [&] { resumed.draw(8, 8, {.eye = {{1, 1, 1}}, .azimuth = 5}); }));
}

void simulations() {
  const std::vector<std::array<double, 3>> positions = {{0, 1, 0}, {0, 1.75, 0}, {4, 3, 0}}, velocities(3, {0.5, 0, 0});
  const std::vector<double> radii = {0.5, 0.5, 0.25};
  Simulation first({.positions = positions, .velocities = velocities, .radii = radii}, "cpu", "", 1);
  HOLDS(first.pairs().size() == 1 && first.pairs().second()[0] == 1);
  Simulation moving = std::move(first);
  moving.move(), moving.move(2);
  HOLDS(moving.steps() == 3 && moving.dt() == 1.0 / 64);
  const auto [at, speeds] = moving.state();
  HOLDS(at.size() == 3 && at[2][0] == 4 + 0.5f * 3 / 64 && speeds[2][0] == 0.5f);
  const Scene walled = {.positions = positions,
                        .radii = radii,
                        .restitution = 0.5,
                        .contact = "spring",
                        .walls = Walls{{-1, 0, -1}, {5, 5, 1}}};
  Simulation contacts(walled, "cpu");
  contacts.move(10);
  HOLDS(contacts.state().velocities[1][1] > 0);
  checkpoints_and_images(contacts);
  Scene around = walled;
  around.walls = Walls{{-2, 0, -2}, {5, 5, 2}, {true, false, true}};
  HOLDS(Simulation(around, "cpu").pairs().size() == 1);
  around.walls->high[2] = 0.05;
  HOLDS(fails(SP_E_ARGUMENT, "must be longer than", [&] { Simulation(around, "cpu"); }));
  HOLDS(fails(SP_E_ARGUMENT, "glue",
              [&] { Simulation({.positions = positions, .radii = radii, .contact = "glue"}, "cpu"); }));
  HOLDS(fails(SP_E_ARGUMENT, "radii has 2 rows", [&] {
    const std::vector<double> two = {1, 1};
    Simulation({.positions = positions, .radii = two}, "cpu");
  }));
}

int main() try {
  Context opened("cpu", "", 1), context = std::move(opened);
  HOLDS(context.backend() == "cpu" && !context.device().empty());
  views(context);
  fields(context);
  columns(context);
  errors(context);
  simulations();
} catch (const std::exception& error) {
  std::fprintf(stderr, "an error that is none: %s\n", error.what());
  return 1;
}
