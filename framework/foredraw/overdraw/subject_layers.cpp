#include <foredraw/overdraw/subject_layers.h>

#include <foredraw/viewing/view_directions.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>

namespace foredraw {

std::vector<std::vector<std::uint32_t>> as_it_came(const SubjectLayers& subject) {
  std::vector<std::vector<std::uint32_t>> order;
  for (const AtomicDraw& draw : subject.draws) {
    order.emplace_back(draw.atoms.count());
    std::iota(order.back().begin(), order.back().end(), 0u);
  }
  return order;
}

std::vector<OverdrawCount> counts_of(const SubjectLayers& subject, std::span<const std::vector<std::uint32_t>> atoms,
                                     std::span<const std::uint32_t> sequence) {
  constexpr std::uint32_t nobody = ~std::uint32_t{0};
  std::vector<std::uint32_t> first_owner(subject.owners.empty() ? 0 : subject.owners.back().part + 1, nobody);
  for (std::uint32_t owner = 0; owner < subject.owners.size(); ++owner) {
    std::uint32_t& first = first_owner[subject.owners[owner].part];
    first = std::min(first, owner);
  }
  std::vector<std::uint32_t> order;
  order.reserve(subject.owners.size());
  const auto draw_part = [&](std::uint32_t part) {
    if (part >= first_owner.size() || first_owner[part] == nobody) return;
    const std::uint32_t first = first_owner[part];
    for (const std::uint32_t atom : atoms[subject.owners[first].draw]) order.push_back(first + atom);
  };
  for (std::uint32_t part = 0; sequence.empty() && part < first_owner.size(); ++part) draw_part(part);
  for (const std::uint32_t part : sequence) draw_part(part);
  return count_overdraw_by_view(subject.layers, order);
}

std::vector<LayerOwner> owners_in(const SubjectLayers& subject, std::span<const std::uint32_t> sequence) {
  std::vector<LayerOwner> owners = subject.owners;
  if (sequence.empty()) return owners;
  std::vector<std::uint32_t> ranks(sequence.size());
  for (std::uint32_t rank = 0; rank < sequence.size(); ++rank) ranks[sequence[rank]] = rank;
  for (LayerOwner& owner : owners) owner.part = ranks[owner.part];
  return owners;
}

std::vector<std::uint8_t> parted_by_direction(const SubjectLayers& subject, std::size_t k, std::uint64_t seed) {
  const Directions middles = turned_at_random(fibonacci_directions(k), seed);
  std::vector<std::uint8_t> group;
  for (const glm::dvec3& direction : subject.directions) {
    std::size_t nearest = 0;
    for (std::size_t j = 1; j < k; ++j) {
      if (glm::dot(middles[j], direction) > glm::dot(middles[nearest], direction)) nearest = j;
    }
    group.push_back(static_cast<std::uint8_t>(nearest));
  }
  return group;
}

ViewTally tally_of(const SubjectLayers& subject, std::span<const OverdrawCount> counts) {
  ViewTally tally;
  for (std::size_t look = 0; look < counts.size(); ++look) tally.add(counts[look], subject.weights[look]);
  return tally;
}

}  // namespace foredraw
