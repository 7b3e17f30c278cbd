#include "occlusions.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace foredraw {

namespace {

/// Occlusions of one draw while they are collected.
class Collected {
 public:
  void add_pair(std::uint32_t piece, std::uint32_t other, std::int64_t net) { pairs_.push_back({piece, other, net}); }

  void add(std::span<const std::uint32_t> list, std::int64_t weight) {
    if (std::ranges::all_of(list, [&](std::uint32_t piece) { return piece == list[0]; })) return;
    if (list.size() == 2) return add_pair(list[0], list[1], weight);
    lists_.push_back({static_cast<std::uint32_t>(layers_.size()), static_cast<std::uint32_t>(list.size()), weight});
    layers_.insert(layers_.end(), list.begin(), list.end());
  }

  Occlusions laid_out(std::uint32_t pieces) && {
    result_.pieces = pieces;
    lay_out_pairs();
    lay_out_lists();
    find_members();
    return std::move(result_);
  }

 private:
  struct Pair {
    std::uint32_t piece, other;
    std::int64_t net;
  };
  struct List {
    std::uint32_t first, length;  // in layers_
    std::int64_t weight;
  };

  void lay_out_pairs() {
    // Both ways round, so that a row holds all that a piece has to do with.
    std::vector<std::uint32_t> end(result_.pieces + 1, 0);
    for (const Pair& pair : pairs_) ++end[pair.piece + 1], ++end[pair.other + 1];
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<Occlusions::Pair> rows(2 * pairs_.size());
    for (const Pair& pair : pairs_) {
      rows[end[pair.piece]++] = {pair.other, pair.net};
      rows[end[pair.other]++] = {pair.piece, -pair.net};
    }
    std::vector<std::int64_t> net(result_.pieces, 0);
    result_.first_pair = {0};
    for (std::uint32_t piece = 0, i = 0; piece < result_.pieces; ++piece) {
      const std::uint32_t first = i;
      for (; i < end[piece]; ++i) net[rows[i].other] += rows[i].net;
      for (std::uint32_t j = first; j < i; ++j) {
        const std::int64_t sum = std::exchange(net[rows[j].other], 0);
        if (sum != 0) result_.pairs.push_back({rows[j].other, sum});
      }
      result_.first_pair.push_back(static_cast<std::uint32_t>(result_.pairs.size()));
    }
    pairs_ = {};
  }

  std::span<const std::uint32_t> entries_of(const List& list) const {
    return {layers_.data() + list.first, list.length};
  }

  /// Equal lists become one.
  void lay_out_lists() {
    std::ranges::sort(lists_, [&](const List& a, const List& b) {
      return std::ranges::lexicographical_compare(entries_of(a), entries_of(b));
    });
    result_.first_layer = {0};
    for (std::size_t i = 0; i < lists_.size(); ++i) {
      const auto entries = entries_of(lists_[i]);
      if (i > 0 && std::ranges::equal(entries, entries_of(lists_[i - 1]))) {
        result_.weights.back() += lists_[i].weight;
        continue;
      }
      result_.layers.insert(result_.layers.end(), entries.begin(), entries.end());
      result_.first_layer.push_back(static_cast<std::uint32_t>(result_.layers.size()));
      result_.weights.push_back(lists_[i].weight);
    }
    lists_ = {};
    layers_ = {};
  }

  void find_members() {
    std::vector<std::uint32_t>& first = result_.first_list;
    first.assign(result_.pieces + 2, 0);
    for_each_member([&](std::uint32_t, std::uint32_t piece) { ++first[piece + 2]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    result_.lists.resize(first.back());
    for_each_member([&](std::uint32_t list, std::uint32_t piece) { result_.lists[first[piece + 1]++] = list; });
    first.pop_back();
  }

  /// Each piece of a list once.
  template <class Visit>
  void for_each_member(Visit visit) const {
    for (std::uint32_t list = 0; list < result_.weights.size(); ++list) {
      const auto begin = result_.layers.begin() + result_.first_layer[list];
      const auto end = result_.layers.begin() + result_.first_layer[list + 1];
      for (auto piece = begin; piece != end; ++piece) {
        if (std::find(begin, piece, *piece) == piece) visit(list, *piece);
      }
    }
  }

  std::vector<Pair> pairs_;
  std::vector<List> lists_;
  std::vector<std::uint32_t> layers_;
  Occlusions result_;
};

}  // namespace

std::vector<Occlusions> occlusions_of(std::span<const WeightedLayers> views, std::span<const LayerOwner> owners,
                                      std::span<const std::uint32_t> pieces) {
  std::vector<Collected> draws(pieces.size());
  std::vector<std::uint32_t> list;
  for (const WeightedLayers& view : views) {
    for_each_batch(*view.layers, [&]<class Owner>(const LayerBatch& batch, const Owner* layers) {
      const std::int64_t weight = view.weight * batch.weight;
      for (std::uint32_t i = 0; i < batch.lists; ++i, layers += batch.length) {
        list.clear();
        const LayerOwner* last = nullptr;
        for (std::uint32_t layer = 0; layer < batch.length; ++layer) {
          if (layers[layer] >= tie_bit<Owner>) continue;
          const LayerOwner& owner = owners[layers[layer]];
          if (last != nullptr && owner.part > last->part) continue;
          if (last != nullptr && owner.part < last->part) {
            draws[last->draw].add(list, weight);
            list.clear();
          }
          last = &owner;
          list.push_back(owner.piece);
        }
        if (last != nullptr) draws[last->draw].add(list, weight);
      }
    });
  }
  std::vector<Occlusions> result;
  for (std::size_t d = 0; d < draws.size(); ++d) result.push_back(std::move(draws[d]).laid_out(pieces[d]));
  return result;
}

Occlusions with_joined_pieces(const Occlusions& old, std::span<const std::uint32_t> joined) {
  Collected collected;
  for (std::uint32_t piece = 0; piece < old.pieces; ++piece) {
    for (std::uint32_t i = old.first_pair[piece]; i < old.first_pair[piece + 1]; ++i) {
      const auto& [other, net] = old.pairs[i];
      if (piece < other && joined[piece] != joined[other]) collected.add_pair(joined[piece], joined[other], net);
    }
  }
  std::vector<std::uint32_t> earliest(joined.back() + 1, ~std::uint32_t{0});  // of the old pieces that are nearer
  std::vector<std::uint32_t> list;
  for (std::size_t l = 0; l < old.weights.size(); ++l) {
    const std::span layers(&old.layers[old.first_layer[l]], old.first_layer[l + 1] - old.first_layer[l]);
    list.clear();
    for (const std::uint32_t piece : layers) {
      if (piece > earliest[joined[piece]]) continue;
      earliest[joined[piece]] = piece;
      list.push_back(joined[piece]);
    }
    for (const std::uint32_t piece : list) earliest[piece] = ~std::uint32_t{0};
    collected.add(list, old.weights[l]);
  }
  return std::move(collected).laid_out(joined.back() + 1);
}

}  // namespace foredraw
