#include <foredraw/overdraw/part_lists.h>

#include <algorithm>
#include <numeric>

namespace foredraw {

namespace {

/// Lists as they come, equal ones several times.
class CollectedLists {
 public:
  explicit CollectedLists(std::uint32_t parts) { lists_.parts = parts; }

  void add(std::span<const std::uint32_t> list, std::int64_t weight) {
    lists_.layers.insert(lists_.layers.end(), list.begin(), list.end());
    lists_.first.push_back(static_cast<std::uint32_t>(lists_.layers.size()));
    lists_.weights.push_back(weight);
  }

  /// In the sequence of their parts, so that nothing hangs on where they came from.
  PartLists merged() const {
    std::vector<std::uint32_t> sorted(lists_.count());
    std::iota(sorted.begin(), sorted.end(), 0u);
    std::ranges::sort(sorted, [&](std::uint32_t a, std::uint32_t b) {
      return std::ranges::lexicographical_compare(lists_.list(a), lists_.list(b));
    });
    CollectedLists result(lists_.parts);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const auto list = lists_.list(sorted[i]);
      if (i > 0 && std::ranges::equal(list, lists_.list(sorted[i - 1]))) {
        result.lists_.weights.back() += lists_.weights[sorted[i]];
      } else {
        result.add(list, lists_.weights[sorted[i]]);
      }
    }
    return result.lists_;
  }

 private:
  PartLists lists_;
};

/// Makes lists of parts of the lists of owners.
class PartsInLists {
 public:
  PartsInLists(std::span<const std::uint32_t> part_of, std::uint32_t parts)
      : part_of_(part_of), seen_in_(parts, 0), collected_(parts) {}

  void add(const ViewLayers& view, std::int64_t weight) {
    for_each_batch(view, [&]<class Owner>(const LayerBatch& batch, const Owner* owners) {
      for (std::uint32_t i = 0; i < batch.lists; ++i, owners += batch.length) {
        list_.clear();
        ++number_;
        for (const Owner owner : std::span(owners, batch.length)) {
          if (owner >= tie_bit<Owner>) continue;
          const std::uint32_t part = part_of_[owner];
          if (seen_in_[part] == number_) continue;
          seen_in_[part] = number_;
          list_.push_back(part);
        }
        if (list_.size() > 1) collected_.add(list_, weight * batch.weight);
      }
    });
  }

  PartLists merged() const { return collected_.merged(); }

 private:
  std::span<const std::uint32_t> part_of_;
  std::vector<std::uint32_t> seen_in_;  // [part] the number of the list that had it last
  std::uint32_t number_ = 0;
  std::vector<std::uint32_t> list_;
  CollectedLists collected_;
};

}  // namespace

PartLists part_lists(const Layers& layers, std::span<const std::uint32_t> part_of, std::uint32_t parts,
                     std::span<const std::int64_t> weights) {
  PartsInLists collected(part_of, parts);
  for (std::size_t v = 0; v < layers.views.size(); ++v) {
    if (weights[v] != 0) collected.add(layers.views[v], weights[v]);
  }
  return collected.merged();
}

PartLists part_lists(const ViewLayers& view, std::span<const std::uint32_t> part_of, std::uint32_t parts) {
  PartsInLists collected(part_of, parts);
  collected.add(view, 1);
  return collected.merged();
}

PartLists joined(std::span<const PartLists> lists, std::span<const std::int64_t> weights) {
  CollectedLists collected(lists.empty() ? 0 : lists.front().parts);
  for (std::size_t i = 0; i < lists.size(); ++i) {
    for (std::size_t l = 0; weights[i] != 0 && l < lists[i].count(); ++l) {
      collected.add(lists[i].list(l), weights[i] * lists[i].weights[l]);
    }
  }
  return collected.merged();
}

std::int64_t fragments_shaded(const PartLists& lists, std::span<const std::uint32_t> sequence) {
  const std::vector<std::uint32_t> rank = inverse_of(sequence, lists.parts);
  std::int64_t shaded = 0;
  for (std::size_t l = 0; l < lists.count(); ++l) {
    std::uint32_t earliest = lists.parts;
    for (const std::uint32_t part : lists.list(l)) {
      if (rank[part] < earliest) shaded += lists.weights[l];
      earliest = std::min(earliest, rank[part]);
    }
  }
  return shaded;
}

}  // namespace foredraw
