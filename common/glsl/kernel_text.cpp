// SPDX-License-Identifier: MIT
#include "common/glsl/kernel_text.h"

#include <fmt/format.h>

#include "common/glsl/embedded_shaders.h"

namespace spherepair {
namespace {

constexpr const char* real_names[] = {"float", "Two", "double", "int64_t"};  // indexed by Precision

std::string required(const std::string& extension, const char* macro) {
  return fmt::format("#extension {} : require\n#define {}\n", extension, macro);
}

std::string extension_lines(const KernelExtensions& extensions) {
  return (extensions.atomics_64.empty() ? "" : required(extensions.atomics_64, "ATOMICS_64")) +
         (extensions.subgroups ? "#extension GL_KHR_shader_subgroup_shuffle : require\n" +
                                     required("GL_KHR_shader_subgroup_arithmetic", "SUBGROUPS")
                               : "");
}

}  // namespace

std::string kernel_text(const std::string& kernel, unsigned block, const Variant& variant,
                        const KernelExtensions& extensions) {
  const std::string& text = embedded_shaders().at(kernel + ".comp");
  const size_t after_version = text.find('\n') + 1;
  const uint method = uint(variant.motion.method), precision = uint(variant.motion.precision);
  return text.substr(0, after_version) +
         fmt::format("#define BLOCK {}\n#define EQUAL_RADII {}\n#define LISTED {}\n#define DENSE {}\n", block,
                     variant.equal_radii, variant.listed, variant.dense) +
         fmt::format("#define FROM_TILES {}\n#define BUNDLES {}\n#define BY_CELLS {}\n#define LONG_ROWS {}\n",
                     variant.from_tiles, variant.bundles, variant.by_cells, variant.long_rows) +
         fmt::format("#define INDICES {}u\n", variant.indices) +
         (variant.texture_table ? "#define TEXTURE_TABLE\n" : "") + (variant.windows ? "#define WINDOWS\n" : "") +
         (variant.folded ? "#define FOLDED\n" : "") +
         fmt::format("#define METHOD {}u\n#define PRECISION {}\n#define Real {}\n", method, precision,
                     real_names[precision]) +
         extension_lines(extensions) + text.substr(after_version);
}

}  // namespace spherepair
