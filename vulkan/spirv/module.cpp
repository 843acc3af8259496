// SPDX-License-Identifier: MIT
#include "vulkan/spirv/module.h"

#include <algorithm>
#include <cstring>

#include "common/backend/backend.h"

namespace spherepair {
namespace {

// Numbers of SPIR-V's specification.
enum Op : uint32_t {
  op_member_name = 6,
  op_extension = 10,
  op_entry_point = 15,
  op_execution_mode = 16,
  op_capability = 17,
  op_type_array = 28,
  op_type_pointer = 32,
  op_constant = 43,
  op_variable = 59,
  op_decorate = 71,
  op_member_decorate = 72,
  op_loop_merge = 246
};
enum : uint32_t { loop_unrolled = 1 };
enum : uint32_t { decoration_block = 2, decoration_buffer_block = 3, decoration_binding = 33, decoration_offset = 35 };
enum : uint32_t { storage_uniform_constant = 0, storage_uniform = 2, storage_buffer = 12 };
enum : uint32_t { capability_float_64 = 10 };
constexpr uint32_t magic = 0x07230203;
constexpr size_t header_words = 5;

struct Instruction {
  size_t at;  // in the module's words
  uint32_t op, length;
};

template <typename Visit>
void for_each_instruction(const std::vector<uint32_t>& words, Visit visit) {
  if (words.size() < header_words || words[0] != magic) throw BackendError("vulkan: a SPIR-V module has no header");
  for (size_t at = header_words; at < words.size();) {
    const uint32_t length = words[at] >> 16;
    if (length == 0 || at + length > words.size())
      throw BackendError("vulkan: a SPIR-V module ends within an instruction");
    visit(Instruction{at, words[at] & 0xFFFFu, length});
    at += length;
  }
}

std::string text_at(const std::vector<uint32_t>& words, size_t first, size_t behind) {
  std::string bytes((behind - first) * sizeof(uint32_t), '\0');
  std::memcpy(bytes.data(), &words[first], bytes.size());
  return bytes.substr(0, bytes.find('\0'));
}

std::vector<uint32_t> extension_words(const std::string& name) {
  std::vector<uint32_t> words(1 + name.size() / sizeof(uint32_t) + 1);
  words[0] = uint32_t(words.size()) << 16 | op_extension;
  std::memcpy(&words[1], name.data(), name.size());
  return words;
}

// An execution mode and the capability that it needs.
struct Mode {
  bool FloatModes::*offered;
  uint32_t mode, capability;
};
constexpr Mode modes[] = {{&FloatModes::keep_denormals, 4459, 4464},
                          {&FloatModes::keep_signed_zeros, 4461, 4466},
                          {&FloatModes::round_to_even, 4462, 4467}};

// If both widths must have the same modes, keeps only those that both have.
FloatControls with_equal_widths(FloatControls offered, bool uses_64) {
  if (!uses_64) return offered;
  const auto equalise = [&](bool FloatModes::*mode, bool may_differ) {
    if (may_differ || offered.of_32.*mode == offered.of_64.*mode) return;
    offered.of_32.*mode = offered.of_64.*mode = false;
  };
  equalise(&FloatModes::round_to_even, offered.rounding_by_width);
  equalise(&FloatModes::keep_denormals, offered.denormals_by_width);
  return offered;
}

}  // namespace

struct SpirvModule::Types {
  struct Variable {
    uint32_t id, pointer, storage;
  };
  std::vector<Variable> variables;
  std::map<uint32_t, uint32_t> binding, pointee, element, constant;  // by id
  std::map<uint32_t, uint32_t> array_length;                         // the id of a constant
  std::map<uint32_t, std::vector<Member>> members;                   // of structs

