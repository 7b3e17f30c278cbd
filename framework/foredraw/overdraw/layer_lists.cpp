#include <foredraw/overdraw/private/layer_lists.h>

#include <algorithm>
#include <tuple>

namespace foredraw {

void LayerLists::add(std::span<const std::uint32_t> list, std::uint32_t weight) {
  // Neighbours in a picture are often alike.
  if (!lists_.empty() && std::ranges::equal(entries_of(lists_.back()), list)) {
    lists_.back().weight += weight;
    return;
  }
  const bool has_ties = std::ranges::any_of(list, [](std::uint32_t entry) { return entry >= tie_bit<std::uint32_t>; });
  lists_.push_back({std::uint64_t{list[0]} << 32 | list[1], entries_.size(), static_cast<std::uint32_t>(list.size()),
                    weight, has_ties});
  entries_.insert(entries_.end(), list.begin(), list.end());
}

std::span<const std::uint32_t> LayerLists::entries_of(const List& list) const {
  return {entries_.data() + list.first, list.length};
}

void LayerLists::merge_equal() {
  const auto key = [](const List& list) { return std::tie(list.length, list.front); };
  std::sort(lists_.begin(), lists_.end(), [&](const List& a, const List& b) {
    if (key(a) != key(b)) return key(a) < key(b);
    return std::ranges::lexicographical_compare(entries_of(a), entries_of(b));
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < lists_.size(); ++i) {
    if (kept > 0 && key(lists_[kept - 1]) == key(lists_[i]) &&
        std::ranges::equal(entries_of(lists_[kept - 1]), entries_of(lists_[i]))) {
      lists_[kept - 1].weight += lists_[i].weight;
    } else {
      lists_[kept++] = lists_[i];
    }
  }
  lists_.resize(kept);
}

ViewLayers LayerLists::laid_out(std::size_t owners, const OverdrawCount& always) && {
  merge_equal();
  const auto batch = [](const List& list) { return std::tie(list.length, list.has_ties, list.weight); };
  std::stable_sort(lists_.begin(), lists_.end(), [&](const List& a, const List& b) { return batch(a) < batch(b); });
  ViewLayers result;
  result.always = always;
  std::size_t length = 0;
  for (std::size_t i = 0; i < lists_.size(); ++i) {
    const List& list = lists_[i];
    if (i == 0 || batch(lists_[i - 1]) != batch(list)) {
      result.batches.push_back({list.length, list.weight, 0, list.has_ties});
    }
    ++result.batches.back().lists;
    length += list.length;
  }
  const auto fill = [&]<class Owner>(std::vector<Owner> of) {
    of.reserve(length);
    for (const List& list : lists_) {
      for (const std::uint32_t entry : entries_of(list)) {
        const bool is_tied = entry >= tie_bit<std::uint32_t>;
        const auto owner = static_cast<Owner>(entry & ~tie_bit<std::uint32_t>);
        of.push_back(is_tied ? static_cast<Owner>(owner | tie_bit<Owner>) : owner);
      }
    }
    result.owners = std::move(of);
  };
  if (owners <= tie_bit<std::uint16_t>) {
    fill(std::vector<std::uint16_t>());
  } else {
    fill(std::vector<std::uint32_t>());
  }
  return result;
}

}  // namespace foredraw
