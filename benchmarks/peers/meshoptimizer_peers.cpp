#include "peers.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

namespace foredraw {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The peer gives new index buffers; we want orders. Equal triangles are taken in the order in which they come.
IndexOrder order_of(std::span<const std::uint32_t> old, std::span<const std::uint32_t> reordered) {
  std::map<Triangle, std::vector<std::uint32_t>> left;
  for (std::size_t t = old.size() / 3; t-- > 0;) {
    left[{old[3 * t], old[3 * t + 1], old[3 * t + 2]}].push_back(static_cast<std::uint32_t>(t));
  }
  IndexOrder order;
  for (std::size_t t = 0; t < reordered.size() / 3; ++t) {
    auto& same = left[{reordered[3 * t], reordered[3 * t + 1], reordered[3 * t + 2]}];
    if (same.empty()) throw std::runtime_error("the peer returned other triangles than it was given");
    order.push_back(same.back());
    same.pop_back();
  }
  return order;
}

struct CacheOptions {
  int cache_size = 16;
};

class MeshoptVertexCacheFifo final : public DrawOrderer {
 public:
  explicit MeshoptVertexCacheFifo(CacheOptions options) : options_(options) {}
  IndexOrder order(const DrawView& draw, Run&) const override {
    std::vector<std::uint32_t> result(draw.indices().size());
    meshopt_optimizeVertexCacheFifo(result.data(), draw.indices().data(), result.size(), draw.vertex_count(),
                                    static_cast<unsigned>(options_.cache_size));
    return order_of(draw.indices(), result);
  }
  int cache_size() const override { return options_.cache_size; }

 private:
  CacheOptions options_;
};

class MeshoptVertexCache final : public DrawOrderer {
 public:
  IndexOrder order(const DrawView& draw, Run&) const override {
    std::vector<std::uint32_t> result(draw.indices().size());
    meshopt_optimizeVertexCache(result.data(), draw.indices().data(), result.size(), draw.vertex_count());
    return order_of(draw.indices(), result);
  }
};

struct OverdrawOptions {
  double threshold = 1.05;
};

class MeshoptOverdraw final : public DrawOrderer {
 public:
  explicit MeshoptOverdraw(OverdrawOptions options) : options_(options) {}
  IndexOrder order(const DrawView& draw, Run& run) const override {
    const auto positions = positions_of(run.analyses, draw.vertices());
    std::vector<std::uint32_t> result(draw.indices().size());
    meshopt_optimizeOverdraw(result.data(), draw.indices().data(), result.size(),
                             reinterpret_cast<const float*>(positions->values.data()), positions->values.size(),
                             sizeof(glm::vec3), static_cast<float>(options_.threshold));
    return order_of(draw.indices(), result);
  }

 private:
  OverdrawOptions options_;
};

Plugin peer(std::string name, std::string summary, Trait provides) {
  Plugin plugin;
  plugin.card = {.name = std::move(name),
                 .summary = std::move(summary),
                 .reference = "meshoptimizer, as packaged",
                 .acts_on = {traits::triangles},
                 .provides = {provides},
                 .breaks = {traits::fetch_ordered, traits::clustered}};
  return plugin;
}

struct NoOptions {};

}  // namespace

void add_peers(Registry& registry) {
  Plugin cache = peer("meshopt-vertex-cache", "meshopt_optimizeVertexCache", traits::cache_ordered);
  bind_options(cache, OptionTable<NoOptions>(),
               [](const NoOptions&) { return std::make_unique<MeshoptVertexCache>(); });
  registry.add(std::move(cache));

  Plugin fifo = peer("meshopt-vertex-cache-fifo", "meshopt_optimizeVertexCacheFifo", traits::cache_ordered);
  OptionTable<CacheOptions> cache_options;
  cache_options.row(&CacheOptions::cache_size, "cache-size", "Size of the FIFO vertex cache", {3, 1024, "entries"});
  bind_options(fifo, cache_options, [](const CacheOptions& o) { return std::make_unique<MeshoptVertexCacheFifo>(o); });
  registry.add(std::move(fifo));

  Plugin overdraw = peer("meshopt-overdraw", "meshopt_optimizeOverdraw", traits::overdraw_ordered);
  OptionTable<OverdrawOptions> overdraw_options;
  overdraw_options.row(&OverdrawOptions::threshold, "threshold",
                       "Highest ACMR allowed, as a multiple of that of the order that comes in", {1, 3, "times"});
  bind_options(overdraw, overdraw_options,
               [](const OverdrawOptions& o) { return std::make_unique<MeshoptOverdraw>(o); });
  registry.add(std::move(overdraw));
}

}  // namespace foredraw
