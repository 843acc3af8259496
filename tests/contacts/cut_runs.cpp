// SPDX-License-Identifier: MIT
#include "tests/contacts/cut_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>

#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

constexpr uint64_t rows_every = 7;  // steps

class Placement {
 public:
  explicit Placement(const DrawnRun& run) : run_(run), random_(run.seed) {
    scene_ = {.name = "drawn", .gravity = run.gravity, .restitution = float(run.restitution)};
  }

  // The first two have the smallest and the largest radius.
  Scene place() {
    if (run_.squeezed) place_squeezed();
    for (uint64_t i = scene_.size(); i < run_.n; ++i)
      place_sphere(float(0.5 * std::pow(run_.ratio, i == 0 ? 0 : i == 1 ? 1 : uniform(0, 1))));
    scene_.equal_radii = run_.ratio == 1;
    float lowest = INFINITY;
    for (const vec4& s : scene_.positions) lowest = std::min(lowest, s.y - s.w);
    scene_.plane = lowest - float(run_.fall > 0 ? 1000 : uniform(0, 0.01));
    return std::move(scene_);
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  void place_squeezed() {
    const float small = 0.5f, large = float(0.5 * run_.ratio), speed = float(0.5 * run_.ratio * uniform(0.5, 1));
    scene_.positions = {{0, 0, 0, small}, {small + large, 0, 0, large}, {-small - large, 0, 0, large}};
    scene_.velocities = {{}, {-speed, 0, 0, 0}, {speed, 0, 0, 0}};
  }

  // Next to one that is there, in any direction, a little apart from all; left out where there is no room.
  void place_sphere(float radius) {
    for (int attempt = 0; attempt < 50; ++attempt) {
      const auto near_0 = [&] { return float(std::ldexp(uniform(-1, 1), -int(random_() % 40))); };
      vec4 at = {near_0(), near_0(), near_0(), radius};
      if (!scene_.positions.empty()) {
        const vec4& next = scene_.positions[random_() % scene_.size()];
        const double height = uniform(-1, 1), angle = uniform(0, 6.2831853), around = std::sqrt(1 - height * height);
        const double distance = double(next.w + radius) * uniform(0.998, 1.02);
        at.x = next.x + float(distance * around * std::cos(angle));
        at.y = next.y + float(distance * height);
        at.z = next.z + float(distance * around * std::sin(angle));
      }
      if (!has_room(at)) continue;
      const double speed = 0.5 * run_.ratio * uniform(0, 2);
      const auto along = [&] { return float(speed * uniform(-1, 1)); };
      scene_.positions.push_back(at);
      scene_.velocities.push_back({along(), along(), along(), 0});
      return;
    }
  }
  bool has_room(const vec4& at) const {
    for (const vec4& s : scene_.positions)
      if (std::hypot(at.x - s.x, at.y - s.y, at.z - s.z) < 0.997f * (at.w + s.w)) return false;
    return true;
  }

  const DrawnRun& run_;
  std::mt19937_64 random_;
  Scene scene_;
};

// Rows of a step that both parts of a cut run have must be the same.
void keep_rows(const std::vector<ContactStatistics>& rows, RunEnd& end) {
  for (const ContactStatistics& row : rows) {
    const auto [at, is_new] = end.rows.try_emplace(row.step, statistics_row(row));
    if (!is_new && at->second != statistics_row(row)) at->second += "and, where it goes on, " + statistics_row(row);
  }
}

std::string state_difference(const Motion::State& a, const Motion::State& b) {
  const auto same = [](const auto& left, const auto& right) {
    return std::ranges::equal(std::as_bytes(std::span(left)), std::as_bytes(std::span(right)));
  };
  if (a.wide != b.wide) {
    const auto first = std::ranges::mismatch(a.wide, b.wide).in1 - a.wide.begin();
    return fmt::format("word {} of the wide state differs", first);
  }
  if (!same(a.positions, b.positions)) return "positions differ";
  return same(a.velocities, b.velocities) ? "" : "velocities differ";
}

}  // namespace

