// SPDX-License-Identifier: MIT
#include "tests/faults/faulty_backend.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "api/open.h"
#include "tests/faults/faulty_contacts.h"
#include "tests/support/forwarding_backend.h"

namespace spherepair {
namespace {

bool has(const std::vector<Pair>& pairs, Pair pair) { return std::ranges::find(pairs, pair) != pairs.end(); }

void swap_partners(std::vector<Pair>& pairs) {
  for (Pair& left : pairs)
    for (Pair& right : pairs) {
      const Pair one = {left.first, right.second}, other = {right.first, left.second};
      if (!(one.first < one.second && other.first < other.second) || has(pairs, one) || has(pairs, other)) continue;
      left = one;
      right = other;
      return;
    }
  throw std::logic_error("no two pairs of this set can exchange a partner");
}

void add_absent_pair(std::vector<Pair>& pairs) {
  Pair extra = {0, 1};
  while (has(pairs, extra)) ++extra.second;
  pairs.push_back(extra);
}

class FaultyBackend : public ForwardingBackend {
 public:
  FaultyBackend(const std::string& name, Fault fault, uint64_t from_step)
      : ForwardingBackend(name, open_backend("cpu", {.threads = 1})), fault_(fault), from_step_(from_step) {}

  std::vector<Method> methods() const override {
    return fault_ == Fault::no_methods ? std::vector<Method>() : ForwardingBackend::methods();
  }
  void upload(const Scene& scene) override {
    ForwardingBackend::upload(scene);
    begin(scene);
  }
  void resume(const Scene& scene, const MotionState& saved) override {
    ForwardingBackend::resume(scene, wrong(Fault::old_momenta) ? spoiled_start(fault_, scene, saved) : saved);
    begin(scene);
  }
  void move() override {
    if (spoils_steps(fault_))
      move_with_contacts();
    else
      ForwardingBackend::move();
    ++step_;
  }

  // The list is always made, since a set that is wrong as a whole is told from it.
  void collide(const CollideOptions& options) override {
    CollideOptions listing = options;
    listing.want_pairs = true;
    ForwardingBackend::collide(listing);
    set_ = spoiled_set(ForwardingBackend::pairs());
  }
  Collisions collisions() override {
    Collisions totals = ForwardingBackend::collisions();
    const std::vector<uint> counts = counts_of(set_);
    totals.pairs = set_.size();
    totals.colliding_spheres = uint64_t(std::ranges::count_if(counts, colliding));
    totals.fingerprint = fingerprint(set_);
    totals.pairs += wrong(Fault::pair_total);
    totals.colliding_spheres += wrong(Fault::colliding_total);
    totals.fingerprint.a ^= uint64_t(wrong(Fault::fingerprint)) << 17;
    totals.fingerprint.b ^= uint64_t(wrong(Fault::second_fingerprint)) << 17;
    return totals;
  }
  std::vector<uint> counts() override {
    std::vector<uint> counts = counts_of(set_);
    if (wrong(Fault::sphere_count)) counts.at(7) += 2;
    if (wrong(Fault::count_missing)) counts.pop_back();
    return counts;
  }
  std::vector<Pair> pairs() override {
    std::vector<Pair> listed = set_;
    if (wrong(Fault::listed_pair)) swap_partners(listed);
    std::ranges::sort(listed);
    return listed;
  }
  State state() override {
    State state = ForwardingBackend::state();
    const auto flip = [](float& value) { value = bits_float(float_bits(value) ^ 1u); };
    if (wrong(Fault::position_bit)) flip(state.positions.at(3).z);
    if (wrong(Fault::velocity_bit)) flip(state.velocities.at(3).y);
    if (wrong(Fault::infinite_position)) state.positions.at(3).x = INFINITY;
    if (wrong(Fault::radius_bit)) flip(state.positions.at(3).w);
    if (wrong(Fault::wide_bit) && !state.wide.empty()) state.wide.back() ^= 1u;
    if (wrong(Fault::velocity_missing)) state.velocities.pop_back();
    return state;
  }
  std::vector<uint> image() override {
    std::vector<uint> pixels = ForwardingBackend::image();
    if (wrong(Fault::image_pixel)) pixels.at(pixels.size() / 2) ^= 1u;
    return pixels;
  }
  void check_guards() override {
    if (wrong(Fault::guard_overwritten)) throw BackendError("a kernel wrote behind the end of a buffer");
  }

 private:
  bool wrong(Fault fault) const { return fault_ == fault && step_ >= from_step_; }