  Member& member(uint32_t type, uint32_t index) {
    std::vector<Member>& all = members[type];
    if (all.size() <= index) all.resize(index + 1);
    return all[index];
  }
  void read(const std::vector<uint32_t>& words, const Instruction& i) {
    const uint32_t* operand = &words[i.at + 1];
    switch (i.op) {
      case op_member_name:
        member(operand[0], operand[1]).name = text_at(words, i.at + 3, i.at + i.length);
        break;
      case op_type_array:
        element[operand[0]] = operand[1], array_length[operand[0]] = operand[2];
        break;
      case op_type_pointer:
        pointee[operand[0]] = operand[2];
        break;
      case op_constant:
        constant[operand[1]] = operand[2];
        break;
      case op_variable:
        variables.push_back({operand[1], operand[0], operand[2]});
        break;
      case op_decorate:
        if (operand[1] == decoration_binding) binding[operand[0]] = operand[2];
        break;
      case op_member_decorate:
        if (operand[2] == decoration_offset) member(operand[0], operand[1]).offset = operand[3];
        break;
      default:
        break;
    }
  }
};

SpirvModule::SpirvModule(std::vector<uint32_t> words) : words_(std::move(words)) {
  Types types;
  for_each_instruction(words_, [&](const Instruction& i) { types.read(words_, i); });
  find_bindings(types);
}

void SpirvModule::find_bindings(const Types& types) {
  for (const auto& [id, pointer, storage] : types.variables) {
    const auto number = types.binding.find(id);
    if (number == types.binding.end()) continue;
    const uint32_t type = types.pointee.at(pointer);
    const auto length = types.array_length.find(type);
    const uint32_t count = length == types.array_length.end() ? 1 : types.constant.at(length->second);
    using Kind = SpirvBinding::Kind;
    const Kind kind = storage == storage_buffer    ? Kind::storage
                      : storage == storage_uniform ? Kind::uniform
                                                   : Kind::texels;
    SpirvBinding& binding = bindings_.try_emplace(number->second, SpirvBinding{kind, count}).first->second;
    if (binding.kind != kind) throw BackendError("vulkan: a SPIR-V module has two kinds of buffers in one binding");
    binding.count = std::max(binding.count, count);
    if (kind != Kind::uniform) continue;
    uniform_blocks_.push_back(type);
    if (const auto found = types.members.find(type); found != types.members.end())
      members_[number->second] = found->second;
  }
}

int SpirvModule::offset_of(uint32_t binding, const std::string& member) const {
  const auto block = members_.find(binding);
  if (block == members_.end()) return -1;
  const auto found = std::ranges::find(block->second, member, &Member::name);
  return found == block->second.end() ? -1 : int(found->offset);
}

void SpirvModule::read_uniforms_as_storage() {
  for_each_instruction(words_, [&](const Instruction& i) {
    if (i.op != op_decorate || words_[i.at + 2] != decoration_block) return;
    if (std::ranges::find(uniform_blocks_, words_[i.at + 1]) != uniform_blocks_.end())
      words_[i.at + 2] = decoration_buffer_block;
  });
  for (auto& [number, binding] : bindings_)
    if (binding.kind == SpirvBinding::Kind::uniform) binding.kind = SpirvBinding::Kind::uniform_as_storage;
}

// Capabilities come first in a module, then extensions; modes follow the entry point.
void SpirvModule::declare(const FloatControls& offered) {
  size_t behind_capabilities = header_words, behind_entry = 0;
  uint32_t entry = 0;
  bool uses_64 = false;
  for_each_instruction(words_, [&](const Instruction& i) {
    if (i.op == op_capability)
      behind_capabilities = i.at + i.length, uses_64 |= words_[i.at + 1] == capability_float_64;
    if (i.op == op_entry_point) behind_entry = i.at + i.length, entry = words_[i.at + 2];
  });
  const FloatControls used = with_equal_widths(offered, uses_64);
  std::vector<uint32_t> capabilities, declarations;
  for (const Mode& mode : modes) {
    const bool of_32 = used.of_32.*mode.offered, of_64 = uses_64 && used.of_64.*mode.offered;
    if (of_32 || of_64) capabilities.insert(capabilities.end(), {2u << 16 | op_capability, mode.capability});
    for (const uint32_t width : {32u, 64u})
      if (width == 32 ? of_32 : of_64)
        declarations.insert(declarations.end(), {4u << 16 | op_execution_mode, entry, mode.mode, width});
  }
  if (capabilities.empty()) return;
  const std::vector<uint32_t> extension = extension_words("SPV_KHR_float_controls");
  capabilities.insert(capabilities.end(), extension.begin(), extension.end());
  words_.insert(words_.begin() + ptrdiff_t(behind_entry), declarations.begin(), declarations.end());
  words_.insert(words_.begin() + ptrdiff_t(behind_capabilities), capabilities.begin(), capabilities.end());
}

void SpirvModule::unroll_loops() {
  constexpr size_t control = 3;  // the word after its two blocks
  for_each_instruction(words_, [&](const Instruction& one) {
    if (one.op == op_loop_merge && words_[one.at + control] == 0) words_[one.at + control] = loop_unrolled;
  });
}

}  // namespace spherepair
