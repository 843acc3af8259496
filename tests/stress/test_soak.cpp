// SPDX-License-Identifier: MIT
// Random spheres, motions and options on every backend that is there, against exact arithmetic, for as long as
// SPHEREPAIR_SOAK_SECONDS says. A failure names its seed; SPHEREPAIR_SOAK_SEED repeats it.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>

#include "common/shared/hash.h"
#include "tests/oracle/oracle.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

double number_from(const char* name, double otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atof(text) : otherwise;
}

class Dice {
 public:
  explicit Dice(uint64_t seed) : state_(splitmix64(seed)) {}
  uint64_t below(uint64_t end) { return (state_ = splitmix64(state_)) % end; }
  bool one_in(uint64_t n) { return below(n) == 0; }
  float between(float low, float high) { return low + (high - low) * float(below(1 << 24)) * 0x1p-24f; }
  template <typename T>
  T of(const std::vector<T>& choices) {
    return choices[below(choices.size())];
  }

 private:
  uint64_t state_;
};

struct Places {
  float side, step;  // of the box; coordinates are multiples of the step, 0: any
  vec4 offset;
  bool dense_centre;
};

Places random_places(Dice& dice, uint64_t n, float radius) {
  const float side = 2 * radius * std::cbrt(float(n + 1)) * dice.of<float>({0.02f, 0.5f, 1, 1.2f, 3, 50});
  const float far = dice.one_in(3) ? std::ldexp(radius, int(dice.below(30))) : 0;
  return {
      side, dice.one_in(3) ? 2 * radius / float(1 << dice.below(5)) : 0, {far, -far, far * 0.5f, 0}, dice.one_in(4)};
}

vec4 random_sphere(Dice& dice, const Places& places, float radius) {
  const auto coordinate = [&](float offset) {
    float x = dice.between(-places.side, places.side) * 0.5f;
    if (places.dense_centre) x = x * x * x / (places.side * places.side);
    if (places.step > 0) x = std::round(x / places.step) * places.step;
    return x + offset;
  };
  return {coordinate(places.offset.x), coordinate(places.offset.y), coordinate(places.offset.z), radius};
}

// Random spheres: equal or unequal radii, ties, dense centres, strays far away; at rest or moving.
Scene random_scene(Dice& dice) {
  const uint64_t n = dice.one_in(8) ? dice.below(3) : dice.one_in(4) ? dice.below(3000) : dice.below(700);
  const float radius = std::ldexp(dice.between(0.5f, 1), int(dice.below(41)) - 20);
  const float ratio = dice.one_in(2) ? 1 : std::ldexp(1.0f, int(dice.below(17)));
  const Places places = random_places(dice, n, radius);
  std::vector<vec4> spheres;
  for (uint64_t i = 0; i < n; ++i) {
    const float own = ratio == 1 ? radius : radius * std::pow(ratio, dice.between(-1, 0));
    spheres.push_back(random_sphere(dice, places, own));
    if (dice.one_in(200)) spheres.back().x = std::ldexp(spheres.back().x, int(dice.below(20)));
  }
  Scene scene = scene_of(std::move(spheres));
  scene.motion = dice.of(all_motions());
  scene.plane = places.offset.y - places.side;
  const float speed = dice.one_in(2) ? 0 : places.side * dice.of<float>({1, 10, 100});
  for (vec4& v : scene.velocities)
    v = {dice.between(-speed, speed), dice.between(-speed, speed), dice.between(-speed, speed), 0};
  return scene;
}

CollideOptions random_options(Dice& dice, const Backend& backend) {
  std::vector<Method> methods = backend.methods();
  for (int k = 0; k < 6; ++k) methods.push_back(Method::collide_grid);
  methods.push_back(Method::automatic);
  const std::vector<uint> blocks(block_sizes().begin(), block_sizes().end());
  CollideOptions options = {.method = dice.of(methods), .block = dice.of(blocks), .want_pairs = !dice.one_in(3)};
  const bool gpu_api = !backend.info().on_host, cuda = backend.info().name == "cuda";
  options.grid.cells = dice.of<Cells>({Cells::automatic, Cells::dense, Cells::hashed});
  options.grid.keep_order = dice.one_in(2);
  options.grid.keep_cells = dice.one_in(2);
  options.grid.replan = !dice.one_in(4);
  std::vector<Sort> sorts = {Sort::automatic, Sort::counting, Sort::buckets};
  if (cuda) sorts.push_back(Sort::radix);
  options.grid.sort = dice.of(sorts);
  options.load_radii = dice.one_in(4);
  options.api.graph = replays_steps(backend) && dice.one_in(2);
  if (options.method != Method::collide_grid) return options;
  options.filter = !dice.one_in(6);
  options.api.texture_table = backend.info().language == "GLSL" && dice.one_in(2);
  options.api.library_clear = gpu_api && dice.one_in(2);
  if (dice.one_in(2)) options.api.overlap = false;
  return options;
}

// One scene, a few moves and steps, all backends: what is wrong.
std::string why_invalid(uint64_t seed) {
  Dice dice(seed);
  const Scene scene = random_scene(dice);
  const std::vector<Backend*> backends = open_backends();
  for (Backend* backend : backends) backend->upload(scene);
  for (int turn = 0; turn < 3; ++turn) {
    const uint64_t moves = scene.size() == 0 ? 0 : dice.below(6);
    for (Backend* backend : backends)
      for (uint64_t k = 0; k < moves; ++k) backend->move();
    const Motion::State state = current_state(*backends.front());
    const uint64_t hash = state_hash(state.positions, state.velocities, state.wide);
    const std::vector<Pair> expected = swept_pairs(state.positions);
    for (Backend* backend : backends) {
      const Motion::State own = current_state(*backend);
      if (state_hash(own.positions, own.velocities, own.wide) != hash) return backend->info().name + ": another state";
      const CollideOptions options = random_options(dice, *backend);
      const auto wanted = options.method == Method::collide_group ? within_groups(expected, options.block) : expected;
      const std::string why = first_mismatch(run_step(*backend, options), wanted, scene.size());
      if (!why.empty())
        return fmt::format("{}, {} spheres, turn {}, {}: {}", backend->info().name, scene.size(), turn,
                           describe(options), why);
    }
  }
  return {};
}

TEST(Soak, RandomScenesAndOptionsOnEveryBackend) {
  const double seconds = number_from("SPHEREPAIR_SOAK_SECONDS", 5);
  const auto start = std::chrono::steady_clock::now();
  uint64_t seed = uint64_t(number_from("SPHEREPAIR_SOAK_SEED", 1));
  uint64_t done = 0;
  const auto elapsed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  for (; done == 0 || elapsed() < seconds; ++done, ++seed) {
    const std::string why = why_invalid(seed);
    ASSERT_EQ(why, "") << "repeat it with SPHEREPAIR_SOAK_SEED=" << seed << " SPHEREPAIR_SOAK_SECONDS=0";
  }
  fmt::print("{} scenes in {:.0f} s, the last of seed {}\n", done, elapsed(), seed - 1);
  RecordProperty("scenes", std::to_string(done));
}

}  // namespace
}  // namespace spherepair
