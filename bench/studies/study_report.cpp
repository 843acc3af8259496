// SPDX-License-Identifier: MIT
#include "bench/studies/study_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/formats/files.h"

namespace spherepair {
namespace {

// Fields of entries that tell a configuration, in the order of their columns.
constexpr const char* key_names[] = {
    "measurement", "work",   "kind",     "scene",  "n",      "order", "law",         "restitution", "steps_a_contact",
    "sums",        "steps",  "sleeping", "motion", "method", "block", "exact",       "precision",   "k",
    "option",      "on",     "path",     "way",    "draw",   "place", "transferred", "to",          "launches_per_step",
    "contender",   "backend"};

using Fields = std::map<std::string, std::string>;

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == text.npos) return text;
  std::string out = "\"";
  for (const char letter : text) out += letter == '"' ? "\"\"" : std::string(1, letter);
  return out + "\"";
}

std::string field_of(const json& value) {
  return value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump();
}

// random, aligned 8x16
std::string scene_field(const json& scene) {
  std::string text = scene.at("name");
  if (scene.at("groups") != 0) text += fmt::format(" {}x{}", scene.at("groups").dump(), scene.at("group_size").dump());
  return text;
}

void add_keys(Fields& keys, const json& entry) {
  for (const char* name : key_names)
    if (entry.contains(name) && entry.at(name).is_primitive()) keys[name] = field_of(entry.at(name));
  if (entry.contains("label")) keys["contender"] = entry.at("label");
  if (entry.contains("scene") && entry.at("scene").is_object()) keys["scene"] = scene_field(entry.at("scene"));
}

void add_samples(std::vector<Fields>& rows, const Fields& keys, const json& entry) {
  const auto seconds_of = [](const json& ms) { return fmt::format("{:.9g}", ms.get<double>() * 1e-3); };
  const json& samples = entry.at("samples_ms");
  for (size_t k = 0; k < samples.size(); ++k) {
    Fields& row = rows.emplace_back(keys);
    row.insert({{"timer", "host"}, {"round", std::to_string(k + 1)}, {"seconds", seconds_of(samples[k])}});
    if (entry.contains("turns")) row["turn"] = field_of(entry.at("turns").at(k));
    if (entry.contains("batch")) row["batch"] = field_of(entry.at("batch"));
  }
  if (!entry.contains("device_stages_ms")) return;
  for (const auto& [kernel, ms] : entry.at("device_stages_ms").items())
    rows.emplace_back(keys).insert({{"timer", "device"}, {"kernel", kernel}, {"seconds", seconds_of(ms)}});
}

void collect(std::vector<Fields>& rows, Fields keys, const json& node) {
  if (node.is_object()) add_keys(keys, node);
  if (node.is_object() && node.contains("samples_ms")) return add_samples(rows, keys, node);
  if (!node.is_structured()) return;
  for (const json& child : node) collect(rows, keys, child);
}

std::vector<Fields> rows_of(const json& records) {
  std::vector<Fields> rows;
  if (records.is_array())
    collect(rows, {}, records);
  else
    for (const auto& [name, list] : records.items()) collect(rows, {{"measurement", name}}, list);
  return rows;
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::vector<std::string> all;
  for (const std::string& field : fields) all.push_back(quoted(field));
  return fmt::format("{}\n", fmt::join(all, ","));
}

}  // namespace

std::string time_cell(const json& entry, double in_second) {
  return time_cell(entry.at("samples_ms").get<std::vector<double>>(), in_second / in_ms, !entry.contains("unsteady"));
}

std::string samples_csv(const json& records) {
  const std::vector<Fields> rows = rows_of(records);
  std::vector<std::string> names;
  for (const char* name : key_names)
    if (std::ranges::any_of(rows, [&](const Fields& row) { return row.contains(name); })) names.push_back(name);
  names.insert(names.end(), {"timer", "kernel", "round", "turn", "batch", "seconds"});
  std::string text = csv_line(names);
  for (const Fields& row : rows) {
    std::vector<std::string> fields;
    for (const std::string& name : names) fields.push_back(row.contains(name) ? row.at(name) : "");
    text += csv_line(fields);
  }
  return text;
}

std::string csv_of(const Table& table) {
  std::vector<std::string> names;
  for (const Column& column : table.columns)
    names.push_back(column.group + (column.group.empty() || column.name.empty() ? "" : " ") + column.name);
  std::string text = csv_line(names);
  for (const std::vector<std::string>& row : table.rows) text += csv_line(row);
  return text;
}

std::string text_of(const std::vector<Table>& tables, size_t width) {
  std::vector<std::string> texts;
  for (const Table& table : tables)
    if (!table.only_in_csv) texts.push_back(table.text(width));
  return fmt::to_string(fmt::join(texts, "\n"));
}

void write_page(const std::filesystem::path& folder, const std::string& name, const Page& page,
                const std::string& csv) {
  write_file(folder / (name + ".txt"), page(kFileWidth));
  write_file(folder / (name + ".csv"), csv);
}

void report_page(const std::filesystem::path& folder, const std::string& name, const Page& page, const json& records) {
  fmt::print("{}", page(kTextWidth));
  write_page(folder, name, page, samples_csv(records));
}

std::vector<std::string> files_of_study(const std::string& name) {
  return {name + ".json", name + ".txt", name + ".csv"};
}

}  // namespace spherepair
