#include <foredraw/gpu/queries.h>

namespace foredraw::gpu {

Queries::Queries(const Device& device, VkQueryType type, std::uint32_t count, VkQueryPipelineStatisticFlags statistics)
    : device_(device.get()), count_(count) {
  const VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO, nullptr, 0, type, count, statistics};
  pool_ = OwnedQueryPool(device_, info, "vkCreateQueryPool");
}

void Queries::read(std::uint32_t first, std::span<std::uint64_t> results, std::uint32_t numbers) const {
  check(vkGetQueryPoolResults(device_, get(), first, static_cast<std::uint32_t>(results.size()) / numbers,
                              results.size_bytes(), results.data(), numbers * sizeof(std::uint64_t),
                              VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "vkGetQueryPoolResults");
}

}  // namespace foredraw::gpu
