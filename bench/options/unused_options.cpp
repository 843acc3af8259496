// SPDX-License-Identifier: MIT
#include "bench/options/unused_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/io/numbers.h"

namespace spherepair {
namespace {

using Words = std::vector<std::string>;

// The options of a subcommand as they were given, with their defaults.
class Given {
 public:
  explicit Given(const CLI::App& command) : command_(command) {}

  const std::string& command() const { return command_.get_name(); }
  bool has(const std::string& name) const {
    const CLI::Option* option = command_.get_option_no_throw(name);
    return option && option->count() > 0;
  }
  Words list(const std::string& name) const {
    const CLI::Option* option = command_.get_option_no_throw(name);
    if (!option) return {};
    if (option->count()) return option->reduced_results();
    return option->get_default_str().empty() ? Words{} : Words{option->get_default_str()};
  }
  std::string value(const std::string& name) const {
    const Words words = list(name);
    return words.empty() ? "" : words.front();
  }
  bool is(const std::string& name, const Words& values) const {
    return std::ranges::find(values, value(name)) != values.end();
  }
  bool zero(const std::string& name) const { return is(name, {"", "0"}); }

  void refuse(const std::string& option, bool unused, const std::string& why_and_what_to_do) const {
    if (unused && has(option))
      throw std::invalid_argument(fmt::format("{} has no effect {}", option, why_and_what_to_do));
  }

