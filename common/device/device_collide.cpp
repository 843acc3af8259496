// SPDX-License-Identifier: MIT
// The collision step of DeviceBackend: slices, lists that grow, totals.
#include <fmt/format.h>

#include <algorithm>

#include "common/backend/checks.h"
#include "common/backend/method_choice.h"
#include "common/device/device_backend.h"

namespace spherepair {
namespace {

constexpr uint resolve_groups = 64, tally_groups = 1024;
constexpr uint64_t pairs_per_dispatch = uint64_t(1) << 40;

uint64_t ceil_div(uint64_t a, uint64_t b) { return (a + b - 1) / b; }

// Groups of collide_triangle should outnumber the multiprocessors many times, yet each should meet enough spheres to
// pay for loading its rows. In software groups come one after another.
uint64_t default_columns(uint64_t n, bool software) {
  return std::clamp<uint64_t>(ceil_div(n, 2048) * 8, software ? 64 : 8, 4096);
}

// What the first row group of collide_triangle and the last have to meet, as much as any two mirrored, or the only one.
uint64_t columns_of_line(uint64_t n, uint64_t row_groups, uint64_t rows) {
  return row_groups == 1 ? n : 2 * n - (row_groups - 1) * rows;
}

uint64_t join(const uint* words) { return uint64_t(words[1]) << 32 | words[0]; }

}  // namespace

// How the spheres are cut into groups for this method: how many groups, and how many spheres each meets.
DeviceBackend::Division DeviceBackend::division() const {
  const uint64_t n = std::max<uint64_t>(n_, 1), block = options_.block;
  switch (options_.method) {
    case Method::collide_group:
      return {Kernel::collide_group, block, block};
    case Method::collide_tiled:
      return {options_.swept ? Kernel::collide_swept : Kernel::collide_tiled, block, n};
    case Method::collide_square:
      return {Kernel::collide_square, block, n};
    case Method::collide_triangle:
      return {Kernel::collide_triangle, block * SPHERES_PER_THREAD, n};
    default:
      throw std::invalid_argument(
          fmt::format("{}: the method {} runs on the backend cpu only", info().name, method_name(options_.method)));
  }
}

// A driver may stop work that keeps the device for many seconds, so a large dispatch goes out in slices of about a
// second, each waited for; each also stays within MAX_GROUPS.
void DeviceBackend::launch_collide() {
  const Division cut = division();
  const bool mirrored = cut.kernel == Kernel::collide_triangle;  // two row groups make up one line of the launch
  const uint64_t row_groups = ceil_div(std::max<uint64_t>(n_, 1), cut.spheres);
  const uint64_t groups = mirrored ? ceil_div(row_groups, 2) : row_groups;
  const uint64_t slice = std::clamp<uint64_t>(pairs_per_dispatch / (cut.spheres * cut.meets), 1, MAX_GROUPS);
  for (uint64_t first = 0; first < groups; first += slice) {
    const uint part = uint(std::min(slice, groups - first));
    Launch launching{cut.kernel, options_.block, variant_, {part, 1, 1}};
    if (cut.kernel == Kernel::collide_square) {
      launching.groups = {part, uint(std::min<uint64_t>(groups, MAX_GROUPS)), uint(ceil_div(groups, MAX_GROUPS))};
    } else if (mirrored) {
      const uint64_t columns = columns_of_line(n_, row_groups, cut.spheres), least = ceil_div(columns, MAX_GROUPS - 1);
      params_.columns_per_group = uint(std::clamp<uint64_t>(params_.columns_per_group, least, n_));
      launching.groups = {uint(ceil_div(columns, params_.columns_per_group) + 1), part, 1};
    }
    params_.first_group = uint(first);
    launch(launching, params_);
    if (groups > slice) finish();
  }
  params_.first_group = 0;
}

void DeviceBackend::collide(const CollideOptions& options) {
  require_scene("collide");
  if (std::ranges::find(block_sizes(), options.block) == block_sizes().end()) {
    throw std::invalid_argument(
        fmt::format("group size {} is not one of {}", options.block, fmt::join(block_sizes(), ", ")));
  }
  check_collide(options);
  check_api_options(options);
  options_ = options;
  options_.method = chosen_method(info(), n_, plans_, options);
  prepare_positions();
  if (replan_if_needed(options)) options_.method = chosen_method(info(), n_, plans_, options);
  options_.block = chosen_block(info(), n_, options_.method, options);
  run_collide();
  collided_ = true;
}

// Some spheres from all over the scene; all where that is not many more.
std::vector<vec4> DeviceBackend::sample_positions() {
  constexpr uint64_t size = 1 << 16;
  std::vector<vec4> sample(std::min(n_, size));
  if (n_ > size) {
    if (bytes_[SLOT_SPLIT] < size * sizeof(vec4)) make_buffer(SLOT_SPLIT, size * sizeof(vec4));
    launch({Kernel::sample, SERVICE_BLOCK, {}, folded(size / SERVICE_BLOCK), Order::scene, Order::buckets}, params_);
  }
  read(n_ > size ? SLOT_SPLIT : SLOT_POSITION, sample.data(), 0, sample.size() * sizeof(vec4));
  return sample;
}

// The host's copy of the spheres is that of the upload, so some are read back, which the watch keeps rare.
bool DeviceBackend::replan_if_needed(const CollideOptions& asked) {
  const bool may_use_grid = asked.method == Method::collide_grid ||
                            (asked.method == Method::automatic && may_take_grid(crossover_of(info()), n_));
  if (!asked.grid.replan || !may_use_grid || !watch_.needed()) return false;
  const std::vector<vec4> sample = sample_positions();
  if (!watch_.worthwhile(sample, plans_) || !watch_.replan(sample, n_, plans_)) return false;
  ++work_.plans;
  planned_.reset();
  return true;
}

MethodChoice DeviceBackend::choice(const CollideOptions& options) const {
  require_scene("choice");
  return explain_choice(info(), n_, plans_, options);
}

void DeviceBackend::run_collide() {
  clustered_.reset();
  image_current_ = false;
  ++work_.steps;
  params_ = constants_[options_.exact];
  if (!options_.filter) leave_all_undecided(params_);
  variant_.equal_radii = equal_radii_ && !options_.load_radii;
  params_.n = uint(n_);
  params_.in_cells = params_.totals_later = 0;
  tallied_ = false;
  params_.columns_per_group = options_.columns ? options_.columns : uint(default_columns(n_, info().software));
  variant_.listed = options_.want_pairs;
  work_.without_radii += variant_.equal_radii;
  work_.lists += variant_.listed;
  params_.pair_capacity = options_.want_pairs ? uint(bytes_[SLOT_PAIR] / sizeof(uvec2)) : 0;
  params_.deferred_capacity = uint(bytes_[SLOT_DEFERRED] / sizeof(uvec2));
  const bool grid = options_.method == Method::collide_grid && n_ >= 2;
  search_decides_ = grid && plans_.plan(options_.grid.cells).cells == Cells::dense;
  resolved_ = true;
  if (!grid) {  // results are not in cell order now
    order_ = Order::scene;
    cells_built_ = false;
  }
  begin_step(options_.api);
  if (!cleared_ && !grid) launch_clear(Order::scene);
  if (n_ >= 2) {
    grid ? launch_grid() : launch_collide();
    cleared_ = false;
    counts_sorted_ = order_ == Order::cells;
    resolved_ = !options_.exact;
    if (resolved_in_step_.contains(search())) resolve_undecided();
  }
  end_step();
}

// Decides what was deferred, of which there is hardly ever anything: so it waits until a picture is drawn, or results
// are asked for and a pair is left; from then on it comes with every step of that search.
void DeviceBackend::resolve_undecided() {
  if (resolved_) return;
  launch({Kernel::resolve_undecided, SERVICE_BLOCK, variant_, {resolve_groups, 1, 1}, order_}, params_);
  resolved_ = true;
}

std::vector<uint> DeviceBackend::read_summary() {
  std::vector<uint> words(SUMMARY_SLOTS * SUMMARY_WORDS);
  read(SLOT_SUMMARY, words.data(), 0, words.size() * sizeof(uint));
  return words;
}

bool DeviceBackend::grow_lists(uint64_t deferred, uint64_t listed) {
  const bool short_deferred = deferred > params_.deferred_capacity;
  const bool short_pairs = options_.want_pairs && listed > params_.pair_capacity;
  if (short_deferred) make_buffer(SLOT_DEFERRED, (deferred + deferred / 8) * sizeof(uvec2));
  if (short_pairs) make_buffer(SLOT_PAIR, (listed + listed / 8) * sizeof(uvec2));
  return short_deferred || short_pairs;
}

// The summary of a step whose lists had room for all, and whose pairs are all decided.
std::vector<uint> DeviceBackend::finished_summary() {
  if (!collided_)
    throw BackendError(
        fmt::format("{}: no collision step to report since the last move; call collide first", info().name));
  std::vector<uint> words = read_summary();
  const bool left = words[SUM_DEFERRED] != 0;
  if (options_.exact && !left) resolved_in_step_.erase(search());
  if (options_.exact && left) resolved_in_step_.insert(search());
  if (left && !resolved_) {
    resolve_undecided();
    words = read_summary();
  }
  while (grow_lists(words[SUM_DEFERRED], words[SUM_LISTED])) {
    run_collide();
    words = read_summary();
  }
  return words;
}

Collisions DeviceBackend::collisions() {
  if (params_.totals_later && collided_) {
    options_.want_totals = true;
    run_collide();
  }
  std::vector<uint> words = finished_summary();
  if (!tallied_) {
    launch({Kernel::tally, SERVICE_BLOCK, {}, {tally_groups, 1, 1}, order_}, params_);
    tallied_ = true;
    words = read_summary();
  }
  Collisions total;
  for (uint row = 0; row < SUMMARY_SLOTS; ++row) {
    const uint* sum = &words[row * SUMMARY_WORDS];
    total.pairs += join(sum + SUM_PAIRS);
    total.fingerprint.a += join(sum + SUM_MIX_A);
    total.fingerprint.b += join(sum + SUM_MIX_B);
    total.colliding_spheres += join(sum + SUM_COLLIDING);
    for (uint stage = 0; stage < STAGES; ++stage) total.decided_by[stage] += sum[SUM_STAGE + stage];
    total.deferred += sum[search_decides_ ? SUM_UNDECIDED : SUM_DEFERRED];
  }
  return total;
}

}  // namespace spherepair
