#include <foredraw/c/checked_input.h>

using namespace foredraw::c;

int foredraw_order_of_clusters(uint32_t* order, const uint32_t* offsets, uint32_t cluster_count,
                               const uint32_t* sequence) {
  return guarded([&]() -> int {
    if (cluster_count == 0) return FOREDRAW_DONE;
    if (order == nullptr || offsets == nullptr || sequence == nullptr) return FOREDRAW_NULL_POINTER;
    if (const int status = offsets_status({offsets, std::size_t{cluster_count} + 1}); status != FOREDRAW_DONE) {
      return status;
    }
    const std::span<const std::uint32_t> clusters(sequence, cluster_count);
    if (const int status = order_status(clusters, cluster_count); status != FOREDRAW_DONE) return status;
    for (const std::uint32_t cluster : clusters) {
      for (std::uint32_t t = offsets[cluster]; t < offsets[cluster + 1]; ++t) *order++ = t;
    }
    return FOREDRAW_DONE;
  });
}
