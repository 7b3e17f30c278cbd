#include "slot_cuts.h"

#include <algorithm>
#include <limits>

namespace foredraw::processors::merge_instances {

namespace {

constexpr std::uint64_t farthest = 24;           ///< triangles that a cut may move
constexpr std::uint64_t most_looks = 4'000'000;  ///< triangles looked at, about

/// Counts different vertices.
class Different {
 public:
  explicit Different(std::size_t vertices) : seen_(vertices, 0) {}

  void begin() { ++now_; }
  /// How many of a triangle's vertices are new since begin().
  std::uint32_t add(const std::uint32_t* corners) {
    std::uint32_t fresh = 0;
    for (int corner = 0; corner < 3; ++corner) {
      std::uint32_t& seen = seen_[corners[corner]];
      fresh += seen != now_;
      seen = now_;
    }
    return fresh;
  }

 private:
  std::vector<std::uint32_t> seen_;
  std::uint32_t now_ = 0;
};

}  // namespace

SlotCuts cut_evenly(std::span<const std::uint32_t> indices, std::size_t vertices, std::uint32_t frequency) {
  SlotCuts cuts;
  if (indices.size() < 3) return cuts;
  Different different(vertices);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    if (i % frequency == 0) {
      cuts.first.push_back(static_cast<std::uint32_t>(i));
      different.begin();
    }
    cuts.fetched += different.add(&indices[i]);
  }
  cuts.first.push_back(static_cast<std::uint32_t>(indices.size() / 3 * 3));
  cuts.fetched_plain = cuts.fetched;
  return cuts;
}

SlotCuts cut_slots(std::span<const std::uint32_t> indices, std::size_t vertices, std::uint32_t frequency) {
  SlotCuts even = cut_evenly(indices, vertices, frequency);
  const std::uint64_t triangles = indices.size() / 3;
  const std::uint64_t in_slot = frequency / 3;
  const std::uint64_t slots = even.slots();
  if (slots < 2) return even;
  const std::uint64_t padding = slots * in_slot - triangles;  // in triangles; less than a slot
  const std::uint64_t move = std::min({padding, farthest, most_looks / triangles});
  if (move == 0) return even;

  // Cut k lies `early` triangles in front of k full slots, and early never falls from one cut to the next, as no slot
  // holds more than its share. least[early]: the vertices of all slots up to the cut.
  constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
  Different different(vertices);
  std::vector<std::uint64_t> least(move + 1, none), next;
  std::vector<std::vector<std::uint8_t>> came_from(slots);  // [cut][early] that of the cut before
  least[0] = 0;
  for (std::uint64_t k = 1; k <= slots; ++k) {
    const bool is_last = k == slots;
    next.assign(move + 1, none);
    came_from[k - 1].assign(move + 1, 0);
    for (std::uint64_t before = 0; before <= move; ++before) {
      if (least[before] == none) continue;
      const std::uint64_t begin = (k - 1) * in_slot - before;
      const std::uint64_t end = is_last ? triangles : begin + in_slot;
      const std::uint64_t first_end = is_last ? triangles : k * in_slot - move;
      different.begin();
      std::uint64_t vertices_here = 0;
      for (std::uint64_t t = begin; t < end; ++t) {
        vertices_here += different.add(&indices[3 * t]);
        if (t + 1 < first_end) continue;
        const std::uint64_t early = is_last ? 0 : k * in_slot - (t + 1);
        if (least[before] + vertices_here >= next[early]) continue;
        next[early] = least[before] + vertices_here;
        came_from[k - 1][early] = static_cast<std::uint8_t>(before);
      }
    }
    least = next;
  }
  if (least[0] >= even.fetched) return even;  // of equals, full slots

  SlotCuts cuts;
  cuts.fetched = least[0];
  cuts.fetched_plain = even.fetched;
  cuts.first.assign(slots + 1, 0);
  cuts.first[slots] = static_cast<std::uint32_t>(3 * triangles);
  std::uint64_t early = came_from[slots - 1][0];
  for (std::uint64_t k = slots - 1; k > 0; --k) {
    cuts.first[k] = static_cast<std::uint32_t>(3 * (k * in_slot - early));
    early = came_from[k - 1][early];
  }
  return cuts;
}

}  // namespace foredraw::processors::merge_instances