 private:
  const CLI::App& command_;
};

void refuse_of_scene(const Given& given) {
  if (given.value("--scene").empty() || given.has("--input") || given.has("--resume")) return;
  const std::string with = fmt::format("with the scene {}", given.value("--scene"));
  given.refuse(
      "--packing-fraction", !given.is("--scene", {"uniform", "far", "clustered", "gas"}),
      with + ", whose size does not follow from one: omit it, or choose --scene uniform, far, clustered or gas");
  for (const char* option : {"--groups", "--group-size"})
    given.refuse(option, !given.is("--scene", {"aligned"}),
                 with + ", which has no groups: omit it, or choose --scene aligned");
}

// Where no step is taken and no checkpoint written, nothing shows how spheres move.
void refuse_of_motion(const Given& given) {
  const bool run = given.command() == "run", render = given.command() == "render";
  if (!run && !render) return;
  const bool moves = !given.zero("--steps") || given.has("--until-step") || given.has("--time") ||
                     given.has("--until-rest") || (render && !given.is("--images", {"1"}));
  const std::string still = render ? "on one image of the start: omit it, or give --steps or --images"
                                   : "on spheres that do not move: omit it, or give --steps";
  for (const char* option : {"--motion", "--restitution", "--contact", "--stiffness", "--density", "--drag",
                             "--no-sleeping", "--walls", "--box", "--dt", "--gravity", "--plane"})
    given.refuse(option, !moves && !given.has("--save") && !given.has("--swept"), still);
  given.refuse("--per-step", !moves, still);
  for (const char* option : {"--save-every", "--statistics-every", "--trajectory-every"})
    given.refuse(option, !moves, still);
}

void refuse_of_contacts(const Given& given) {
  for (const char* option : {"--stiffness", "--density", "--drag", "--no-sleeping", "--walls", "--box"})
    given.refuse(option, given.is("--contact", {"none"}) && !given.has("--resume"),
                 "without contacts: omit it, or give --contact spring");
  for (const char* option : {"--walls", "--box"})
    given.refuse(option, !given.has("--input") && given.is("--scene", {"gas", "bed"}),
                 "on a scene in a closed box of its own: omit it, or choose another --scene");
}

void refuse_of_search(const Given& given) {
  given.refuse("--quiet",
               given.command() == "pairs" && !given.has("--output") && !given.has("--contacts") && !given.has("--json"),
               "without an output, since only the summary tells the result: omit it, or give --output, --contacts or "
               "--json");
  given.refuse("--naive", given.has("--swept"), "with --swept, which has a test of its own: omit one of the two");
}

void refuse_of_image(const Given& given) {
  if (given.command() != "render") return;
  given.refuse("--every", given.is("--images", {"1"}), "on one image: omit it, or ask for more with --images");
  given.refuse("--rate", !given.has("--video"), "without a video: omit it, or give --video FILE");
  for (const char* option : {"--azimuth", "--elevation"})
    given.refuse(option, given.has("--eye"), "with --eye, which says where the camera is: omit one of the two");
}

// All backends named are among these; none named stands for any.
bool only(const Given& given, const Words& backends) {
  Words named = given.list("--backends");
  if (const std::string one = given.value("--backend"); !one.empty()) named.push_back(one);
  return !named.empty() && std::ranges::all_of(named, [&](const std::string& name) {
    return std::ranges::find(backends, name) != backends.end();
  });
}

void refuse_of_backend(const Given& given) {
  const bool draws_with_opengl =
      given.command() == "view" || given.command() == "frames" || !given.is("--draw", {"", "compute"});
  const bool cpu = only(given, {"cpu"}), no_opengl = only(given, {"cpu", "cuda"}) && !draws_with_opengl;
  given.refuse("--cuda-device", cpu && !draws_with_opengl, "on the backend cpu: omit it, or name a backend of the GPU");
  for (const char* option : {"--gl-device", "--require-hardware", "--no-gpu"})
    given.refuse(option, no_opengl, "where OpenGL is not opened: omit it, or name the backend glsl");
  given.refuse("--compile", no_opengl, "where no shader is compiled: omit it, or name the backend glsl");
  const bool loops =
      given.is("--method", {"sequential", "parallel"}) || (cpu && !given.is("--method", {"collide_group"}));
  given.refuse("--block", loops, "on the CPU, whose loops have no groups: omit it, or name a backend of the GPU");
  given.refuse("--block", given.is("--method", {"collide_tensor"}),
               "with the method collide_tensor, whose groups have one size: omit it, or name another method");
  given.refuse(
      "--block", given.is("--method", {"auto"}) && given.is("--block", {"128"}),
      "with the method auto, which chooses the group size itself unless another than 128 is given: omit it, or "
      "name a method");
}

void refuse_of_study(const Given& given) {
  const Words tables = given.list("--tables");
  for (const char* option : {"--rounds", "--min-seconds"})
    given.refuse(option, tables == Words{"none"}, "with --tables none, which times nothing: omit one of the two");
  const Words draws = given.list("--draws");
  for (const std::string& limit : given.list("--most")) {
    const std::string draw = limit.substr(0, limit.find(':'));
    given.refuse("--most", given.has("--draws") && std::ranges::find(draws, draw) == draws.end(),
                 fmt::format("on {}, which is not among --draws: omit it", draw));
  }
}

void refuse_of_measurements(const Given& given) {
  const Words measured = given.list("--measure");
  if (measured.empty()) return;
  const std::pair<const char*, Words> uses[] = {{"--laws", {"errors", "rates"}},
                                                {"--steps", {"errors", "rates"}},
                                                {"--n", {"errors"}},
                                                {"--cost-n", {"sums"}},
                                                {"--step-n", {"steps"}},
                                                {"--averaged", {"steps"}},
                                                {"--rate-n", {"rates"}},
                                                {"--rest-n", {"rest"}},
                                                {"--rest-layers", {"rest"}},
                                                {"--drag-steps", {"rest"}},
                                                {"--rounds", {"errors", "sums", "steps", "rest"}}};
  for (const auto& [option, used_by] : uses)
    given.refuse(option, std::ranges::find_first_of(measured, used_by) == measured.end(),
                 fmt::format("with --measure {}: omit it, or measure {} as well", fmt::join(measured, ","),
                             fmt::join(used_by, " or ")));
}

bool same(const std::string& left, const std::string& right) {
  constexpr double most = std::numeric_limits<double>::max();
  const auto number = real_number_of(left, -most, most);
  return left == right || (number && number == real_number_of(right, -most, most));
}

// Of an option that takes a list: all but --columns, in which `_` may stand often, and vectors and boxes.
void refuse_repeated_words(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const bool list = option->get_delimiter() != '\0' && option->get_items_expected_max() > 6;
    if (!list || option->count() == 0 || option->get_name() == "--columns") continue;
    const Words words = option->reduced_results();
    for (size_t k = 0; k < words.size(); ++k)
      if (std::ranges::any_of(std::span(words).first(k), [&](const std::string& word) { return same(word, words[k]); }))
        throw std::invalid_argument(
            fmt::format("{} has {} more than once: name it once", option->get_name(), words[k]));
  }
}

}  // namespace

void refuse_unused_options(const CLI::App& command) {
  const Given given(command);
  refuse_repeated_words(command);
  refuse_of_scene(given);
  refuse_of_motion(given);
  refuse_of_contacts(given);
  refuse_of_search(given);
  refuse_of_image(given);
  refuse_of_backend(given);
  refuse_of_study(given);
  refuse_of_measurements(given);
}

}  // namespace spherepair
