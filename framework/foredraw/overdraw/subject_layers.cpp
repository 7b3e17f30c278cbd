#include <foredraw/overdraw/subject_layers.h>

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

std::vector<OverdrawCount> counts_of(const SubjectLayers& subject, std::span<const std::vector<std::uint32_t>> atoms) {
  std::vector<std::uint32_t> order;
  order.reserve(subject.owners.size());
  for (std::size_t first = 0; first < subject.owners.size();) {
    const std::vector<std::uint32_t>& sequence = atoms[subject.owners[first].draw];
    for (const std::uint32_t atom : sequence) order.push_back(static_cast<std::uint32_t>(first) + atom);
    first += sequence.size();
  }
  return count_overdraw_by_view(subject.layers, order);
}

ViewTally tally_of(const SubjectLayers& subject, std::span<const OverdrawCount> counts) {
  ViewTally tally;
  for (std::size_t look = 0; look < counts.size(); ++look) tally.add(counts[look], subject.weights[look]);
  return tally;
}

}  // namespace foredraw
