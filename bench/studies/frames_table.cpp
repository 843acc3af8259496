// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "bench/studies/frames_study.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

using Row = std::vector<std::string>;

bool is_transfer(const json& entry) { return entry.contains("transferred"); }

// The median where `keys` say, in a column of its own; appends the row if it is not there yet.
void put(Table& table, const Row& keys, size_t column, const json& entry) {
  const auto same = [&](const Row& row) { return std::ranges::equal(keys, std::span(row).first(keys.size())); };
  auto row = std::ranges::find_if(table.rows, same);
  if (row == table.rows.end()) {
    table.rows.push_back(keys);
    row = table.rows.end() - 1;
    row->resize(table.columns.size(), "-");
  }
  row->at(column) = format_number(entry.at("median_ms")) + (entry.contains("unsteady") ? unsteady_mark : "");
}

Table images_table(const json& frames, uint64_t n, const FramesOptions& options) {
  Table table{fmt::format("Drawing {} at {}x{}: median ms of an image, with `loop` and `view` of a whole step",
                          counted(n, "sphere"), options.width, options.height),
              {{"", "backend", "", true}, {"", "draw", "", true}, {"", "camera", "", true}},
              {},
              {"frame: each image from a new camera. frame_all: the same without culling or reuse. lit: with ambient "
               "occlusion, shadows and the ground. loop: move, collide_grid and frame. view: the same, each complete. "
               "-: not timed."}};
  for (const std::string& work : options.works) table.columns.push_back({"", work, ""});
  for (const json& entry : frames) {
    if (entry.at("n") != n || is_transfer(entry)) continue;
    const auto work = std::ranges::find(options.works, entry.at("work").get<std::string>());
    put(table, {entry.at("backend"), entry.at("draw"), entry.at("place")}, 3 + size_t(work - options.works.begin()),
        entry);
  }
  return table;
}

// A transfer alone (draw: none), with its image, and in a loop that overlaps it with the next step.
Table transfers_table(const json& frames, uint64_t n) {
  Table table{"The same of CUDA's spheres through OpenGL, by how they come there: median ms",
              {{"", "draw", "", true}},
              {},
              {"pipelined: transfer, image and the next step, where only the transfer waits."}};
  for (const json& entry : frames) {
    if (entry.at("n") != n || !is_transfer(entry)) continue;
    const std::string work = entry.at("work"), transfer = work.substr(0, work.find("_pipelined"));
    const Column column{transfer == "step" ? "" : transfer,
                        transfer == work ? work == "step" ? "step" : "alone" : "pipelined", ""};
    const auto same = [&](const Column& one) { return one.group == column.group && one.name == column.name; };
    const auto found = std::ranges::find_if(table.columns, same);
    const size_t at = size_t(found - table.columns.begin());
    if (found == table.columns.end()) {
      table.columns.push_back(column);
      for (Row& row : table.rows) row.push_back("-");
    }
    put(table, {entry.at("draw")}, at, entry);
  }
  return table;
}

}  // namespace

std::string FramesStudy::text_of(uint64_t n) const {
  Table images = images_table(frames, n, options_);
  for (const json& one : left_out) {
    const std::string note = fmt::format("left out: {} {}: {}", one.at("backend").get<std::string>(),
                                         one.at("draw").get<std::string>(), one.at("reason").get<std::string>());
    if (one.at("n") == n && std::ranges::find(images.notes, note) == images.notes.end()) images.notes.push_back(note);
  }
  const Table transfers = transfers_table(frames, n);
  return images.text() + (transfers.rows.empty() ? "" : "\n" + transfers.text());
}

}  // namespace spherepair
