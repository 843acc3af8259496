// SPDX-License-Identifier: MIT
#include "bench/options/options.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/io/arguments.h"
#include "bench/measure/choice.h"
#include "common/backend/device_name.h"
#include "common/scene/camera.h"
#include "common/scene/known_name.h"

namespace spherepair {

// Our own validator: CLI11 reports "abc" as out of range, reads 010 as 8 and does not know 1e6.
CLI::Validator whole_number(uint64_t low, uint64_t high) {
  const auto read = [=](std::string& text) -> std::string {
    if (const auto number = count_of(text, low, high)) {
      text = std::to_string(*number);
      return {};
    }
    return fmt::format("'{}' is not a whole number from {} to {}, written like 16384, 16k, 1.5M or 1e6", text, low,
                       high);
  };
  return CLI::Validator(read, fmt::format("{}..{}", low, high));
}

CLI::Validator real_number(double low, double high) {
  const auto check = [=](std::string& text) -> std::string {
    if (real_number_of(text, low, high)) return {};
    return fmt::format("'{}' is not a number from {} to {}", text, low, high);
  };
  return CLI::Validator(check, fmt::format("{}..{}", low, high));
}

void refuse_empty_values(CLI::App& command) {
  const auto check = [](const std::string& text) {
    return text.empty() ? "no value was given: omit the option or give one" : std::string();
  };
  for (CLI::Option* option : command.get_options())
    if (option->get_expected_max() > 0) option->check(check);
}

void add_backend_option(CLI::App& command, std::string& backend, const std::string& what) {
  const auto take = [&](const std::string& name) { backend = name == kAutomaticBackend ? "" : backend_id(name); };
  command
      .add_option_function<std::string>(
          "--backend", take,
          what +
              ": cpu, opengl, cuda or vulkan; auto: the first that opens of cuda, vulkan and opengl on a GPU, and cpu")
      ->default_str(kAutomaticBackend);
}

void add_backends_option(CLI::App& command, std::vector<std::string>& backends) {
  const auto take = [&](const std::vector<std::string>& names) {
    if (names != std::vector<std::string>{kAutomaticBackend}) backends = backend_ids(names);
  };
  command
      .add_option_function<std::vector<std::string>>(
          "--backends", take,
          "Only these of cpu,opengl,cuda,vulkan, opengl-core (OpenGL without vendors' extensions and storage) and "
          "opengl-spirv (the same with kernels compiled to SPIR-V), and each must open; auto: the first "
          "four, as far as they open")
      ->delimiter(',')
      ->default_str(kAutomaticBackend);
}

void add_results_option(CLI::App& command, std::string& results, const std::string& files) {
  command.add_option("--results", results, fmt::format("Folder for {}; default: results/<host>-<date>", files));
}

void add_rounds_option(CLI::App& command, int& rounds, uint64_t least) {
  add_number(command, "--rounds", rounds, whole_number(least, 100'000), "Rounds of each timing");
}

void add_min_seconds_option(CLI::App& command, double& seconds) {
  command.add_option("--min-seconds", seconds, "Minimum time of the longest batch (default 0.02 on a GPU, else 0.05)")
      ->check(real_number(1e-6, 60));
}

void add_block_option(CLI::App& command, uint& block) {
  const char* what = "Group size of a GPU's kernels: 32, 64 ... 1024; default: as auto chooses, else 128";
  command.add_option("--block", block, what)->transform(block_range);
}

void add_open_options(CLI::App& command, OpenOptions& open) {
  const auto device = [&](const char* name, std::string& value, const char* text) {
    command.add_option(name, value, text)->check([](const std::string& given) -> std::string {
      try {
        static_cast<void>(DeviceName(given));
        return {};
      } catch (const std::invalid_argument& error) {
        return error.what();
      }
    });
  };
  device("--cuda-device", open.cuda_device, "GPU of CUDA, by number or UUID; default: as OpenGL, else the first");
  device("--gl-device", open.gl_device, "GPU of OpenGL, likewise");
  device("--vulkan-device", open.vulkan_device, "GPU of Vulkan, likewise");
  command.add_flag("--require-hardware", open.require_hardware, "Refuse software OpenGL and Vulkan");
  command
      .add_flag_callback(
          "--no-gpu", [&open] { open.allow_gpu = false; },
          "Use no GPU: OpenGL and Vulkan run in software, auto takes the CPU")
      ->excludes(command.get_option("--cuda-device"))
      ->excludes(command.get_option("--gl-device"))
      ->excludes(command.get_option("--vulkan-device"));
  add_number(command, "--threads", open.threads, whole_number(0, 4096), "Of the CPU; 0: all cores");
}

void add_verbosity_options(CLI::App& command, Verbosity& verbosity) {
  const auto set = [&](const char* name, Verbosity to, const char* text) {
    return command.add_flag_callback(
        name, [&verbosity, to] { verbosity = to; }, text);
  };
  set("--quiet", Verbosity::quiet, "Print errors and warnings about the result alone");
  set("--verbose", Verbosity::verbose, "Print reasons and details, too")->excludes("--quiet");
}

void add_size_option(CLI::App& command, uint& width, uint& height) {
  const auto read = [&width, &height](const std::string& text) {
    const auto size = two_numbers_of(text, 'x', widest_image);
    if (!size)
      throw CLI::ValidationError(
          "--size", fmt::format("'{}' is not a size in pixels such as 1280x720, each at most {}", text, widest_image));
    width = uint((*size)[0]);
    height = uint((*size)[1]);
  };
  command.add_option_function<std::string>("--size", read,
                                           fmt::format("Width x height in pixels (default {}x{})", width, height));
}

}  // namespace spherepair
