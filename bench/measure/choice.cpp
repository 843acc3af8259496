// SPDX-License-Identifier: MIT
#include "bench/measure/choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "common/backend/checks.h"

namespace spherepair {
namespace {

ChosenBackend open_one(const std::string& name, const OpenOptions& options, const Opener& opener) {
  ChosenBackend chosen;
  chosen.session = std::make_unique<Session>(std::vector{name}, options, opener);
  chosen.backend = chosen.session->find(name);
  return chosen;
}

}  // namespace

ChosenBackend choose_backend(const std::string& name, const OpenOptions& options, const Opener& opener) {
  if (!name.empty()) return open_one(name, options, opener);
  const bool wants_gpu = !options.cuda_device.empty() || !options.gl_device.empty() || !options.vulkan_device.empty() ||
                         options.require_hardware;
  const bool worth_trying = wants_gpu || gpu_nodes_present();  // opening software takes 0.1 s
  std::vector<std::string> passed_over;
  OpenOptions hardware = options;
  hardware.require_hardware = true;  // OpenGL and Vulkan in software are slower than the CPU backend
  for (const std::string& device : gpu_backend_names()) {
    if (!options.allow_gpu) break;
    if (!worth_trying) {
      passed_over.push_back(fmt::format("{}: not tried, since /dev shows no GPU (nvidia*, dri, dxg, nvmap)", device));
      continue;
    }
    try {
      ChosenBackend chosen = open_one(device, hardware, opener);
      chosen.passed_over = passed_over;
      return chosen;
    } catch (const BackendError& error) {
      passed_over.push_back(error.what());
    }
  }
  if (wants_gpu)
    throw BackendError(
        fmt::format("no GPU for --cuda-device, --gl-device, --vulkan-device or --require-hardware: {}; omit that "
                    "option, or mend the first of these",
                    fmt::join(passed_over, "; ")));
  ChosenBackend chosen = open_one("cpu", options, opener);
  chosen.passed_over = passed_over;
  return chosen;
}

std::string passed_over_text(const ChosenBackend& chosen) {
  std::string text;
  for (const std::string& reason : chosen.passed_over) text += fmt::format("  passed over: {}\n", reason);
  return text;
}

json to_json(const MethodChoice& choice) {
  json out = {{"name", method_name(choice.method)}};
  if (choice.method == Method::collide_grid) out["cells"] = choice.cells == Cells::dense ? "dense" : "hashed";
  if (choice.block) out["block"] = choice.block;
  out["reason"] = choice.reason;
  return out;
}

Method choose_method(const std::string& name, const Search& search) {
  if (name.empty()) return Method::automatic;
  std::vector<std::string> known;
  for (Method method : search.methods()) known.push_back(method_name(method));
  known.push_back(method_name(Method::automatic));
  const Method method = method_from_name(name);
  refuse_tensor(search.info().name, {.method = method}, std::ranges::count(known, name) != 0);
  require_known("method of the backend " + search.info().name + ":", name, known);
  return method;
}

}  // namespace spherepair
