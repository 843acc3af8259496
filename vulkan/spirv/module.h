// SPDX-License-Identifier: MIT
// Reads the bindings of a SPIR-V module of one compute shader, and sets how its float operations round.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace spherepair {

// Execution modes of the floats of one width that a device offers.
struct FloatModes {
  bool round_to_even = false, keep_denormals = false, keep_signed_zeros = false;  // and infinities and NaN
};

struct FloatControls {
  FloatModes of_32, of_64;
  bool rounding_by_width = false, denormals_by_width = false;  // the two widths may differ
};

struct SpirvBinding {
  enum class Kind { storage, uniform, uniform_as_storage, texels };
  Kind kind;
  uint32_t count;  // of descriptors
};

class SpirvModule {
 public:
  explicit SpirvModule(std::vector<uint32_t> words);

  const std::vector<uint32_t>& words() const { return words_; }
  const std::map<uint32_t, SpirvBinding>& bindings() const { return bindings_; }  // by binding number, in set 0

  // Offset in bytes of a member of the uniform block at this binding; -1: no member has this name.
  int offset_of(uint32_t binding, const std::string& member) const;

  // Turns uniform blocks into storage buffers with the same bindings.
  void read_uniforms_as_storage();

  // Sets the unroll hint on all loops. NVIDIA's driver unrolls the loops of GLSL by itself, but those of SPIR-V only
  // with the hint. Without it a search of 10^7 spheres in random order takes 1.08 times as long (NVIDIA H200).
  void unroll_loops();

  // Declares the offered execution modes for the widths that the module uses.
  void declare(const FloatControls& offered);

 private:
  struct Member {
    std::string name;
    uint32_t offset = 0;
  };
  struct Types;
  void find_bindings(const Types& types);

  std::vector<uint32_t> words_;
  std::map<uint32_t, SpirvBinding> bindings_;
  std::map<uint32_t, std::vector<Member>> members_;  // of uniform blocks, by binding
  std::vector<uint32_t> uniform_blocks_;             // the ids of their types
};

}  // namespace spherepair
