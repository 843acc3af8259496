// SPDX-License-Identifier: MIT
#include "bench/check/equality.h"

#include <fmt/format.h>

#include "bench/io/scene_text.h"
#include "common/files/file_bytes.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

// The value at `path` in the file, such as equality/3/scene; its accessors check its type.
class Node {
 public:
  Node(const json& value, std::string path) : value_(value), path_(std::move(path)) {}

  Node at(const std::string& key) const {
    if (!value_.is_object() || !value_.contains(key)) fail(fmt::format("the key '{}'", key));
    return {value_.at(key), path_ + "/" + key};
  }
  std::vector<Node> elements() const {
    if (!value_.is_array() || value_.empty()) fail("a list with at least one element");
    std::vector<Node> all;
    for (const json& element : value_) all.push_back({element, fmt::format("{}/{}", path_, all.size())});
    return all;
  }
  std::vector<Node> members() const {
    if (!value_.is_object()) fail("an object");
    std::vector<Node> all;
    for (const auto& [key, member] : value_.items()) all.push_back({member, path_ + "/" + key});
    return all;
  }
  std::string text() const {
    if (!value_.is_string()) fail("a string");
    return value_.get<std::string>();
  }
  uint64_t count() const {
    if (!value_.is_number_unsigned()) fail("a whole number that is not negative");
    return value_.get<uint64_t>();
  }
  std::string hex(size_t digits) const {
    const std::string found = text();
    if (found.size() != digits || found.find_first_not_of("0123456789abcdef") != found.npos)
      fail(fmt::format("{} hexadecimal digits", digits));
    return found;
  }
  void require(const std::string& wanted) const {
    if (text() != wanted) fail(fmt::format("'{}'", wanted));
  }
  std::string dump() const { return json_line(value_); }
  bool has(const std::string& key) const { return value_.is_object() && value_.contains(key); }

  [[noreturn]] void fail(const std::string& expected) const {
    const std::string found = json_line(value_);
    throw std::invalid_argument(
        fmt::format("at {}: expected {}, found {}", path_.empty() ? "the top" : path_, expected, found.substr(0, 60)));
  }

 private:
  const json& value_;
  std::string path_;
};

// Refuses a run that was interrupted, found a difference or compared less than planned.
void require_equality(const Node& results) {
  results.at("format").require(results_format);
  results.at("verdict").require("equal");
  if (!results.has("comparisons")) return;  // records of versions that did not count them
  for (const Node& backend : results.at("comparisons").members())
    for (const Node& counts : backend.members())
      if (counts.at("made").count() != counts.at("planned").count()) counts.fail("as many made as planned");
}

// The result at one compared step, as text.
std::string result_at(const Node& point) {
  return fmt::format("{}, {}, fingerprint {}, state {}", counted(point.at("pairs").count(), "pair"),
                     counted(point.at("colliding_spheres").count(), "colliding sphere"),
                     point.at("fingerprint").hex(32), point.at("state").hex(16));
}

// Results by configuration. A run may record a configuration several times: by the lockstep check and before each
// timing.
std::map<std::string, std::string> records(const json& file) {
  const Node results(file, "");
  require_equality(results);
  std::map<std::string, std::string> found;
  for (const Node& entry : results.at("equality").elements()) {
    entry.at("verdict").require("equal");
    // Runs recorded in paper/data name the list "answers"; this goes when they are recorded again.
    entry.at(entry.has("answers") ? "answers" : "configurations").elements();
    entry.at("scene").at("name").text();
    entry.at("scene").at("n").count();
    entry.at("scene").at("seed").count();
    for (const Node& point : entry.at("checkpoints").elements()) {
      const std::string key =
          fmt::format("{} | {} | step {}", entry.at("scene").dump(), entry.at("set").text(), point.at("step").count());
      const auto [at, is_new] = found.try_emplace(key, result_at(point));
      if (!is_new && at->second != result_at(point))
        point.fail(fmt::format("what the same run recorded before for {}: {}", key, at->second));
    }
  }
  return found;
}

// A record is a few levels deep; destroying a very deep value would overflow the stack.
bool require_flat(int depth, json::parse_event_t, json&) {
  if (depth > 32) throw std::invalid_argument("expected values at most 32 levels deep, found deeper ones");
  return true;
}

}  // namespace

json to_json(const EqualityEntry& entry) {
  json points = json::array();
  for (const ComparedStep& point : entry.checkpoints)
    points.push_back({{"step", point.step},
                      {"pairs", point.pairs},
                      {"colliding_spheres", point.colliding_spheres},
                      {"fingerprint", hex(point.fingerprint)},
                      {"state", hex64(point.state)}});
  json scene = scene_json(entry.scene);
  if (entry.contact.law != ContactLaw::none) {  // with the options chosen for contacts
    scene["contact"] = contact_json(entry.contact);
    scene["dt"] = entry.dt;
    scene["restitution"] = entry.restitution;
  }
  return {{"scene", scene},
          {"set", entry.set},
          {"configurations", entry.configurations},
          {"verdict", "equal"},
          {"checkpoints", points}};
}

RecordComparison compare_records(const json& left, const json& right) {
  const auto ours = records(left), theirs = records(right);
  RecordComparison result;
  for (const auto& [key, value] : ours) {
    const auto other = theirs.find(key);
    if (other == theirs.end()) {
      result.only_left.push_back(key);
      continue;
    }
    ++result.compared;
    if (other->second != value)
      result.differences.push_back(fmt::format("{}:\n    {}\n    {}", key, value, other->second));
  }
  for (const auto& [key, value] : theirs)
    if (!ours.contains(key)) result.only_right.push_back(key);
  return result;
}

json read_results(const std::string& path) {
  const FileBytes file(path);
  json results;
  try {
    results = json::parse(file.bytes(), require_flat);
    records(results);
  } catch (const json::parse_error& error) {
    throw std::invalid_argument(
        fmt::format("{} is not the results.json of a compare run: no JSON from byte {} on", path, error.byte));
  } catch (const std::exception& error) {  // refused by records()
    throw std::invalid_argument(
        fmt::format("{} is not the results.json of a compare run that found equality: {}", path, error.what()));
  }
  return results;
}

}  // namespace spherepair
