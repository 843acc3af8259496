// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "bench/studies/frames_study.h"
#include "bench/studies/study_report.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

using Row = std::vector<std::string>;

bool is_transfer(const json& entry) { return entry.contains("transferred"); }

// Puts a time into the row of `keys` and the column of this name; appends a missing row or column.
void put(Table& table, const Row& keys, const Column& column, const json& entry) {
  auto at = std::ranges::find(table.columns, column.name, &Column::name);
  if (at == table.columns.end()) {
    for (Row& row : table.rows) row.push_back("-");
    at = table.columns.insert(at, column);
  }
  const auto same = [&](const Row& row) { return std::ranges::equal(keys, std::span(row).first(keys.size())); };
  auto row = std::ranges::find_if(table.rows, same);
  if (row == table.rows.end()) row = table.rows.insert(row, keys);
  row->resize(table.columns.size(), "-");
  row->at(size_t(at - table.columns.begin())) = time_cell(entry);
}

// A row for each work, a column for each backend.
Table images_table(const json& frames, uint64_t n, const FramesOptions& options) {
  Table table{fmt::format("Drawing {} at {}x{}: an image, with `loop` a whole step", counted(n, "sphere"),
                          options.width, options.height),
              {{"", "draw", "", true}, {"", "camera", "", true}, {"", "work", "", true}},
              {},
              {"frame: each image from a new camera. frame_all: the same without culling or reuse. lit: with ambient "
               "occlusion, shadows and the ground. loop: move, collide_grid and frame. -: not timed."}};
  for (const json& entry : frames)
    if (entry.at("n") == n && !is_transfer(entry))
      put(table, {entry.at("draw"), entry.at("place"), entry.at("work")}, {"median", entry.at("backend"), "ms"}, entry);
  return table;
}

// Times of a transfer alone (draw: none), with its image, and in a loop that overlaps it with the next step.
Table transfers_table(const json& frames, uint64_t n) {
  Table table{"Spheres of one API in another, by how they come there",
              {{"", "from", "", true}, {"", "to", "", true}, {"", "draw", "", true}, {"", "transfer", "", true}},
              {},
              {"alone, none: 20 bytes a sphere to OpenGL, with its contacts; 16 else. pipelined: transfer, image and "
               "the next step, "
               "where only the transfer waits. step: without a transfer."}};
  for (const json& entry : frames) {
    if (entry.at("n") != n || !is_transfer(entry)) continue;
    const std::string work = entry.at("work"), transfer = work.substr(0, work.find("_pipelined"));
    put(table, {entry.at("backend"), entry.at("to"), entry.at("draw"), transfer},
        {"median", transfer == work ? "alone" : "pipelined", "ms"}, entry);
  }
  return table;
}

}  // namespace

std::string FramesStudy::text_of(uint64_t n, size_t width) const {
  std::vector<Table> tables = {images_table(frames, n, options_)};
  std::vector<std::string>& notes = tables.front().notes;
  for (const json& one : left_out) {
    const std::string note = fmt::format("left out: {} {}: {}", one.at("backend").get<std::string>(),
                                         one.at("draw").get<std::string>(), one.at("reason").get<std::string>());
    if (one.at("n") == n && std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
  }
  if (Table transfers = transfers_table(frames, n); !transfers.rows.empty()) tables.push_back(std::move(transfers));
  return spherepair::text_of(tables, width);
}

}  // namespace spherepair
