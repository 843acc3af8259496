// SPDX-License-Identifier: MIT
#include "api/exchange.h"

#include <fmt/format.h>

namespace spherepair {
namespace {

DeviceCopy through_host(Device& from, Device& to, uint64_t bytes) {
  Device& with_memory = from.info().name == "cuda" ? from : to;
  return [&from, &to, bytes, host = with_memory.host_memory(bytes)](const Memory& source, const Memory& target) {
    from.read(source, host.get(), 0, bytes);
    to.write(target, host.get(), 0, bytes);
    to.wait();
  };
}

DevicePositions& device_positions(Backend& backend) {
  if (DevicePositions* positions = backend.device_positions()) return *positions;
  throw BackendError(backend.info().name + ": has no buffer of a GPU's API; exchange opengl, vulkan or cuda");
}

}  // namespace

Exchange::Exchange(Backend& from, Backend& to, Transfer way) : from_(from), to_(to), bytes_(common_bytes()) {
  if (way == Transfer::registered)
    throw BackendError(
        fmt::format("exchange: {} and {} map no buffers of each other; transfer spheres as host or imported",
                    from.info().name, to.info().name));
  const auto open = way == Transfer::host ? through_host : open_device_copy;
  copy_ = open(*from.device(), *to.device(), bytes_);
}

uint64_t Exchange::common_bytes() const {
  const uint64_t from = device_positions(from_).positions().bytes, to = device_positions(to_).positions().bytes;
  if (from == to) return from;
  throw BackendError(fmt::format("exchange: {} holds {} spheres but {} {}; upload as many to both", from_.info().name,
                                 from / sizeof(vec4), to_.info().name, to / sizeof(vec4)));
}

void Exchange::run() {
  if (common_bytes() != bytes_) throw BackendError("exchange: the number of spheres has changed; make a new exchange");
  copy_(device_positions(from_).positions(), device_positions(to_).positions());
  device_positions(to_).positions_changed();
}

}  // namespace spherepair
