// SPDX-License-Identifier: MIT
#include "bench/options/unused_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/io/numbers.h"

namespace spherepair {
namespace {

using Words = std::vector<std::string>;

// The given options of a subcommand, and the defaults of the others.
class Given {
 public:
  explicit Given(const CLI::App& command) : command_(command) {}

  bool has(const std::string& name) const {
    const CLI::Option* option = command_.get_option_no_throw(name);
    return option && option->count() > 0;
  }
  bool any(const Words& names) const {
    return std::ranges::any_of(names, [&](const auto& name) { return has(name); });
  }
  Words list(const std::string& name) const {
    const CLI::Option* option = command_.get_option_no_throw(name);
    return !option ? Words{} : option->count() ? option->reduced_results() : Words{option->get_default_str()};
  }
  std::string value(const std::string& name) const { return list(name).empty() ? "" : list(name).front(); }
  bool is(const std::string& name, const Words& values) const { return std::ranges::count(values, value(name)) > 0; }

  void refuse(bool unused, const Words& options, const std::string& why_and_what_to_do) const {
    for (const std::string& option : options)
      if (unused && has(option))
        throw std::invalid_argument(fmt::format("{} has no effect {}", option, why_and_what_to_do));
  }

 private:
  const CLI::App& command_;
};

void refuse_of_scene(const Given& given) {
  if (given.any({"--input", "--resume"})) return;
  const std::string with = fmt::format("with the scene {}", given.value("--scene"));
  given.refuse(
      !given.is("--scene", {"", "uniform", "far", "clustered", "gas"}), {"--packing-fraction"},
      with + ", whose size does not follow from one: omit it, or choose --scene uniform, far, clustered or gas");
  given.refuse(!given.is("--scene", {"aligned"}), {"--groups", "--group-size"},
               with + ", which has no groups: omit it, or choose --scene aligned");
}

// Refuses options of motion in a run that takes no step and writes no checkpoint: they would have no effect.
void refuse_of_motion(const Given& given, const std::string& command) {
  if (command != "run" && command != "render") return;
  const bool render = command == "render", moves = !given.is("--steps", {"0"}) ||
                                                   given.any({"--until-step", "--time", "--until-rest"}) ||
                                                   !given.is("--images", {"", "1"});
  const std::string still = render ? "on one image of the start: omit it, or give --steps or --images"
                                   : "on spheres that do not move: omit it, or give --steps";
  given.refuse(!moves && !given.any({"--save", "--swept"}),
               {"--motion", "--restitution", "--contact", "--stiffness", "--density", "--drag", "--no-sleeping",
                "--walls", "--box", "--periodic", "--dt", "--gravity", "--plane"},
               still);
  given.refuse(!moves, {"--per-step", "--save-every", "--statistics-every", "--trajectory-every"}, still);
}

void refuse_of_contacts(const Given& given) {
  given.refuse(given.is("--contact", {"none"}) && !given.has("--resume"),
               {"--stiffness", "--density", "--drag", "--no-sleeping", "--walls", "--box", "--periodic"},
               "without contacts: omit it, or give --contact spring");
  given.refuse(!given.has("--input") && given.is("--scene", {"gas", "bed"}), {"--walls", "--box"},
               "on a scene in a closed box of its own: omit it, or choose another --scene");
}

// Whether all named backends are among these. No names mean any backend, so the answer is no.
bool only(const Given& given, const std::set<std::string>& backends) {
  const Words named = given.list(given.has("--backend") ? "--backend" : "--backends");
  return !named.empty() && std::ranges::all_of(named, [&](const auto& name) { return backends.contains(name); });
}

void refuse_of_backend(const Given& given, const std::string& command) {
  const bool draws_with_opengl = command == "view" || command == "frames" || !given.is("--draw", {"", "compute"});
  const bool cpu = only(given, {"cpu"}), no_glsl = only(given, {"cpu", "cuda"}) && !draws_with_opengl;
  given.refuse(cpu && !draws_with_opengl, {"--cuda-device", "--vulkan-device"},
               "on the backend cpu: omit it, or name a backend of the GPU");
  given.refuse(no_glsl, {"--gl-device", "--require-hardware", "--no-gpu", "--compile"},
               "where neither OpenGL nor Vulkan is opened: omit it, or name the backend opengl or vulkan");
  given.refuse(given.is("--method", {"sequential", "parallel"}) || (cpu && !given.is("--method", {"collide_group"})),
               {"--block"}, "on the CPU, whose loops have no groups: omit it, or name a backend of the GPU");
  given.refuse(given.is("--method", {"collide_tensor"}), {"--block"},
               "with the method collide_tensor, whose groups have one size: omit it, or name another method");
  given.refuse(given.is("--method", {"auto"}) && given.is("--block", {"128"}), {"--block"},
               "with the method auto, for which 128 means that it chooses the group size: omit it, or name a method");
}

void refuse_of_outputs(const Given& given, const std::string& command) {
  given.refuse(command == "pairs" && !given.any({"--output", "--contacts", "--json"}), {"--quiet"},
               "without an output, since only the summary tells the result: omit it, or give --output, --contacts or "
               "--json");
  given.refuse(command == "render" && given.is("--images", {"1"}), {"--every"},
               "on one image: omit it, or ask for more with --images");
}

void refuse_of_study(const Given& given) {
  given.refuse(given.list("--tables") == Words{"none"}, {"--rounds", "--min-seconds"},
               "with --tables none, which times nothing: omit one of the two");
  const Words draws = given.list("--draws");
  for (const std::string& limit : given.has("--most") && given.has("--draws") ? given.list("--most") : Words{})
    given.refuse(std::ranges::count(draws, limit.substr(0, limit.find(':'))) == 0, {"--most"},
                 fmt::format("on {}, which is not among --draws: omit it", limit));
  const std::pair<const char*, std::set<std::string>> uses[] = {
      {"--laws", {"errors", "rates"}}, {"--steps", {"errors", "rates"}}, {"--averaged", {"steps"}},
      {"--rest-layers", {"rest"}},     {"--drag-steps", {"rest"}},       {"--rounds", {"errors", "steps", "rest"}}};
  const Words measured = given.list("--measure");
  for (const auto& [option, used_by] : uses)
    given.refuse(given.has("--measure") &&
                     std::ranges::none_of(measured, [&by = used_by](const auto& one) { return by.contains(one); }),
                 {option},
                 fmt::format("with --measure {}: omit it, or measure {} as well", fmt::join(measured, ","),
                             fmt::join(used_by, " or ")));
}

// Refuses a word that stands twice in a list. --columns may repeat `_`; vectors and boxes are no lists. Numbers are
// compared by value.
void refuse_repeated_words(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const bool list = option->get_delimiter() != '\0' && option->get_items_expected_max() > 6;
    std::set<std::string> known;
    if (!list || option->count() == 0 || option->get_name() == "--columns") continue;
    for (const std::string& word : option->reduced_results()) {
      const auto number = real_number_of(word, -1e300, 1e300);
      if (!known.insert(number ? fmt::format("{}", *number) : word).second)
        throw std::invalid_argument(fmt::format("{} has {} more than once: name it once", option->get_name(), word));
    }
  }
}

}  // namespace

void refuse_unused_options(const CLI::App& command) {
  const Given given(command);
  const std::string name = command.get_name();
  refuse_repeated_words(command);
  refuse_of_scene(given);
  refuse_of_motion(given, name);
  refuse_of_contacts(given);
  refuse_of_backend(given, name);
  refuse_of_outputs(given, name);
  refuse_of_study(given);
}

}  // namespace spherepair
