// SPDX-License-Identifier: MIT
#include "vulkan/stage_queries.h"

#include <utility>

namespace spherepair {

StageQueries::StageQueries(const LogicalDevice& device) : device_(device) {
  auto info = typed<VkQueryPoolCreateInfo>(VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO);
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = 2 * most_stages;
  vulkan_check(device.calls().CreateQueryPool(device.handle(), &info, nullptr, &pool_), "making timestamp queries");
}

StageQueries::~StageQueries() { device_.calls().DestroyQueryPool(device_.handle(), pool_, nullptr); }

// Records a timestamp that is taken after all earlier commands, so that stages that overlap are timed from end to end.
void StageQueries::stamp(VkCommandBuffer commands, uint32_t query) const {
  device_.calls().CmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, pool_, query);
}

void StageQueries::collect() {
  if (stages_.empty()) return;
  std::vector<uint64_t> stamps(2 * stages_.size());
  vulkan_check(device_.calls().GetQueryPoolResults(device_.handle(), pool_, 0, uint32_t(stamps.size()),
                                                   stamps.size() * sizeof(uint64_t), stamps.data(), sizeof(uint64_t),
                                                   VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
               "reading timestamps");
  const uint32_t bits = device_.limits().timestamp_bits;
  const uint64_t mask = bits < 64 ? (uint64_t(1) << bits) - 1 : ~uint64_t(0);
  const double seconds = double(device_.limits().properties.limits.timestampPeriod) * 1e-9;  // of a tick
  for (size_t k = 0; k < stages_.size(); ++k)
    times_.push_back({stages_[k], double((stamps[2 * k + 1] - stamps[2 * k]) & mask) * seconds});
  stages_.clear();
}

std::vector<StageTime> StageQueries::take() { return std::exchange(times_, {}); }

}  // namespace spherepair
