// SPDX-License-Identifier: MIT
#include "common/backend/device_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace spherepair {
namespace {

constexpr size_t uuid_digits = 32;

bool is_hex(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); }

}  // namespace

DeviceName::DeviceName(const std::string& text) {
  if (text.empty()) return;
  uint value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && text.size() < uuid_digits) {
    number = value;
    return;
  }
  std::string digits = text.starts_with("GPU-") ? text.substr(4) : text;
  std::erase(digits, '-');
  std::ranges::transform(digits, digits.begin(), [](char c) { return c >= 'A' && c <= 'F' ? char(c - 'A' + 'a') : c; });
  if (digits.size() != uuid_digits || !std::ranges::all_of(digits, is_hex))
    throw std::invalid_argument(
        fmt::format("'{}' is no GPU: give a number counted from 0, or a UUID as nvidia-smi -L prints it", text));
  uuid = digits;
}

}  // namespace spherepair
