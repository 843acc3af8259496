// SPDX-License-Identifier: MIT
#include "bench/run/run_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "bench/check/contact_statistics.h"
#include "bench/io/numbers.h"
#include "bench/output/sphere_output.h"
#include "common/files/file_bytes.h"
#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

bool has_bytes(const std::string& file) {
  std::error_code error;
  return std::filesystem::is_regular_file(file, error) && std::filesystem::file_size(file, error) > 0;
}

uint64_t last_step_of(std::string_view rows) {
  const size_t start = rows.find_last_of('\n', rows.size() - 2) + 1;
  return whole_number_of(rows.substr(start, rows.find(',', start) - start), 0, UINT64_MAX).value_or(0);
}

}  // namespace

std::string first_rows(const RunOptions& options, const Start& start, const std::string& row, uint64_t end) {
  const std::string& file = options.statistics_file;
  if (options.start.resume_file.empty() || !has_bytes(file)) return statistics_heading() + row;
  const FileBytes old(file);
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(fmt::format("{} {}: give --statistics another file, or remove this one", file, why));
  };
  if (!start.motion) refuse("has rows of the run before, and this one counts its steps from 0");
  const std::string_view rows = old.bytes();
  const size_t at = rows.find(fmt::format("\n{},", start.step));
  if (!rows.starts_with(statistics_heading()) || at == rows.npos)
    refuse(fmt::format("has no row of step {}, at which the checkpoint stands", start.step));
  if (!rows.substr(at + 1).starts_with(row)) refuse(fmt::format("has another row of step {}", start.step));
  if (const uint64_t last = last_step_of(rows); last > end)
    refuse(fmt::format("has rows up to step {}, and this run ends at step {}", last, end));
  return std::string(rows.substr(0, at + 1)) + row;
}

std::string trajectory_frame(const Scene& scene, const Motion::State& state, uint64_t step) {
  const std::string keys = fmt::format(" step={} time={}", step, double(step) * double(scene.dt));
  return xyz_frame(state.positions, state.velocities, box_of(scene), keys);
}

void check_trajectory(const RunOptions& options) {
  const std::string& file = options.trajectory_file;
  check_xyz_output("--trajectory", file);
  if (!options.start.resume_file.empty() && has_bytes(file))
    throw std::invalid_argument(fmt::format(
        "{} has frames already, which a run from a checkpoint would replace: give --trajectory another file", file));
}

}  // namespace spherepair
