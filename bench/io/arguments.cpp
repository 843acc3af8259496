// SPDX-License-Identifier: MIT
#include "bench/io/arguments.h"

#include <fmt/format.h>

#include <algorithm>

#include "api/open.h"
#include "bench/io/numbers.h"
#include "common/scene/known_name.h"

namespace spherepair {

void require_known(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
  if (std::ranges::find(known, name) == known.end()) throw std::invalid_argument(unknown_name(what, name, known));
}

std::vector<std::string> backend_ids(std::vector<std::string> names) {
  std::ranges::transform(names, names.begin(), backend_id);
  return names;
}

std::vector<Method> all_methods() {
  std::vector<Method> methods = {Method::sequential, Method::parallel};
  for (Method method : device_methods()) methods.push_back(method);
  methods.push_back(Method::collide_tensor);
  return methods;
}

std::vector<Method> parse_methods(const std::vector<std::string>& names) {
  if (names.empty()) return all_methods();
  std::vector<Method> methods;
  for (const std::string& name : names) methods.push_back(method_from_name(name));
  return methods;
}

std::vector<uint> parse_blocks(const std::vector<uint>& blocks) {
  const std::vector<uint> known(block_sizes().begin(), block_sizes().end());
  for (uint block : blocks)
    if (std::ranges::find(known, block) == known.end())
      throw std::invalid_argument(fmt::format("unknown group size {}; known are {}", block, fmt::join(known, ", ")));
  return blocks.empty() ? known : blocks;
}

}  // namespace spherepair