  void begin(const Scene& scene) {
    scene_ = scene;
    before_ = {};
    step_ = lists_ = 0;
  }
  State real_state() {
    evaluate_state();
    return ForwardingBackend::state();
  }
  // The right step, behind which the wrong state takes its place.
  void move_with_contacts() {
    const State earlier = std::exchange(before_, real_state());
    const uint64_t searches = work_counts().steps;
    ForwardingBackend::move();
    lists_ += work_counts().steps - searches;
    if (step_ < from_step_) return;
    const State right = real_state(), spoiled = spoiled_step(fault_, scene_, earlier, before_, right, lists_ <= 1);
    if (spoiled.wide == right.wide) return;
    Scene scene = scene_;
    scene.positions = spoiled.positions, scene.velocities = spoiled.velocities;
    MotionState saved = save();
    saved.wide = spoiled.wide;
    ForwardingBackend::resume(scene, saved);
  }

  std::vector<Pair> spoiled_set(std::vector<Pair> pairs) const {
    if (wrong(Fault::dropped_pair) && !pairs.empty()) pairs.erase(pairs.begin());
    if (wrong(Fault::added_pair)) add_absent_pair(pairs);
    if (wrong(Fault::swapped_pairs)) swap_partners(pairs);
    std::ranges::sort(pairs);
    return pairs;
  }
  std::vector<uint> counts_of(const std::vector<Pair>& pairs) const {
    std::vector<uint> counts(scene_.size());
    for (const Pair& pair : pairs) ++counts[pair.first], ++counts[pair.second];
    return counts;
  }

  Fault fault_;
  uint64_t from_step_, step_ = 0;
  uint64_t lists_ = 0;  // of near pairs since the upload
  Scene scene_;
  State before_;  // the last step
  std::vector<Pair> set_;
};

}  // namespace

const std::vector<NamedFault>& set_faults() {
  static const std::vector<NamedFault> all = {{"dropped_pair", Fault::dropped_pair, "first in pair ("},
                                              {"added_pair", Fault::added_pair, "first in pair ("},
                                              {"swapped_pairs", Fault::swapped_pairs, "first in pair ("},
                                              {"pair_total", Fault::pair_total, "the number of pairs"},
                                              {"colliding_total", Fault::colliding_total, "colliding spheres"},
                                              {"fingerprint", Fault::fingerprint, "the fingerprint"},
                                              {"second_fingerprint", Fault::second_fingerprint, "the fingerprint"},
                                              {"sphere_count", Fault::sphere_count, "the count of sphere 7"},
                                              {"count_missing", Fault::count_missing, "how many spheres have a count"},
                                              {"listed_pair", Fault::listed_pair, "first in pair ("}};
  return all;
}

const std::vector<NamedFault>& state_faults() {
  static const std::vector<NamedFault> all = {
      {"position_bit", Fault::position_bit, "position z of sphere 3"},
      {"velocity_bit", Fault::velocity_bit, "velocity y of sphere 3"},
      {"radius_bit", Fault::radius_bit, "position w of sphere 3"},
      {"velocity_missing", Fault::velocity_missing, "how many spheres have a velocity"}};
  return all;
}

const std::vector<NamedFault>& contact_faults() {
  static const std::vector<NamedFault> all = {{"lost_near_pair", Fault::lost_near_pair, "state, first in position"},
                                              {"moves_at_rest", Fault::moves_at_rest, "state, first in velocity x"},
                                              {"stays_at_rest", Fault::stays_at_rest, "state, first in "},
                                              {"drag_once_more", Fault::drag_once_more, "state, first in position"}};
  return all;
}

Fault fault_from_name(const std::string& name) {
  for (const auto* faults : {&set_faults(), &state_faults(), &contact_faults()})
    for (const NamedFault& one : *faults)
      if (name == one.name) return one.fault;
  const std::pair<const char*, Fault> others[] = {{"none", Fault::none},
                                                  {"wide_bit", Fault::wide_bit},
                                                  {"old_momenta", Fault::old_momenta},
                                                  {"image_pixel", Fault::image_pixel},
                                                  {"infinite_position", Fault::infinite_position},
                                                  {"guard_overwritten", Fault::guard_overwritten},
                                                  {"no_methods", Fault::no_methods}};
  for (const auto& [known, fault] : others)
    if (name == known) return fault;
  throw std::invalid_argument("unknown fault " + name);
}

std::unique_ptr<Backend> make_faulty(const std::string& name, Fault fault, uint64_t from_step) {
  return std::make_unique<FaultyBackend>(name, fault, from_step);
}

Opener faulty_opener(Fault fault, uint64_t from_step) {
  return [=](const std::string& name, const OpenOptions& options) {
    if (name == "cpu") return open_backend(name, options);
    if (name == "opengl") return make_faulty(name, fault, from_step);
    throw BackendError(name + ": not among the backends of this test");
  };
}

}  // namespace spherepair
