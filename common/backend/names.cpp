// SPDX-License-Identifier: MIT
// Names of methods, as options and records write them.
#include <algorithm>

#include "common/backend/backend.h"
#include "common/scene/known_name.h"

namespace spherepair {
namespace {

constexpr std::array<const char*, 9> method_names = {"sequential",     "parallel",       "collide_group",
                                                     "collide_tiled",  "collide_square", "collide_triangle",
                                                     "collide_tensor", "collide_grid",   "auto"};
constexpr std::array<const char*, 6> draw_method_names = {"compute", "mesh_each", "mesh",
                                                          "quadric", "points",    "impostor"};
constexpr std::array<DrawMethod, 6> draw_methods = {DrawMethod::compute, DrawMethod::mesh_each, DrawMethod::mesh,
                                                    DrawMethod::quadric, DrawMethod::points,    DrawMethod::impostor};
constexpr std::array<uint, 6> blocks = {32, 64, 128, 256, 512, 1024};
constexpr std::array<uint, 2> small_blocks = {8, 16};

}  // namespace

const char* method_name(Method method) { return method_names[size_t(method)]; }

Method method_from_name(const std::string& name) {
  const auto found = std::ranges::find(method_names, name);
  if (found == method_names.end())
    throw std::invalid_argument(unknown_name("method", name, {method_names.begin(), method_names.end()}));
  return Method(found - method_names.begin());
}

const char* draw_method_name(DrawMethod method) { return draw_method_names[size_t(method)]; }

DrawMethod draw_method_from_name(const std::string& name) {
  const auto found = std::ranges::find(draw_method_names, name);
  if (found == draw_method_names.end())
    throw std::invalid_argument(
        unknown_name("method of drawing", name, {draw_method_names.begin(), draw_method_names.end()}));
  return DrawMethod(found - draw_method_names.begin());
}

std::span<const DrawMethod> all_draw_methods() { return draw_methods; }

std::vector<Method> device_methods() {
  return {Method::collide_group, Method::collide_tiled, Method::collide_square, Method::collide_triangle,
          Method::collide_grid};
}

std::span<const uint> block_sizes() { return blocks; }
std::span<const uint> small_block_sizes() { return small_blocks; }

const char* transfer_name(Transfer way) {
  constexpr const char* indices[] = {"host", "registered", "imported"};
  return indices[size_t(way)];
}

}  // namespace spherepair
