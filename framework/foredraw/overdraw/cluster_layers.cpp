#include <foredraw/overdraw/cluster_layers.h>

#include <foredraw/overdraw/private/layer_lists.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace foredraw {

namespace {

constexpr std::uint32_t tie = tie_bit<std::uint32_t>;

std::vector<std::uint32_t> clusters_of_triangles(const Clusters& clusters, std::size_t triangles) {
  std::vector<std::uint32_t> result(triangles);
  for (std::uint32_t c = 0; c < clusters.count(); ++c) {
    std::fill(result.begin() + clusters.offsets[c], result.begin() + clusters.offsets[c + 1], c);
  }
  return result;
}

/// Turns lists of triangles into lists of clusters, of one view.
class ClusterLists {
 public:
  ClusterLists(std::span<const std::uint32_t> cluster_of, std::size_t clusters, const OverdrawCount& always)
      : cluster_of_(cluster_of), earliest_(clusters, none), always_(always) {}

  template <class Owner>
  void add(std::span<const Owner> triangles, std::uint32_t weight) {
    list_.clear();
    std::size_t depths = 0;
    for (std::size_t begin = 0; begin < triangles.size();) {
      std::size_t end = begin + 1;
      while (end < triangles.size() && triangles[end] >= tie_bit<Owner>) ++end;
      const std::size_t before = list_.size();
      for (std::size_t i = begin; i < end; ++i) keep_unless_hidden(triangle(triangles[i]), list_.size() > before);
      // Only now: what is equally near hides nothing, it makes ties.
      for (std::size_t i = begin; i < end; ++i) see(triangle(triangles[i]));
      if (list_.size() > before) ++depths;
      begin = end;
    }
    for (const Owner owner : triangles) earliest_[cluster_of_[triangle(owner)]] = none;
    const bool is_one_cluster = std::ranges::all_of(list_, [&](std::uint32_t c) { return (c & ~tie) == list_[0]; });
    if (is_one_cluster) {
      always_.shaded += weight * depths;
      always_.ties += weight * (list_.size() - depths);
    } else {
      lists_.add(list_, weight);
    }
  }

  ViewLayers laid_out() && { return std::move(lists_).laid_out(earliest_.size(), always_); }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  template <class Owner>
  static std::uint32_t triangle(Owner owner) {
    return owner & static_cast<Owner>(~tie_bit<Owner>);
  }

  void keep_unless_hidden(std::uint32_t triangle, bool is_tied) {
    const std::uint32_t cluster = cluster_of_[triangle];
    if (earliest_[cluster] > triangle) list_.push_back(is_tied ? cluster | tie : cluster);
  }

  void see(std::uint32_t triangle) {
    std::uint32_t& earliest = earliest_[cluster_of_[triangle]];
    earliest = std::min(earliest, triangle);
  }

  std::span<const std::uint32_t> cluster_of_;
  std::vector<std::uint32_t> earliest_;  // [cluster] of its nearer triangles in this pixel the one drawn first
  std::vector<std::uint32_t> list_;
  LayerLists lists_;
  OverdrawCount always_;
};

}  // namespace

ClusterLayers cluster_layers(const FragmentLayers& layers, const Clusters& clusters, const Executor& executor) {
  if (!is_partition(clusters, layers.owners)) {
    throw std::invalid_argument("cluster_layers: the clusters are not a partition of the layers' " +
                                std::to_string(layers.owners) + " triangles; offsets rise from 0 to that number");
  }
  const std::vector<std::uint32_t> cluster_of = clusters_of_triangles(clusters, layers.owners);
  ClusterLayers result;
  result.owners = clusters.count();
  result.views.resize(layers.views.size());
  executor.for_each(layers.views.size(), [&](std::size_t view) {
    ClusterLists lists(cluster_of, clusters.count(), layers.views[view].always);
    for_each_batch(layers.views[view], [&](const LayerBatch& batch, const auto* list) {
      for (std::uint32_t i = 0; i < batch.lists; ++i, list += batch.length) {
        lists.add(std::span(list, batch.length), batch.weight);
      }
    });
    result.views[view] = std::move(lists).laid_out();
  });
  return result;
}

}  // namespace foredraw
