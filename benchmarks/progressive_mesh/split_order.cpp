#include "split_order.h"

#include <foredraw/analysis/vertex_cache.h>

#include <algorithm>
#include <deque>
#include <set>

namespace foredraw::bench {

namespace {

class Orderer {
 public:
  explicit Orderer(const RefineRecords& records)
      : records_(records),
        cache_(records.point.size(), 16),
        users_(records.point.size()),
        dependents_(records.nodes.size() - 1),
        missing_(records.nodes.size() - 1) {
    for (std::uint32_t s = 0; s < missing_.size(); ++s) {
      for (const std::uint32_t v : corners(s)) users_[v].push_back(s);
      for (std::uint32_t i = records.nodes[s].first_need; i < records.nodes[s + 1].first_need; ++i) {
        dependents_[records.needs[i]].push_back(s);
        ++missing_[s];
      }
    }
  }

  void order(std::uint32_t begin, std::uint32_t end, std::vector<std::uint32_t>& splits) {
    end_ = end;
    for (std::uint32_t s = begin; s < end; ++s) {
      if (missing_[s] == 0) ready_.insert(s);
    }
    while (!ready_.empty()) {
      const std::uint32_t split = best();
      ready_.erase(split);
      splits.push_back(split);
      for (const std::uint32_t v : corners(split)) {
        if (cache_.misses(v)) recent_.push_back(v);
      }
      while (recent_.size() > 16) recent_.pop_front();
      for (const std::uint32_t later : dependents_[split]) {
        if (--missing_[later] == 0 && later < end_) ready_.insert(later);
      }
    }
  }

 private:
  std::span<const std::uint32_t> corners(std::uint32_t split) const {
    const auto& splits = records_.progressive.splits;
    return std::span(records_.progressive.indices)
        .subspan(std::size_t{3} * splits[split].triangles,
                 std::size_t{3} * (splits[split + 1].triangles - splits[split].triangles));
  }

  std::uint32_t best() const {
    std::uint32_t best = *ready_.begin();
    double fewest = 1e9;
    for (const std::uint32_t vertex : recent_) {
      for (const std::uint32_t s : users_[vertex]) {
        if (!ready_.contains(s)) continue;
        const std::set<std::uint32_t> needed(corners(s).begin(), corners(s).end());
        const auto lacks = std::ranges::count_if(needed, [&](std::uint32_t v) { return !cache_.holds(v); });
        const double cost = 3.0 * static_cast<double>(lacks) / static_cast<double>(corners(s).size());
        if (cost < fewest || (cost == fewest && s < best)) {
          fewest = cost;
          best = s;
        }
      }
    }
    return best;
  }

  const RefineRecords& records_;
  FifoCache cache_;
  std::vector<std::vector<std::uint32_t>> users_;       ///< [vertex] splits whose triangles have it
  std::vector<std::vector<std::uint32_t>> dependents_;  ///< [split]
  std::vector<std::uint32_t> missing_;                  ///< [split]
  std::set<std::uint32_t> ready_;                       ///< in the window
  std::deque<std::uint32_t> recent_;                    ///< vertices in the cache
  std::uint32_t end_ = 0;
};

}  // namespace

std::vector<std::uint32_t> window_ends(const RefineRecords& records, double window) {
  const auto& splits = records.progressive.splits;
  const auto count = static_cast<std::uint32_t>(splits.size() - 1);
  std::vector<std::uint32_t> ends;
  for (std::uint32_t begin = 0, end = 0; begin < count; begin = end) {
    end = begin + 1;
    while (end < count && splits[end].triangles <= window * splits[begin].triangles) ++end;
    ends.push_back(end);
  }
  return ends;
}

std::vector<std::uint32_t> splits_by_place(const RefineRecords& records, double window) {
  Orderer orderer(records);
  std::vector<std::uint32_t> order;
  for (const std::uint32_t end : window_ends(records, window)) {
    orderer.order(static_cast<std::uint32_t>(order.size()), end, order);
  }
  return order;
}

std::vector<std::uint32_t> indices_in(const RefineRecords& records, const std::vector<std::uint32_t>& splits) {
  const ProgressiveRecords& of = records.progressive;
  std::vector<std::uint32_t> indices(of.indices.begin(), of.indices.begin() + 3 * of.splits.front().triangles);
  for (const std::uint32_t s : splits) {
    indices.insert(indices.end(), of.indices.begin() + 3 * of.splits[s].triangles,
                   of.indices.begin() + 3 * of.splits[s + 1].triangles);
  }
  return indices;
}

}  // namespace foredraw::bench