std::string describe(const DrawnRun& r) {
  return fmt::format(
      "seed {}, {} spheres 1:{}, {} steps of {}, restitution {}, drag {} a step, softness {}, {} steps a contact, "
      "gravity {}, fall {}{}{}{}",
      r.seed, r.n, r.ratio, r.steps, contact_name(r.law), r.restitution, r.drag_a_step, r.softness, r.steps_a_contact,
      r.gravity, r.fall, r.squeezed ? ", squeezed" : "", r.walls ? ", walls" : "", r.sleeping ? "" : ", no sleeping");
}

std::optional<Scene> scene_of(const DrawnRun& run) try {
  Scene scene = Placement(run).place();
  choose_contacts(scene, {.law = run.law, .walls = run.walls});
  const float stiffness = float(double(scene.contact.stiffness) / run.softness);
  choose_contacts(scene, {.law = run.law, .stiffness = stiffness});
  const float dt = float(contact_time(scene) / run.steps_a_contact);
  choose_contacts(scene, {.law = run.law,
                          .stiffness = stiffness,
                          .dt = dt,
                          .drag = float(run.drag_a_step / double(dt)),
                          .sleeping = run.sleeping});
  if (run.fall > 0) scene.gravity = float(-run.fall * 0.5 / (double(dt) * double(dt)));
  if (!why_unmovable(scene).empty()) return {};
  return scene;
} catch (const std::invalid_argument&) {
  return {};
}

FastFolder::FastFolder() {
  const std::filesystem::path memory = "/dev/shm";
  const auto root = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
  std::string made = (root / "spherepair-XXXXXX").string();
  if (!::mkdtemp(made.data())) throw std::runtime_error("cannot make a folder in " + root.string());
  folder_ = made;
}

FastFolder::~FastFolder() {
  std::error_code error;
  std::filesystem::remove_all(folder_, error);
}

RunEnd run_with_cuts(const Scene& scene, uint64_t steps, std::span<const uint64_t> cuts,
                     std::span<Backend* const> backends, const FastFolder& folder) {
  RunEnd end;
  Start start{.scene = scene, .label = scene.name, .notes = "", .record = {}};
  for (size_t part = 0; part <= cuts.size(); ++part) {
    Backend& backend = *backends[part % backends.size()];
    const bool last = part == cuts.size();
    RunOptions options;
    options.steps = (last ? steps : cuts[part]) - start.step;
    options.statistics_file = "/dev/null", options.statistics_every = rows_every;
    if (!last) options.save_file = folder.path("cut");
    RunTimes times;
    Run run(backend, options, start, {}, times);
    try {
      upload_start(start, backend);
      run.simulate();
    } catch (const std::invalid_argument& error) {
      end.failure = std::string(error.what()).substr(std::string(error.what()).find(": ") + 2);
      std::sscanf(end.failure.c_str(), "contacts cannot go on from step %lu", &end.failed_step);
    }
    keep_rows(run.statistics(), end);
    if (!end.failure.empty()) return end;
    if (last) {
      end.state = current_state(backend);
      end.saved = backend.save();
      continue;
    }
    StartOptions resumed;
    resumed.resume_file = options.save_file;
    start = start_of(resumed, 1);
  }
  return end;
}

std::string difference_of_ends(const RunEnd& cut, const RunEnd& whole) {
  if (cut.failure != whole.failure)
    return fmt::format("it ends with '{}', the uncut run with '{}'", cut.failure, whole.failure);
  for (const auto& [step, row] : whole.rows) {
    const auto at = cut.rows.find(step);
    if (at == cut.rows.end()) return fmt::format("it has no row of step {}", step);
    if (at->second != row) return fmt::format("its row is {}, that of the uncut run {}", at->second, row);
  }
  if (cut.saved.contact_steps != whole.saved.contact_steps) return "it counts other steps";
  return state_difference(cut.state, whole.state);
}

bool has_contacts(const RunEnd& end) {
  return std::ranges::any_of(end.rows, [](const auto& row) {
    std::vector<std::string> cells;
    std::istringstream line(row.second);
    for (std::string cell; std::getline(line, cell, ',');) cells.push_back(cell);
    return cells.at(9) != "0" || cells.at(10) != "0";  // contacts, wall_contacts
  });
}

}  // namespace spherepair
